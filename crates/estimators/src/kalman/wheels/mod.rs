//! Invariant Kalman filters of a wheeled robot whose wheel radius and antenna are not known.
//!
//! The robot turns by `Omega` (gyro) and moves by `s U` in its own frame (wheels, whose radius is off by the factor `s`); a satellite
//! receiver at `X` in that frame gives its place:
//!
//! ```text
//! R+ = R Omega exp(n_theta)    x+ = x + s R (U + n_U)    s+ = s    X+ = X        y = x + R X + v
//! ```
//!
//! | problem | unknown | error of which the motion is a function of itself | here |
//! |---|---|---|---|
//! | 1 | `R, x` | on SE(2) | [`InvariantWheels`] on `SE2` |
//! | 2 | `R, x, X` | on the two-frame group with a lever arm | [`InvariantWheels`] on `TfgLever2` |
//! | 3 | `R, s, x, X` | on the two-frame group with scale, of `X' = X / s` | [`TwoFrameError`], or [`InvariantWheels`] on `TfgScaleLever2` |
//!
//! Problem 3 comes with three errors, each a chart of the same states ([`WheelState`]) for the same model ([`Wheels`]):
//! [`PlainError`] (the extended Kalman filter), [`ImperfectError`] (the imperfect invariant filter: SE(2), and plain differences for what
//! does not fit) and [`TwoFrameError`] (the filter of paper 002). Coordinates are in one order for all: heading, scale, position,
//! lever arm. [`InvariantWheels`] is the same model on the groups themselves, with the left- or the right-invariant error.
//!
//! The paper's innovation is `Z = D^-1 (y - yhat)` with `D` the [frame](WheelError::frame) of the error; a filter that uses `y - yhat`
//! with `D H` is the same filter, and that is what is done.
//!
//! **Source:** paper 002. Where it is misprinted, the code follows what was derived and tested:
//! - (28), second brace: what stands there is `E^s E^R E^X = -(E^-1)^X`, not `E^X`; equal to first order, so `H` is not concerned.
//! - (30): the updated error is `E^X - ((E^g)^-1 L_g) * L_X'`; the paper has a plus sign and the inverse of `L_g`.
//! - VI-A, second bullet: the position moves by `s R e_x`, as in (29); the paper's `R e_x` lacks the scale.
//! - The error is a function of itself only without gyro noise: that noise moves `E^X` by `(J Xhat / shat) n_theta`.
//!
//! ```
//! use estimators::Estimator;
//! use estimators::kalman::wheels::{TfgIekf, TwoFrameError, WheelError, WheelState, WheelStep, Wheels};
//! use nalgebra::{Matrix2, Matrix3, Vector2, Vector6};
//!
//! // Nothing is known of the heading, the wheels to 50 %, the antenna to 1 m.
//! let guess = WheelState::new(0.0, 1.0, Vector2::zeros(), Vector2::zeros());
//! let deviations = Vector6::new(3.0, 0.5, 1.0, 1.0, 1.0, 1.0); // rad, 1, m, m
//! let start = TwoFrameError::belief(guess, &deviations)?;
//! let (q, r) = (Matrix3::identity() * 1e-6, Matrix2::identity() * 0.01);
//! let mut filter = TfgIekf::new(Wheels, start, &q, &r)?;
//! filter.predict(&WheelStep::new(0.1, Vector2::new(0.5, 0.0)))?; // turn in rad, way in units of the wheels
//! filter.update(&[0.2, 0.4])?;
//! assert!(filter.belief().mean().scale > 0.0);
//! # Ok::<(), estimators::EstimatorError>(())
//! ```

mod imperfect;
mod invariant;
mod model;
mod plain;
mod state;
mod two_frame;

pub use imperfect::ImperfectError;
pub use invariant::{Drivable, InvariantWheels};
pub use model::{ImperfectIekf, TfgIekf, WheelEkf, WheelError, Wheels};
pub use plain::PlainError;
pub use state::{WheelState, WheelStep};
pub use two_frame::TwoFrameError;
