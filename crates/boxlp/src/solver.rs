//! The solver: a problem and its tableau, one objective after another.

use crate::LpError;
use crate::answer::{Emptiness, Solution};
use crate::double_double::DoubleDouble;
use crate::dual_simplex::{Ending, Engine, Patience, Rules};
use crate::problem::Problem;
use crate::witness::Witness;
use crate::workspace::{Answer, Workspace};

mod settle;

/// How far a witness is sought inside the set, in this order: a deep point survives the rounding of its proof.
const MARGINS: [f64; 2] = [1e-7, 1e-10];

/// Solves `max c'x` over `{ x : lower <= A x <= upper, |x_j| <= 1 }` for one objective after another.
///
/// It owns the problem and all scratch: keep one and [`load`](Self::load) the next problem into it; a solve then allocates
/// nothing (but for the first one that needs more digits). Each solve starts from the basis of the last one, and rows can be appended and dropped between solves.
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
    engine: Engine<f64>,
    /// The same method with twice the digits, for the few objectives that need them.
    precise: Engine<DoubleDouble>,
    /// The precise tableau does not belong to the problem.
    imprecise: bool,
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
            engine: Engine::default(),
            precise: Engine::default(),
            imprecise: true,
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

    /// Limits the exchanges of one solve, at which it ends as [`Status::Stopped`](crate::Status::Stopped) with a looser bound.
    ///
    /// `None` is the default: a solve ends by itself, after at most about `36 (n + m + 10)` exchanges, of which it needs few.
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
            self.engine.tableau.append_row(&self.problem);
            self.imprecise = true;
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
        self.stale = self.stale || !self.engine.tableau.retain_rows(&self.keep);
        self.imprecise = true;
    }

    /// Maximises `c'x`.
    ///
    /// Method: dual simplex with bound flips from the last basis; the multipliers are read off the reduced costs and give
    /// the bound by weak duality ([`Problem::upper_bound`]). Should the point miss a row, it is refined; should the gap or the rows leave
    /// doubt, the tableau is rebuilt from the data; should doubt remain, as for entries over many decades or rows that are nearly dependent, the method goes on in
    /// double-double numbers (and allocates their tableau, once).
    ///
    /// The bound of an optimal answer is as tight as the rows are known: it is at most 1e-9 `|c|_1`, by experience 1e-11, above
    /// the maximum over the set with its ranges wider by some roundings, `12 (n + 4)` units of 2^-53, of the rows' 1-norms (1e-12 of
    /// these, where rows contradict each other by less).
    ///
    /// **Guarantee:** `max c'x <= bound` in real arithmetic; [`Status::Empty`](crate::Status::Empty) only if the set is proven empty. The minimum
    /// of `c'x` is at least minus the bound for `-c`.
    ///
    /// # Errors
    /// [`LpError::Length`], [`LpError::Objective`] or [`LpError::ObjectiveOverflow`].
    pub fn maximize(&mut self, objective: &[f64]) -> Result<Solution<'_>, LpError> {
        let norm = self.problem.check_objective(objective)?;
        self.prepare();
        let Answer { status, value, bound } = self.solve(objective, norm);
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
        let Self { problem, engine, workspace, witness, .. } = self;
        if witness.prove(problem, &engine.tableau, workspace) {
            return true;
        }
        let limit = self.pivot_limit.unwrap_or(usize::MAX);
        let rules = Rules { limit, certify: false };
        let proven = MARGINS.iter().any(|&margin| {
            engine.tableau.set_bounds(problem, margin);
            engine.tableau.price(zeros);
            engine.tableau.place();
            workspace.pivots = 0;
            workspace.patience = Patience::new(problem, 0);
            if workspace.run(problem, engine, rules) != Ending::Optimal {
                return false;
            }
            workspace.read(problem, &engine.tableau);
            witness.prove(problem, &engine.tableau, workspace)
        });
        engine.tableau.set_bounds(problem, 0.0);
        proven
    }
}
