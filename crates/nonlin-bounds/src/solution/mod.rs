//! Solution sets, `{ x in X : g(x, p) in Y }`; one method a file.

mod affine;
mod polytopic;
mod polytopic_lift;

pub use affine::Rows;
pub use polytopic::polytopic_solution;
pub use polytopic_lift::polytopic_solution_lift;
