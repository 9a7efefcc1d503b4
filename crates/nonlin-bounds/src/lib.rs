//! Ranges, derivatives and images of sets under nonlinear functions, remainders and rounding included.
//!
//! A [`Function`] is written once, generic over [`scalars::Scalar`]; [`DynFunction`] is its object-safe twin, which every
//! enclosure of this crate takes.
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

mod affine;
mod contract;
mod decomposition;
mod derivative;
mod directional;
mod error;
mod expanded;
mod expansion;
mod function;
mod image;
mod jet;
mod parallelotope;
mod quadratic;
mod range;
mod signs;
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
pub use image::{
    ConvexSplit, GeneratorSet, affine_image, dc_image, dc_image_of_zonotope, decomposition_image,
    decomposition_image_of_zonotope, polytopic_image,
};
pub use jet::Jet;
pub use quadratic::{Copies, QuadraticEnclosure};
pub use range::{RangeMethod, range};
pub use smoothness::Smoothness;
pub use solution::{Rows, affine_solution, decomposition_solution, polytopic_solution, polytopic_solution_lift};
pub use tape::Tape;
pub use workspace::Workspace;
