//! The solver: a problem and its tableau, one objective after another.

use crate::LpError;
use crate::answer::{Emptiness, Solution, Status};
use crate::dual_simplex::{Ending, FEASIBILITY, Rules};
use crate::problem::Problem;
use crate::rounding::UNDERFLOW;
use crate::tableau::Tableau;
use crate::witness::Witness;
use crate::workspace::Workspace;

/// A gap above this share of `|c|_1` makes the solver rebuild a tableau that has seen exchanges, once a solve.
const GAP: f64 = 1e-11;

/// A gap above this share of `|c|_1` on a rebuilt tableau is numerical doubt.
const WIDE_GAP: f64 = 1e-6;

/// Violations forgiven when nothing else helps.
const CAUTION: f64 = 1e-7;

/// A row's activity may differ by this from its value in the tableau (rows have 1-norms in [1/2, 1)).
const DRIFT: f64 = 1e-10;

/// Exchanges between two comparisons of the tableau with the data.
const CHECK_EVERY: usize = 64;

/// How far a witness is sought inside the set, in this order: a deep point survives the rounding of its proof.
const MARGINS: [f64; 2] = [1e-7, 1e-10];

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
    witness: Witness,
    /// The tableau does not belong to the problem yet.
    stale: bool,
    /// The ranges of the problem have changed.
    moved: bool,
    /// The problem has been proven empty.
    empty: bool,
    /// Scratch of [`Solver::retain_rows`].
    keep: Vec<bool>,
    /// Exchanges since the tableau was last compared with the data.
    unchecked: usize,
    pivot_limit: Option<usize>,
}

impl Solver {
    /// A solver of `problem`.
    #[must_use]
    pub fn new(problem: Problem) -> Self {
        Self {
            problem,
            tableau: Tableau::default(),
            workspace: Workspace::default(),
            witness: Witness::default(),
            stale: true,
            moved: false,
            empty: false,
            keep: Vec::new(),
            unchecked: 0,
            pivot_limit: None,
        }
    }

    /// The problem being solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Turns to another problem: copies it, allocating nothing within capacity.
    pub fn load(&mut self, problem: &Problem) {
        self.problem.assign(problem);
        self.stale = true;
    }

    /// Turns to the problem of [`Problem::from_columns`], allocating nothing within capacity.
    ///
    /// # Errors
    /// Those of [`Problem::from_columns`]; the problem is then a box without rows.
    pub fn load_columns(
        &mut self,
        variables: usize,
        columns: &[f64],
        lower: &[f64],
        upper: &[f64],
    ) -> Result<(), LpError> {
        self.stale = true;
        self.problem.assign_columns(variables, columns, lower, upper)
    }

    /// Limits the exchanges of one solve, at which it ends as [`Status::Stopped`] with a looser bound.
    ///
    /// `None` is the default: a solve ends by itself, after at most about `18 (n + m + 10)` exchanges, of which it needs few.
    pub fn set_pivot_limit(&mut self, limit: Option<usize>) {
        self.pivot_limit = limit;
    }

    /// Appends the row `lower <= row x <= upper`, keeping the basis, and returns its index.
    ///
    /// # Errors
    /// Those of [`Problem::push_row`]; nothing changes then.
    pub fn push_row(&mut self, row: &[f64], lower: f64, upper: f64) -> Result<usize, LpError> {
        let index = self.problem.push_row(row, lower, upper)?;
        if !self.stale {
            self.tableau.append_row(&self.problem);
        }
        Ok(index)
    }

    /// Replaces the range of row `row`, keeping the basis.
    ///
    /// # Errors
    /// Those of [`Problem::set_range`]; nothing changes then.
    pub fn set_range(&mut self, row: usize, lower: f64, upper: f64) -> Result<(), LpError> {
        self.problem.set_range(row, lower, upper)?;
        self.moved = true;
        self.empty = false;
        Ok(())
    }

    /// Keeps the first `rows` rows, and what of the basis does not depend on the others.
    pub fn truncate_rows(&mut self, rows: usize) {
        self.retain_rows(|i| i < rows);
    }

    /// Keeps the rows for whose index `keep` says `true`, in their order, and what of the basis does not depend on the others.
    pub fn retain_rows(&mut self, keep: impl FnMut(usize) -> bool) {
        self.keep.clear();
        self.keep.extend((0..self.problem.rows()).map(keep));
        self.problem.retain_rows(|i| self.keep[i]);
        self.empty = false;
        self.stale = self.stale || !self.tableau.retain_rows(&self.keep);
    }

