//! Matrix Lie groups over `f64` and over intervals.
//!
//! Every group of this crate is written once, generic over its scalar: over `f64` the operations are accurate to a few
//! units in the last place at every scale of the rotation angle, over [`scalars::Interval`] they are enclosures.
//!
//! # Groups
//! | group | type | tangent coordinates |
//! |---|---|---|
//! | rotations of the plane, of space | [`SO2`], [`SO3`] | `theta`; `w` |
//! | scalings | [`RPlus`] | `s`, the log-scale |
//! | both | [`ScaledSO2`], [`ScaledSO3`] | `theta, s`; `w, s` |
//! | SE(2), SE(3) | [`SE2`], [`SE3`] | `theta, x`; `w, x` |
//! | SE_2(2), SE_2(3), SE_K(d) | [`SE22`], [`SE23`], [`SEK2`], [`SEK3`] | `theta, x, v, ..`; `w, x, v, ..` |
//! | Sim(2), Sim(3) | [`Sim2`], [`Sim3`] | `theta, s, x`; `w, s, x` |
//! | two frames, lever arm | [`TfgLever2`], [`TfgLever3`] | `theta, x, l`; `w, x, l` |
//! | two frames, scale and lever arm | [`TfgScaleLever2`], [`TfgScaleLever3`] | `theta, s, x, l`; `w, s, x, l` |
//! | vectors under addition | [`Rn`] | `x` |
//! | direct products | [`Prod`], [`ImperfectSE2`] | those of the first, then of the second factor |
//!
//! All but [`SE2`] in the middle of the table are names of one type, [`TwoFrame`]: a [`FrameGroup`] with vectors fixed in space and vectors fixed in the
//! body. Another frame group, or another number of vectors, is one line.
//!
//! **Reading order:** [`LieGroup`] (what a group can do), `se2.rs` (one group written out), `two_frame.rs` (all others), `frame_group.rs`, `so3.rs`,
//! then `coeff/`, where the digits are.
//!
//! Beside the operations: [`mean`], [`LieGroup::interpolate`], conversions from and to nalgebra's isometries and unit quaternions, and
//! [`check_group_affine`], [`check_compatible_output`], [`check_autonomous`], which tell whether a model suits an invariant filter.
//!
//! # Conventions
//! - **Tangent order:** rotation, log-scale, fixed-frame vectors, body-frame vectors: `xi = (theta, x1, x2)` on SE(2),
//!   `(theta, s, x1, x2, l1, l2)` on [`TfgScaleLever2`]. Angles are radians.
//! - **exp** maps a tangent vector to the group, `exp(xi) = expm(hat(xi))`; **log** is its principal inverse.
//! - **Adjoint:** `X exp(xi) X^-1 = exp(Ad_X xi)`; `ad_xi` is its derivative, `Ad_exp(xi) = expm(ad_xi)`, `ad_xi eta = [xi, eta]`.
//! - **Left Jacobian:** `exp(xi + d) = exp(Jl(xi) d) exp(xi)` to first order in `d`; `Jl(xi) = sum_j ad_xi^j / (j + 1)!`.
//! - **Right Jacobian:** `exp(xi + d) = exp(xi) exp(Jr(xi) d)` to first order; `Jr(xi) = Jl(-xi)`.
//! - **Action:** `X . p` is affine in the point `p`; `act_linear` is its linear part.
//!
//! # What the answers mean
//! | scalar | an element stands for | results |
//! |---|---|---|
//! | `f64` | one element, rounded | rounded, not for bounds |
//! | `Interval` | every element with an angle in an arc (in space: a rotation in a [`SpinSet`]) and vectors in boxes | supersets of the exact image of the set |
//!
//! Over `f64` relative errors stay below 2e-15 for rotations and log-scales from 1e-12 to 3 (exp, log, Jacobians and their inverses, adjoints,
//! tested against the matrix exponential in double-double). Products of rotations stay on the circle, or the sphere of unit quaternions, however many there are.
//! Over intervals, turns of the plane and of space do not wrap: radii add.
//!
//! NaN and infinities pass through the operations that return a value (over intervals: the entire line) and are a
//! [`GroupError`] in those that return a `Result`.
//!
//! ```
//! use lie_groups::{LieGroup, SE2};
//! use nalgebra::{Vector2, Vector3};
//!
//! // Drive along an arc: turn by 90 degrees while moving pi/2 ahead; the circle has radius 1.
//! let quarter = std::f64::consts::FRAC_PI_2;
//! let pose = SE2::exp(&Vector3::new(quarter, quarter, 0.0));
//! assert!((pose.act(&Vector2::zeros()) - Vector2::new(1.0, 1.0)).norm() < 1e-15);
//! assert!((pose.log()? - Vector3::new(quarter, quarter, 0.0)).norm() < 1e-15);
//! # Ok::<(), lie_groups::GroupError>(())
//! ```

mod checks;
mod coeff;
mod complex;
mod convert;
mod enclose;
mod error;
mod frame_group;
mod lie_group;
mod mean;
mod named;
mod prod;
mod r_plus;
mod rn;
mod scaled_so2;
mod scaled_so3;
mod se2;
mod small;
mod so2;
mod so3;
mod triples;
mod turn;
mod two_frame;

pub use checks::{ErrorKind, check_autonomous, check_compatible_output, check_group_affine};
pub use coeff::{BothSigns, Coeff, ScaledCoeff, ScaledMaps, SpaceCoeff, SpinSet};
pub use complex::Complex;
pub use enclose::Enclose;
pub use error::GroupError;
pub use frame_group::{FrameGroup, JacobianParts, WithMaps};
pub use lie_group::LieGroup;
pub use mean::mean;
pub use named::{SE3, SE22, SE23, SEK2, SEK3, Sim2, Sim3, TfgLever2, TfgLever3, TfgScaleLever2, TfgScaleLever3};
pub use prod::{ImperfectSE2, Prod};
pub use r_plus::RPlus;
pub use rn::Rn;
pub use scaled_so2::ScaledSO2;
pub use scaled_so3::{ScaledInverseSlopes, ScaledSO3, ScaledSlopes};
pub use se2::SE2;
pub use so2::SO2;
pub use so3::{SO3, SpinInverseSlopes, SpinSlopes};
pub use turn::Turn;
pub use two_frame::TwoFrame;
