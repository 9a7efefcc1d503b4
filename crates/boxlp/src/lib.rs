//! Linear programs over a box.
mod bound;
mod certificate;
mod dual_simplex;
mod error;
mod problem;
mod ratio_test;
mod rounding;
mod solver;
mod tableau;

pub use bound::Multiplier;
pub use certificate::Certificate;
pub use error::LpError;
pub use problem::Problem;
pub use solver::{Solution, Solver, Status};