    /// Maximises `c'x`.
    ///
    /// Method: dual simplex with bound flips from the last basis; the multipliers are read off the reduced costs and give
    /// the bound by weak duality ([`Problem::upper_bound`]). Should the gap or the rows show that the tableau has drifted,
    /// it is rebuilt from the data, once.
    ///
    /// **Guarantee:** `max c'x <= bound` in real arithmetic; [`Status::Empty`] only if the set is proven empty. The minimum
    /// of `c'x` is at least minus the bound for `-c`.
    ///
    /// # Errors
    /// [`LpError::Length`], [`LpError::Objective`] or [`LpError::ObjectiveOverflow`].
    pub fn maximize(&mut self, objective: &[f64]) -> Result<Solution<'_>, LpError> {
        let norm = self.problem.check_objective(objective)?;
        self.prepare();
        let (status, value, bound) = self.solve(objective, norm);
        let Workspace { certificate, multipliers, point, pivots, .. } = &self.workspace;
        let multipliers = if self.empty { certificate.multipliers() } else { multipliers };
        Ok(Solution { status, value, bound, point, multipliers, pivots: *pivots })
    }

    /// Decides whether the set is empty, with a proof either way.
    ///
    /// Method: the dual simplex for `c = 0` ends with a contradiction, of which a [`Certificate`](crate::Certificate) is made, or with a vertex.
    /// There, or near a vertex of the set with all bounds moved inward a little, a [`Witness`] is proven: by exact arithmetic at
    /// the point, or by a fixed-point argument around it. Rows that are exact combinations of others count with these.
    ///
    /// **Guarantee:** `Empty` and `NonEmpty` hold in real arithmetic.
    ///
    /// ```
    /// use boxlp::{Emptiness, Problem, Solver};
    /// let mut problem = Problem::new(2)?;
    /// problem.push_row(&[0.1, 0.3], 0.2, 0.2)?;
    /// let mut solver = Solver::new(problem);
    /// assert!(matches!(solver.emptiness(), Emptiness::NonEmpty(witness) if witness.radius() < 1e-15));
    /// solver.push_row(&[0.2, 0.6], 0.5, f64::INFINITY)?;
    /// let problem = solver.problem().clone();
    /// assert!(matches!(solver.emptiness(), Emptiness::Empty(certificate) if certificate.verify(&problem)));
    /// # Ok::<(), boxlp::LpError>(())
    /// ```
    pub fn emptiness(&mut self) -> Emptiness<'_> {
        self.prepare();
        let zeros = core::mem::take(&mut self.workspace.zeros);
        self.solve(&zeros, 0.0);
        let proven = !self.empty && self.find_witness(&zeros);
        self.workspace.zeros = zeros;
        match (self.empty, proven) {
            (true, _) => Emptiness::Empty(&self.workspace.certificate),
            (false, true) => Emptiness::NonEmpty(&self.witness),
            (false, false) => Emptiness::Undecided,
        }
    }

    fn find_witness(&mut self, zeros: &[f64]) -> bool {
        if self.witness.prove(&self.problem, &self.tableau, &mut self.workspace) {
            return true;
        }
        let limit = self.pivot_limit.unwrap_or(usize::MAX);
        let rules = Rules { limit, tolerance: FEASIBILITY, certify: false };
        let proven = MARGINS.iter().any(|&margin| {
            self.tableau.set_bounds(&self.problem, margin);
            self.tableau.price(zeros);
            self.tableau.place();
            self.workspace.pivots = 0;
            if self.workspace.run(&self.problem, &mut self.tableau, rules) != Ending::Optimal {
                return false;
            }
            self.workspace.read(&self.problem, &self.tableau);
            self.witness.prove(&self.problem, &self.tableau, &mut self.workspace)
        });
        self.tableau.set_bounds(&self.problem, 0.0);
        proven
    }

    /// Brings the tableau up to date with the problem.
    fn prepare(&mut self) {
        if self.stale {
            self.tableau.build(&self.problem);
            self.workspace.resize(&self.problem);
            self.empty = false;
            self.unchecked = 0;
        } else if self.moved {
            self.tableau.set_bounds(&self.problem, 0.0);
        }
        self.stale = false;
        self.moved = false;
        self.workspace.pivots = 0;
    }

    /// Status, value and bound; the rest is in the workspace.
    ///
    /// Three attempts: from the last basis; from the same basis rebuilt from the data, if the first left doubt; and from
    /// the logical basis, forgiving small violations, if the rows are so nearly dependent that the proof needs huge
    /// multipliers. The last one gives no optimal point but a better bound.
    fn solve(&mut self, objective: &[f64], norm: f64) -> (Status, f64, f64) {
        const NOTHING: (Status, f64, f64) = (Status::Empty, f64::NEG_INFINITY, f64::NEG_INFINITY);
        if self.empty {
            return NOTHING;
        }
        let narrow = GAP * norm + 2.0 * UNDERFLOW;
        let wide = WIDE_GAP * norm + 2.0 * UNDERFLOW;
        let limit = self.pivot_limit.unwrap_or(usize::MAX);
        let mut rules = Rules { limit, tolerance: FEASIBILITY, certify: true };
        let mut rebuilt = self.tableau.age == 0;
        loop {
            let cautious = rules.tolerance > FEASIBILITY;
            let (ending, value, bound) = self.attempt(objective, norm, rules);
            if ending == Ending::Empty {
                self.empty = true;
                return NOTHING;
            }
            let gap = bound - value;
            let sound = ending == Ending::Optimal && !cautious && !self.has_drifted();
            if sound && gap <= if rebuilt { wide } else { narrow } {
                return (Status::Optimal, value, bound);
            }
            if cautious || ending == Ending::Limit {
                return (Status::Stopped, value, bound);
            }
            if rebuilt {
                rules.tolerance = CAUTION;
                self.tableau.build(&self.problem);
            } else {
                rebuilt = true;
                self.tableau.rebuild(&self.problem);
            }
            self.unchecked = 0;
        }
    }

    /// One run of the method: how it ended, value and bound.
    fn attempt(&mut self, objective: &[f64], norm: f64, rules: Rules) -> (Ending, f64, f64) {
        let Self { problem, tableau, workspace, .. } = self;
        tableau.price(objective);
        tableau.place();
        let before = workspace.pivots;
        let ending = workspace.run(problem, tableau, rules);
        self.unchecked += workspace.pivots - before;
        workspace.read(problem, tableau);
        let Workspace { multipliers, residual, point, .. } = workspace;
        let bound = problem.weak_duality(objective, norm, multipliers, residual);
        let value = objective.iter().zip(&*point).map(|(c, x)| c * x).sum();
        (ending, value, bound)
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
