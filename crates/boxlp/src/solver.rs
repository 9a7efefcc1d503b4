//! The solver: a problem, its tableau, and the answers.

use crate::bound::Multiplier;
use crate::certificate::Certificate;
use crate::dual_simplex::{Ending, Workspace};
use crate::problem::Problem;
use crate::tableau::Tableau;
use crate::LpError;

/// A gap above this share of `|c|_1` makes the solver rebuild a tableau that has seen exchanges, once per solve.
const GAP: f64 = 1e-11;

/// A row's activity may differ by this from its value in the tableau (rows have 1-norms in [1/2, 1)).
const DRIFT: f64 = 1e-10;

/// Exchanges between two comparisons of the tableau with the data.
const CHECK_EVERY: usize = 64;

/// Solves `max c'x` over `{ x : lower <= A x <= upper, |x_j| <= 1 }` for one objective after another.
///
/// It owns the problem and all scratch: keep one and [`load`](Self::load) the next problem into it; a solve then allocates
/// nothing. Each solve starts from the basis of the last one, and rows can be appended and dropped between solves.
///
/// **Guarantee:** every [`Solution::bound`] is an upper bound of the exact maximum, whatever rounding did to the pivots.
///
/// ```
/// use boxlp::{Problem, Solver, Status};
/// let mut problem = Problem::new(2)?;
/// problem.push_row(&[1.0, 2.0], 0.5, 0.5)?;
/// let mut solver = Solver::new(problem);
/// let solution = solver.maximize(&[0.0, 1.0])?;
/// assert_eq!(solution.status, Status::Optimal);
/// assert_eq!(solution.point, &[-1.0, 0.75]);
/// assert!(solution.bound >= 0.75 && solution.gap() < 1e-14);
/// # Ok::<(), boxlp::LpError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Solver {
    problem: Problem,
    tableau: Tableau,
    workspace: Workspace,
    /// The tableau does not belong to the problem yet.
    stale: bool,
    /// Proof that the present problem is empty, once found.
    empty: bool,
    certificate: Certificate,
    unchecked: usize,
    pivot_limit: Option<usize>,
}

/// What a solve ended with; the bound is proven in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The point is a vertex of the set and optimal, to working accuracy.
    Optimal,
    /// The set is proven empty: see [`Solver::certificate`]. Value and bound are minus infinity.
    Empty,
    /// Stopped at the pivot limit or in numerical doubt: the point need not satisfy the rows, the bound may be loose.
    Stopped,
}

/// Answer to one objective.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Solution<'a> {
    /// What the numbers mean.
    pub status: Status,
    /// `c'x` at the point, with plain rounding: an approximation of the maximum.
    pub value: f64,
    /// Proven upper bound of the maximum, at most `|c|_1` (rounded up).
    pub bound: f64,
    /// The point `x`, always in the box; it satisfies the rows to working accuracy if the status is `Optimal`.
    pub point: &'a [f64],
    /// The multipliers that prove the bound, by [`Problem::upper_bound`]; or the set empty, as a [`Certificate`].
    pub multipliers: &'a [Multiplier],
    /// Exchanges made.
    pub pivots: usize,
}

impl Solution<'_> {
    /// `bound - value`: how much tighter the bound could be at most, up to rounding of the value (0 for an empty set).
    #[must_use]
    pub fn gap(&self) -> f64 {
        if self.status == Status::Empty { 0.0 } else { self.bound - self.value }
    }
}

impl Solver {
    /// A solver of `problem`.
    #[must_use]
    pub fn new(problem: Problem) -> Self {
        Self {
            problem,
            tableau: Tableau::default(),
            workspace: Workspace::default(),
            stale: true,
            empty: false,
            certificate: Certificate::default(),
            unchecked: 0,
            pivot_limit: None,
        }
    }

    /// The problem being solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Maximises `c'x`.
    ///
    /// Method: dual simplex with bound flips from the last basis; the multipliers are read off the reduced costs and give
    /// the bound by weak duality ([`Problem::upper_bound`]). Should the gap or the rows show that the tableau has drifted, it
    /// is rebuilt from the data, once.
    ///
    /// **Guarantee:** `max c'x <= bound` in real arithmetic; [`Status::Empty`] only if the set is proven empty. The minimum
    /// of `c'x` is at least minus the bound for `-c`.
    ///
    /// # Errors
    /// [`LpError::Length`], [`LpError::Objective`] or [`LpError::ObjectiveOverflow`].
    pub fn maximize(&mut self, objective: &[f64]) -> Result<Solution<'_>, LpError> {
        let norm = self.problem.check_objective(objective)?;
        Ok(self.solve(objective, norm))
    }

    fn solve(&mut self, objective: &[f64], norm: f64) -> Solution<'_> {
        self.workspace.pivots = 0;
        let limit = self.pivot_limit.unwrap_or(1000 + 50 * (self.problem.variables() + self.problem.rows()));
        self.prepare();
        let mut rebuilt = self.tableau.age == 0;
        let (status, value, bound) = loop {
            if self.empty {
                break (Status::Empty, f64::NEG_INFINITY, f64::NEG_INFINITY);
            }
            self.tableau.price(objective);
            self.tableau.place();
            let before = self.workspace.pivots;
            let ending = self.workspace.run(&self.problem, &mut self.tableau, limit, true);
            self.unchecked += self.workspace.pivots - before;
            if ending == Ending::Empty {
                self.empty = true;
                self.certificate.multipliers.clone_from(&self.workspace.multipliers);
                continue;
            }
            self.workspace.read(&self.problem, &self.tableau);
            let Workspace { multipliers, residual, point, .. } = &mut self.workspace;
            let bound = self.problem.weak_duality(objective, norm, multipliers, residual);
            let value: f64 = objective.iter().zip(&*point).map(|(c, x)| c * x).sum();
            let sound = ending == Ending::Optimal && bound - value <= GAP * norm && !self.has_drifted();
            if sound || rebuilt || ending == Ending::Limit {
                let status = if ending == Ending::Optimal { Status::Optimal } else { Status::Stopped };
                break (status, value, bound);
            }
            rebuilt = true;
            self.tableau.rebuild(&self.problem);
            self.unchecked = 0;
        };
        let Workspace { multipliers, point, pivots, .. } = &self.workspace;
        let multipliers = if self.empty { &self.certificate.multipliers } else { multipliers };
        Solution { status, value, bound, point, multipliers, pivots: *pivots }
    }

    fn prepare(&mut self) {
        if self.stale {
            self.tableau.build(&self.problem);
            self.workspace.resize(&self.problem);
            self.stale = false;
            self.empty = false;
            self.unchecked = 0;
        }
    }

    /// Compares the rows' activities at the point with their values in the tableau, every so many exchanges.
    fn has_drifted(&mut self) -> bool {
        if self.unchecked < CHECK_EVERY {
            return false;
        }
        self.unchecked = 0;
        self.tableau.drift(&self.problem, &self.workspace.point) > DRIFT
    }
}
