//! Solution sets, `{ x in X : g(x, p) in Y }`; one method a file.
//!
//! Rows of an [`AffineEnclosure`](crate::AffineEnclosure) cut constrained zonotopes without slack generators, and are strips for
//! zonotopes; they hold for every solution in the box that they were made on. So one may enclose again on the smaller hull that the
//! rows leave, cut the first set with the rows of the last pass, and come back until the hull stops shrinking.

mod affine;
mod decomposition;
mod polytopic;
mod polytopic_lift;
mod strip;

pub use affine::{Rows, affine_solution};
pub use decomposition::decomposition_solution;
pub use polytopic::{PolytopicCut, polytopic_solution, polytopic_strips};
pub use polytopic_lift::polytopic_solution_lift;
pub use strip::OutputStrip;
