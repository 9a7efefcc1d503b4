//! Ranges, derivatives and images of sets under nonlinear functions, remainders and rounding included.
//!
//! A [`Function`] is written once, generic over [`scalars::Scalar`]; [`DynFunction`] is its object-safe twin, which every
//! enclosure of this crate takes.

mod affine;
mod error;
mod function;
mod jet;
mod smoothness;
mod workspace;

pub use affine::{AffineEnclosure, Domain, Form};
pub use error::{BoundError, Operand};
pub use function::{DynFunction, Function, Order};
pub use jet::Jet;
pub use smoothness::Smoothness;
pub use workspace::Workspace;
