//! Ranges, derivatives and images of sets under nonlinear functions, remainders and rounding included.
//!
//! A [`Function`] is written once, generic over [`scalars::Scalar`] (or in two lines, by [`function!`]); [`DynFunction`] is its object-safe
//! twin, which every enclosure of this crate takes: a [`Jet`] of value, Jacobian and Hessians over a box, with the [`Smoothness`] that
//! the evaluation has proven there.
//!
//! ```
//! use nonlin_bounds::{DynFunction, Jet, Order, Rk4, Smoothness, function};
//! use scalars::Interval;
//!
//! // A pendulum, and its discrete model by one Runge-Kutta step; the step is the last parameter.
//! let pendulum = function!(|[angle, rate]: 2| -> 2 { [rate, angle.sin() * S::decimal("-9.81")] });
//! let model = Rk4::new(pendulum)?;
//!
//! let x = [Interval::new(0.9, 1.1)?, Interval::new(-0.1, 0.1)?];
//! let mut jet = Jet::new();
//! model.enclose(Order::Hessian, &x, &[Interval::decimal("0.01")], &mut jet)?;
//! assert_eq!(jet.smoothness(), [Smoothness::C2; 2]);
//! assert!(jet.values()[0].width() < 0.21 && (jet.jacobian()[1].mid() - 0.01).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! In reading order: `function`, `jet`, `smoothness` are the contract; `derivative` has the dual numbers and the passes that fill a jet;
//! `compose` and `integrators` make functions of functions, [`Flow`] a proven step of a differential equation; `expansion`, `affine`
//! and `quadratic` enclose a function by simpler ones, `image` and `solution` carry sets through.
//!
//! A [`Tape`] is a function recorded as data: it can be run backwards and printed. [`ForwardBackward`] and [`IntervalNewton`] shrink boxes
//! around the solutions of `f(x, p) in Y`.
//!
//! [`range`] bounds the outputs over a box by any [`RangeMethod`]; [`Expansion`] names the points that functions are expanded about.
//! [`decomposition_image`], [`decomposition_solution`] and [`dc_image`] enclose images and solution sets without fixing one expansion.
//!
//! An [`AffineEnclosure`] holds a function between parallel affine functions on a box, by the mean value theorem, slopes or Taylor's
//! theorem; images of zonotopes and constrained zonotopes, and rows that solutions fulfil, are then linear. [`affine_image`] and
//! [`affine_solution`] do it in one call. A [`QuadraticEnclosure`] keeps the quadratic term as a set of its own.
//!
//! [`polytopic_image`] and [`polytopic_solution`] go from vertex to vertex of a polytope ([`polytopic_image_with_noise`] and [`polytopic_strips`]
//! with boxes of noise), [`polytopic_solution_lift`] over the weights of its vertices. Which enclosure to take for which function is in the repository's `docs/IMAGES.md`, with measured tightness and cost.

mod affine;
mod buffer;
mod compose;
mod contract;
mod decomposition;
mod derivative;
mod directional;
mod error;
mod expanded;
mod expansion;
mod function;
mod image;
mod integrators;
mod jet;
mod linear;
mod macros;
mod parallelotope;
mod quadratic;
mod range;
mod signs;
mod smoothness;
mod solution;
mod structured;
mod tape;
mod workspace;

pub use affine::{AffineEnclosure, Domain, Form};
pub use compose::{Stack, Then, stack, then};
pub use contract::{Conflict, Contraction, ForwardBackward, IntervalNewton};
pub use derivative::{Decorated, Dual, Second};
pub use error::{BoundError, Operand};
pub use expansion::Expansion;
pub use function::{DynFunction, Function, Order};
pub use image::{
    ConvexSplit, GeneratorSet, affine_image, dc_image, dc_image_of_zonotope, decomposition_image,
    decomposition_image_of_zonotope, decomposition_images_of_zonotope, polytopic_image, polytopic_image_with_noise,
};
pub use integrators::{Euler, Flow, Heun, Rk4};
pub use jet::Jet;
pub use linear::Linear;
pub use quadratic::{Copies, QuadraticEnclosure};
pub use range::{RangeMethod, range};
pub use scalars;
pub use smoothness::Smoothness;
pub use solution::{
    OutputStrip, PolytopicCut, Rows, affine_solution, decomposition_solution, polytopic_solution,
    polytopic_solution_lift, polytopic_strips,
};
pub use structured::Structured;
pub use tape::Tape;
pub use workspace::Workspace;
