//! How a solve is settled: attempts of rising cost, until none leaves doubt.

use super::Solver;
use crate::answer::Status;
use crate::dual_simplex::{Ending, Rules};
use crate::workspace::{Aim, Answer, GAP};

/// A point that misses a row by more than this share of its 1-norm for each variable, and four more, is doubt as well: a dozen
/// roundings each.
const MISS: f64 = 6.0 * f64::EPSILON;

/// What is called optimal in the end has a gap of at most this share of `|c|_1`.
const WIDE_GAP: f64 = 1e-9;

/// What is called optimal in the end misses no row by more than this share of its 1-norm.
const WIDE_MISS: f64 = 1e-11;

/// How often a vertex is refined before the tableau is rebuilt.
const REFINEMENTS: usize = 3;

/// Exchanges between two comparisons of the tableau with the data.
const CHECK_EVERY: usize = 64;

impl Solver {
    /// Brings the tableau up to date with the problem.
    pub(super) fn prepare(&mut self) {
        if self.stale {
            self.engine.build(&self.problem);
            self.workspace.resize(&self.problem);
            self.empty = false;
            self.unchecked = 0;
            self.imprecise = true;
        } else if self.moved {
            self.engine.tableau.set_bounds(&self.problem, 0.0);
            self.imprecise = true;
        }
        self.stale = false;
        self.moved = false;
        self.workspace.pivots = 0;
    }

    /// Status, value and bound; the rest is in the workspace.
    ///
    /// Where all attempts leave doubt the set may be empty in a way that this objective does not show: that is asked then.
    pub(super) fn solve(&mut self, objective: &[f64], norm: f64) -> Answer {
        let answer = self.settle(objective, norm);
        let doubt = answer.status == Status::Stopped && self.pivot_limit.is_none() && norm > 0.0;
        if doubt && self.is_contradictory() { Answer::EMPTY } else { answer }
    }

    /// Looks for a contradiction from the logical basis; leaves point and multipliers as they were.
    fn is_contradictory(&mut self) -> bool {
        let kept = (self.workspace.multipliers.clone(), self.workspace.point.clone());
        self.engine.build(&self.problem);
        self.imprecise = true;
        let zeros = core::mem::take(&mut self.workspace.zeros);
        self.settle(&zeros, 0.0);
        self.workspace.zeros = zeros;
        (self.workspace.multipliers, self.workspace.point) = kept;
        self.empty
    }

    fn aim<'a>(&self, objective: &'a [f64], norm: f64) -> Aim<'a> {
        let rules = Rules { limit: self.pivot_limit.unwrap_or(usize::MAX), certify: true };
        Aim { objective, norm, rules }
    }

    /// Three attempts: from the last basis; from the same basis rebuilt from the data, if the first left doubt; and with twice
    /// the digits, if the rows are so nearly dependent that these are needed.
    ///
    /// A gap is doubt, and a point that misses a row: it may be worth more than any that does not, by far where rows are nearly
    /// dependent. A vertex that misses is refined first.
    fn settle(&mut self, objective: &[f64], norm: f64) -> Answer {
        if self.empty {
            return Answer::EMPTY;
        }
        let aim = self.aim(objective, norm);
        let mut rebuilt = self.engine.tableau.age == 0;
        let Self { problem, engine, workspace, .. } = self;
        let rounding = MISS * (problem.variables() + 4) as f64;
        loop {
            let before = workspace.pivots;
            let (mut ending, mut answer) = workspace.attempt(problem, engine, aim);
            self.unchecked += workspace.pivots - before;
            let mut refinements = 0;
            while ending == Ending::Optimal && answer.is_within(GAP * norm) {
                let suspect = workspace.forgave
                    || engine.tableau.worst(rounding).is_some()
                    || engine.tableau.delicate
                    || self.unchecked >= CHECK_EVERY
                    || refinements > 0;
                if !suspect {
                    return answer;
                }
                self.unchecked = 0;
                if problem.largest_miss(&workspace.point) <= rounding {
                    return answer;
                }
                if refinements == REFINEMENTS {
                    break;
                }
                refinements += 1;
                engine.tableau.refine(problem, &workspace.point);
                (ending, answer) = workspace.proceed(problem, engine, aim);
            }
            if ending == Ending::Empty {
                self.empty = true;
                return Answer::EMPTY;
            }
            if ending == Ending::Limit {
                return answer;
            }
            if rebuilt {
                return self.solve_precisely(objective, norm, answer);
            }
            rebuilt = true;
            engine.tableau.rebuild(problem);
            self.unchecked = 0;
        }
    }

    /// The last attempt, with twice the digits; `first` is what the others have found.
    fn solve_precisely(&mut self, objective: &[f64], norm: f64, first: Answer) -> Answer {
        let aim = self.aim(objective, norm);
        let Self { problem, engine, precise, workspace, .. } = self;
        if self.imprecise {
            precise.build(problem);
            precise.tableau.round(&engine.tableau);
            precise.tableau.rebuild(problem);
            self.imprecise = false;
        }
        workspace.keep_multipliers();
        let (ending, mut answer) = workspace.attempt(problem, precise, aim);
        if ending == Ending::Empty {
            self.empty = true;
            return Answer::EMPTY;
        }
        engine.tableau.round(&precise.tableau);
        if first.bound < answer.bound {
            workspace.restore_multipliers();
            answer.bound = first.bound;
        }
        let fits = answer.is_within(WIDE_GAP * norm) && problem.largest_miss(&workspace.point) <= WIDE_MISS;
        answer.status = if ending == Ending::Optimal && fits { Status::Optimal } else { Status::Stopped };
        answer
    }
}
