//! Proof that a set is not empty: a point with a radius within which an exactly feasible point exists.

use core::cmp::Ordering;

use crate::exact::compare_dot;
use crate::problem::Problem;
use crate::rounding::dot_enclosure;
use crate::tableau::Tableau;
use crate::workspace::Workspace;

/// Grids to which a vertex is rounded in search of an exact solution: integers, and numbers of few binary digits.
const GRIDS: [f64; 3] = [1.0, 1.0 / 4096.0, 1.0 / 16_777_216.0];

/// Coordinates this near to a bound of the box are tried on it.
const NEAR: f64 = 1e-12;

/// An exactly feasible point `x` exists with `|x - point|_max <= radius`.
///
/// The radius is 0 if the point itself was proven feasible; it is of rounding size if rows of (nearly) zero width, which
/// no floating-point number need satisfy, were solved by a fixed-point argument.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Witness {
    pub(crate) point: Vec<f64>,
    pub(crate) radius: f64,
}

impl Witness {
    /// Centre of the ball.
    #[must_use]
    pub fn point(&self) -> &[f64] {
        &self.point
    }

    /// Radius of the ball in the maximum norm.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }
}

impl Witness {
    /// Tries to prove the set non-empty near the vertex of `tableau`, whose point `workspace` has read.
    ///
    /// The vertex itself, or its rounding to a coarser grid, may satisfy every row in real arithmetic. If not, the rows that the
    /// vertex stands on are solved exactly by a fixed-point argument: in all basic coordinates, or in those off the bounds of
    /// the box.
    pub(crate) fn prove(&mut self, problem: &Problem, tableau: &Tableau<f64>, workspace: &mut Workspace) -> bool {
        let Workspace { point: vertex, fixed_point, .. } = workspace;
        self.radius = 0.0;
        self.set(vertex, |x| x);
        if self.is_member(problem) {
            return true;
        }
        for grid in GRIDS {
            // Adding 3/2 2^52 grids leaves no digits below the grid.
            let shift = 6_755_399_441_055_744.0 * grid;
            self.set(vertex, |x| (x + shift) - shift);
            if self.is_member(problem) {
                return true;
            }
        }
        self.set(vertex, |x| x);
        let mut radius = fixed_point.prove(problem, tableau, &self.point, |_| true);
        if radius.is_none() && vertex.iter().any(|x| x.abs() > 1.0 - NEAR) {
            self.set(vertex, |x| if x.abs() > 1.0 - NEAR { x.signum() } else { x });
            radius = fixed_point.prove(problem, tableau, &self.point, |x| x.abs() < 1.0);
        }
        self.radius = radius.unwrap_or(0.0);
        radius.is_some()
    }

    fn set(&mut self, vertex: &[f64], change: impl Fn(f64) -> f64) {
        self.point.clear();
        self.point.extend(vertex.iter().map(|&x| change(x)));
    }

    fn is_member(&self, problem: &Problem) -> bool {
        (0..problem.rows()).all(|i| holds(problem, i, &self.point))
    }
}

/// Whether row `i` holds at `point` in real arithmetic.
pub(crate) fn holds(problem: &Problem, i: usize, point: &[f64]) -> bool {
    let (row, (lower, upper)) = (problem.row(i), problem.range(i));
    let (low, high) = dot_enclosure(0.0, row, point);
    if high < lower || low > upper {
        return false;
    }
    lower <= low && high <= upper
        || compare_dot(row, point, lower) != Ordering::Less && compare_dot(row, point, upper) != Ordering::Greater
}
