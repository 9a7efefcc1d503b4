//! The dual simplex method with bound flips, from any basis.

use crate::bound::{Multiplier, Residual};
use crate::certificate::Certificate;
use crate::problem::Problem;
use crate::ratio_test::RatioTest;
use crate::tableau::{Tableau, Violation};

/// Violations below this (rows have 1-norms in [1/2, 1), the box has half-width 1) are rounding errors.
pub(crate) const FEASIBILITY: f64 = 1e-13;

/// How often the tolerance is loosened before the method gives up.
const LOOSENINGS: usize = 2;

/// A row contradicts the others beyond doubt only if it misses by more than this share of its 1-norm after all flips.
const CONTRADICTION: f64 = 1e-9;

/// A proof of emptiness is used only if it misses by more than this share of the 1-norms: sets that are empty by the
/// rounding of their data are treated as the points they are meant to be.
const MISS: f64 = 1e-12;

/// How a run of the method ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ending {
    /// All basic variables lie within their bounds.
    Optimal,
    /// The certificate of [`Workspace`] proves the set empty.
    Empty,
    /// The pivot limit was reached.
    Limit,
    /// A row contradicts the others, but the proof fails; or the method does not come to an end. The tableau has drifted,
    /// or the rows are dependent but for little.
    Doubt,
}

/// What a run may do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rules {
    /// Most exchanges of all runs of a solve.
    pub(crate) limit: usize,
    /// Violations below this are forgiven.
    pub(crate) tolerance: f64,
    /// Whether a contradiction is to be proven from the data (else it is reported as [`Ending::Doubt`]).
    pub(crate) certify: bool,
}

/// Scratch of a solve, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    pub(crate) ratio_test: RatioTest,
    pub(crate) residual: Residual,
    pub(crate) multipliers: Vec<Multiplier>,
    pub(crate) point: Vec<f64>,
    /// Proof of the last [`Ending::Empty`].
    pub(crate) certificate: Certificate,
    /// The objective of a feasibility problem.
    pub(crate) zeros: Vec<f64>,
    /// Scratch of a proof of non-emptiness, one entry a variable.
    pub(crate) displacement: Vec<(f64, f64)>,
    pub(crate) pivots: usize,
}

impl Workspace {
    /// Makes room for a problem: afterwards nothing is allocated.
    pub(crate) fn resize(&mut self, problem: &Problem) {
        let n = problem.variables();
        self.ratio_test.resize(n, problem.stride());
        self.residual.resize(problem.stride());
        self.multipliers.clear();
        self.multipliers.reserve(n);
        self.certificate.multipliers.clear();
        self.certificate.multipliers.reserve(n + 1);
        self.point.resize(n, 0.0);
        self.zeros.resize(n, 0.0);
        self.displacement.resize(n, (0.0, 0.0));
    }

    /// Runs the method on a priced and placed tableau.
    pub(crate) fn run(&mut self, problem: &Problem, tableau: &mut Tableau, rules: Rules) -> Ending {
        let patience = 20 + 2 * (problem.variables() + problem.rows());
        let mut loosen_at = self.pivots + patience;
        let mut loosened = 0;
        let mut tolerance = rules.tolerance;
        while let Some(violation) = tableau.worst(tolerance) {
            if self.pivots >= rules.limit {
                return Ending::Limit;
            }
            if self.pivots >= loosen_at {
                // Rounding errors make the method cycle: forgive larger violations.
                if loosened == LOOSENINGS {
                    return Ending::Doubt;
                }
                loosened += 1;
                loosen_at += patience;
                tolerance *= 100.0;
                continue;
            }
            let row = tableau.row(violation.row);
            let entering = self.ratio_test.run(row, &tableau.columns, violation);
            let doubtful = entering.rest > 0.0 || !entering.stable;
            let tiny = doubtful && {
                let norm = 1.0 + row.iter().map(|t| t.abs()).sum::<f64>();
                if entering.rest > 0.0 {
                    if rules.certify && self.farkas(problem, tableau, violation) {
                        return Ending::Empty;
                    }
                    if entering.rest > CONTRADICTION * norm {
                        return Ending::Doubt;
                    }
                }
                violation.amount <= CONTRADICTION * norm
            };
            match entering.column {
                Some(column) if entering.stable || !tiny => {
                    tableau.step(violation, column, &self.ratio_test.flips);
                    self.pivots += 1;
                }
                // The row touches its bound as well as working accuracy can tell: exchanges would divide by errors.
                _ => tolerance = 2.0 * violation.amount,
            }
        }
        Ending::Optimal
    }

    /// Reads multipliers off a row that no flips repair, and proves the set empty by them.
    ///
    /// `x_r = T_r x_N` holds for every `x`; over the bounds of all variables the left side stays on one side of the right.
    fn farkas(&mut self, problem: &Problem, tableau: &Tableau, violation: Violation) -> bool {
        let n = problem.variables();
        self.certificate.multipliers.clear();
        let mut push = |v: u32, coefficient: f64| {
            if let Some(i) = (v as usize).checked_sub(n)
                && coefficient != 0.0
            {
                self.certificate
                    .multipliers
                    .push((i, coefficient * problem.ranges()[i].scale));
            }
        };
        push(tableau.rows.variable[violation.row], violation.sign);
        for (&v, &t) in tableau
            .columns
            .variable
            .iter()
            .zip(tableau.row(violation.row))
        {
            push(v, -violation.sign * t);
        }
        self.certificate.miss(problem) > MISS
    }

    /// Reads the multipliers off the reduced costs and the point off the vertex.
    pub(crate) fn read(&mut self, problem: &Problem, tableau: &Tableau) {
        let n = problem.variables();
        self.multipliers.clear();
        let columns = &tableau.columns;
        for ((&v, &cost), &value) in columns
            .variable
            .iter()
            .zip(&columns.cost)
            .zip(&columns.value)
        {
            match (v as usize).checked_sub(n) {
                None => self.point[v as usize] = value,
                Some(i) if cost != 0.0 => {
                    self.multipliers.push((i, cost * problem.ranges()[i].scale))
                }
                Some(_) => {}
            }
        }
        for (&v, &value) in tableau.rows.variable.iter().zip(&tableau.rows.value) {
            if (v as usize) < n {
                // A NaN becomes -1: the point is always in the box.
                self.point[v as usize] = value.max(-1.0).min(1.0);
            }
        }
    }
}
