//! The dual simplex method with bound flips, from any basis.

use crate::problem::Problem;
use crate::ratio_test::RatioTest;
use crate::real::Real;
use crate::tableau::{Tableau, Violation};
use crate::workspace::Workspace;

/// How often the tolerance is loosened before the method gives up.
const LOOSENINGS: usize = 2;

/// A proof of emptiness is used only if it misses by more than this share of the 1-norms: sets that are empty by the
/// rounding of their data are treated as the points they are meant to be.
const MISS: f64 = 1e-12;

/// How long a solve may take before something is done about it; the runs of an attempt share it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Patience {
    /// At this number of exchanges the reduced costs are moved apart.
    shift_at: usize,
    /// The costs have been moved.
    pub(crate) shifted: bool,
    /// At this number of exchanges the tolerance is loosened.
    loosen_at: usize,
    loosened: usize,
}

impl Patience {
    /// That of a problem, from the given number of exchanges on.
    pub(crate) fn new(problem: &Problem, pivots: usize) -> Self {
        let size = problem.variables() + problem.rows();
        Self { shift_at: pivots + 10 + size / 2, shifted: false, loosen_at: pivots + Self::span(problem), loosened: 0 }
    }

    fn span(problem: &Problem) -> usize {
        20 + 2 * (problem.variables() + problem.rows())
    }
}

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
    /// Whether a contradiction is to be proven from the data (else it is reported as [`Ending::Doubt`]).
    pub(crate) certify: bool,
}

/// The method at one precision.
#[derive(Clone, Debug, Default)]
pub(crate) struct Engine<T> {
    pub(crate) tableau: Tableau<T>,
    ratio_test: RatioTest<T>,
}

impl<T: Real> Engine<T> {
    /// The tableau of `problem` on its logical basis, with room for all that a solve needs.
    pub(crate) fn build(&mut self, problem: &Problem) {
        self.tableau.build(problem);
        self.ratio_test.resize(problem.variables(), problem.stride());
    }
}

impl Workspace {
    /// Runs the method on a priced and placed tableau, with [`Workspace::patience`].
    pub(crate) fn run<T: Real>(&mut self, problem: &Problem, engine: &mut Engine<T>, rules: Rules) -> Ending {
        let Engine { tableau, ratio_test } = engine;
        let contradiction = T::from(T::CONTRADICTION);
        let mut tolerance = T::from(T::FEASIBILITY);
        self.forgave = false;
        while let Some(violation) = tableau.worst(tolerance) {
            if self.pivots >= rules.limit {
                return Ending::Limit;
            }
            let patience = &mut self.patience;
            if self.pivots >= patience.shift_at && !patience.shifted {
                patience.shifted = true;
                tableau.shift_costs();
            }
            if self.pivots >= patience.loosen_at {
                // Rounding errors make the method cycle: forgive larger violations.
                if patience.loosened == LOOSENINGS {
                    return Ending::Doubt;
                }
                patience.loosened += 1;
                patience.loosen_at += Patience::span(problem);
                tolerance = tolerance * T::from(100.0);
                self.forgave = true;
                continue;
            }
            let row = tableau.row(violation.row);
            let entering = ratio_test.run(row, &tableau.columns, violation);
            let doubtful = entering.rest > T::ZERO || !entering.stable;
            let tiny = doubtful && {
                let norm = row.iter().fold(T::ONE, |sum, t| sum + t.abs());
                if entering.rest > T::ZERO {
                    if rules.certify && self.farkas(problem, tableau, violation) {
                        return Ending::Empty;
                    }
                    if entering.rest > contradiction * norm {
                        return Ending::Doubt;
                    }
                }
                let share = if entering.rest > T::ZERO { contradiction } else { T::from(T::NOISE) };
                violation.amount <= share * norm
            };
            match entering.column {
                Some(column) if entering.stable || !tiny => {
                    tableau.step(violation, column, &ratio_test.flips);
                    self.pivots += 1;
                }
                // The row touches its bound as well as working accuracy can tell: exchanges would divide by errors.
                _ => {
                    tolerance = violation.amount + violation.amount;
                    self.forgave = true;
                }
            }
        }
        Ending::Optimal
    }

    /// Reads multipliers off a row that no flips repair, and proves the set empty by them.
    ///
    /// `x_r = T_r x_N` holds for every `x`; over the bounds of all variables the left side stays on one side of the right.
    fn farkas<T: Real>(&mut self, problem: &Problem, tableau: &Tableau<T>, violation: Violation<T>) -> bool {
        let n = problem.variables();
        self.certificate.multipliers.clear();
        let mut push = |v: u32, coefficient: T| {
            if let Some(i) = (v as usize).checked_sub(n)
                && coefficient != T::ZERO
            {
                self.certificate.multipliers.push((i, coefficient.to_f64() * problem.ranges()[i].scale));
            }
        };
        push(tableau.rows.variable[violation.row], violation.sign);
        for (&v, &t) in tableau.columns.variable.iter().zip(tableau.row(violation.row)) {
            push(v, -violation.sign * t);
        }
        self.certificate.miss(problem) > MISS
    }
}
