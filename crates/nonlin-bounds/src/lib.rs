//! Ranges, derivatives and images of sets under nonlinear functions, remainders and rounding included.
//!
//! A [`Function`] is written once, generic over [`scalars::Scalar`]; [`DynFunction`] is its object-safe twin, which every
//! enclosure of this crate takes.
//!
//! A [`Tape`] is a function recorded as data: it can be run backwards and printed. [`ForwardBackward`] and [`IntervalNewton`] shrink boxes
//! around the solutions of `f(x, p) in Y`.

mod affine;
mod contract;
mod derivative;
mod error;
mod expanded;
mod expansion;
mod function;
mod image;
mod jet;
mod quadratic;
mod smoothness;
mod solution;
mod tape;
mod workspace;

pub use affine::{AffineEnclosure, Domain, Form};
pub use contract::{Conflict, Contraction, ForwardBackward, IntervalNewton};
pub use derivative::{Decorated, Dual, Second};
pub use error::{BoundError, Operand};
pub use expansion::Expansion;
pub use function::{DynFunction, Function, Order};
pub use image::{GeneratorSet, affine_image, polytopic_image};
pub use jet::Jet;
pub use quadratic::{Copies, QuadraticEnclosure};
pub use smoothness::Smoothness;
pub use solution::{Rows, polytopic_solution, polytopic_solution_lift};
pub use tape::Tape;
pub use workspace::Workspace;
