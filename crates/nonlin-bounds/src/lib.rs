//! Ranges, derivatives and images of sets under nonlinear functions, remainders and rounding included.
//!
//! A [`Function`] is written once, generic over [`scalars::Scalar`]; [`DynFunction`] is its object-safe twin, which every
//! enclosure of this crate takes.

mod affine;
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
mod workspace;

pub use affine::{AffineEnclosure, Domain, Form};
pub use derivative::{Decorated, Dual, Second};
pub use error::{BoundError, Operand};
pub use expansion::Expansion;
pub use function::{DynFunction, Function, Order};
pub use image::{GeneratorSet, affine_image, polytopic_image};
pub use jet::Jet;
pub use quadratic::{Copies, QuadraticEnclosure};
pub use smoothness::Smoothness;
pub use solution::{Rows, polytopic_solution, polytopic_solution_lift};
pub use workspace::Workspace;
