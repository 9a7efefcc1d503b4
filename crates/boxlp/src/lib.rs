//! Linear programs over a box, with proven answers.
//!
//! `max c'x` over `{ x : lower_i <= A_i x <= upper_i, |x_j| <= 1 }`, dense, for one objective after another: the problem
//! behind the support function, the interval hull and the emptiness of a constrained zonotope.
//!
//! - Every answer carries an upper bound of the exact maximum, from weak duality with outward rounding. No pivot is
//!   trusted: a wrong one costs tightness, never validity. A pivot limit gives a looser bound, at worst `|c|_1`.
//! - Emptiness is proven by a [`Certificate`] that can be checked against the data, disproven by a [`Witness`], or not
//!   claimed.
//! - All variables and all rows are boxed, so every basis is dual feasible: there is no phase 1, and each objective starts
//!   from the basis of the last. Tall problems (few variables, many rows) and wide ones cost a tableau of rows x variables.
//! - Where entries span so many decades, or rows are so nearly dependent, that 16 digits do not suffice, the same method goes
//!   on with 32.
//! - A solve allocates nothing (but for the first that needs 32 digits). The crate depends on nothing.
//!
//! ```
//! use boxlp::{Problem, Solver};
//! // The interval hull of { x : x_0 + x_1 + x_2 = 2, x_0 - x_1 in [0, 1/2], |x_j| <= 1 }.
//! let mut problem = Problem::new(3)?;
//! problem.push_row(&[1.0, 1.0, 1.0], 2.0, 2.0)?;
//! problem.push_row(&[1.0, -1.0, 0.0], 0.0, 0.5)?;
//! let mut solver = Solver::new(problem);
//! let mut hull = Vec::new();
//! for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
//!     let upper = solver.maximize(&axis)?.bound;
//!     let lower = -solver.maximize(&axis.map(|c| -c))?.bound;
//!     hull.push((lower, upper));
//! }
//! assert!(hull[0].0 <= 0.5 && 0.5 - hull[0].0 < 1e-14);
//! assert!(hull[1].0 <= 0.25 && 0.25 - hull[1].0 < 1e-14);
//! # Ok::<(), boxlp::LpError>(())
//! ```

mod double_double;
mod error;
mod exact;
mod real;
mod rounding;

mod problem;

mod bound;
mod certificate;

mod dual_simplex;
mod ratio_test;
mod tableau;
mod workspace;

mod dependence;
mod fixed_point;
mod witness;

mod answer;
mod solver;

pub use answer::{Emptiness, Solution, Status};
pub use bound::Multiplier;
pub use certificate::Certificate;
pub use error::LpError;
pub use problem::Problem;
pub use solver::Solver;
pub use witness::Witness;
