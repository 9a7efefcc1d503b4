//! The dual simplex method with bound flips, from any basis.

use crate::problem::Problem;
use crate::tableau::{Tableau, Violation};
use crate::workspace::Workspace;

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

impl Workspace {
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
}
