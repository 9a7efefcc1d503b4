//! The scratch of a solve, and what is read off its end.

use crate::answer::Status;
use crate::bound::{Multiplier, Residual};
use crate::certificate::Certificate;
use crate::dual_simplex::{Ending, Engine, Patience, Rules};
use crate::fixed_point::FixedPoint;
use crate::problem::Problem;
use crate::real::Real;
use crate::rounding::UNDERFLOW;
use crate::tableau::Tableau;

/// A gap above this share of `|c|_1` is doubt.
pub(crate) const GAP: f64 = 1e-11;

/// Scratch of a solve, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    pub(crate) residual: Residual,
    pub(crate) multipliers: Vec<Multiplier>,
    /// Multipliers put aside during an attempt that may find better ones.
    kept: Vec<Multiplier>,
    pub(crate) point: Vec<f64>,
    /// Proof of the last [`Ending::Empty`](crate::dual_simplex::Ending::Empty).
    pub(crate) certificate: Certificate,
    /// The objective of a feasibility problem.
    pub(crate) zeros: Vec<f64>,
    /// Scratch of a proof of non-emptiness.
    pub(crate) fixed_point: FixedPoint,
    pub(crate) pivots: usize,
    /// That of the attempt under way.
    pub(crate) patience: Patience,
    /// The last run forgave violations above the tolerance of its precision.
    pub(crate) forgave: bool,
}

/// What a solve maximises, and what it may do for it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim<'a> {
    pub(crate) objective: &'a [f64],
    /// Upper bound of its 1-norm.
    pub(crate) norm: f64,
    pub(crate) rules: Rules,
}

/// Status, value and bound of an attempt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer {
    pub(crate) status: Status,
    pub(crate) value: f64,
    pub(crate) bound: f64,
}

impl Answer {
    /// That of an empty set.
    pub(crate) const EMPTY: Self = Self { status: Status::Empty, value: f64::NEG_INFINITY, bound: f64::NEG_INFINITY };

    /// Whether the bound is close to the value.
    pub(crate) fn is_within(&self, gap: f64) -> bool {
        self.bound - self.value <= gap + 2.0 * UNDERFLOW
    }
}

impl Workspace {
    /// Makes room for a problem: afterwards nothing is allocated.
    pub(crate) fn resize(&mut self, problem: &Problem) {
        let n = problem.variables();
        self.residual.resize(problem.stride());
        self.multipliers.clear();
        self.multipliers.reserve(2 * n);
        self.kept.clear();
        self.kept.reserve(2 * n);
        self.certificate.multipliers.clear();
        self.certificate.multipliers.reserve(n + 1);
        self.point.resize(n, 0.0);
        self.zeros.resize(n, 0.0);
        self.fixed_point.resize(n);
    }

    /// One attempt from the basis of the tableau: how it ended, value and bound.
    pub(crate) fn attempt<T: Real>(
        &mut self,
        problem: &Problem,
        engine: &mut Engine<T>,
        aim: Aim<'_>,
    ) -> (Ending, Answer) {
        engine.tableau.price(aim.objective);
        engine.tableau.place();
        self.patience = Patience::new(problem, self.pivots);
        self.proceed(problem, engine, aim)
    }

    /// Goes on with an attempt from where the tableau stands.
    ///
    /// The vertex of costs that were moved is optimal for the true ones but for a gap; the method goes on if that is too wide.
    pub(crate) fn proceed<T: Real>(
        &mut self,
        problem: &Problem,
        engine: &mut Engine<T>,
        aim: Aim<'_>,
    ) -> (Ending, Answer) {
        let shifted = self.patience.shifted;
        let ending = self.run(problem, engine, aim.rules);
        if shifted == self.patience.shifted {
            return (ending, self.answer(problem, engine, aim, ending));
        }
        engine.tableau.price(aim.objective);
        let answer = self.answer(problem, engine, aim, ending);
        if ending != Ending::Optimal || answer.is_within(GAP * aim.norm) {
            return (ending, answer);
        }
        engine.tableau.place();
        let ending = self.run(problem, engine, aim.rules);
        (ending, self.answer(problem, engine, aim, ending))
    }

    /// Value and bound at the vertex of the tableau.
    fn answer<T: Real>(&mut self, problem: &Problem, engine: &Engine<T>, aim: Aim<'_>, ending: Ending) -> Answer {
        self.read(problem, &engine.tableau);
        let bound = problem.weak_duality(aim.objective, aim.norm, &self.multipliers, &mut self.residual);
        let value = aim.objective.iter().zip(&self.point).map(|(c, x)| c * x).sum();
        let status = if ending == Ending::Optimal { Status::Optimal } else { Status::Stopped };
        Answer { status, value, bound }
    }

    /// Puts the multipliers aside.
    pub(crate) fn keep_multipliers(&mut self) {
        self.kept.clear();
        self.kept.extend_from_slice(&self.multipliers);
    }

    /// Takes those put aside again.
    pub(crate) fn restore_multipliers(&mut self) {
        core::mem::swap(&mut self.kept, &mut self.multipliers);
    }

    /// Reads the multipliers off the reduced costs and the point off the vertex.
    pub(crate) fn read<T: Real>(&mut self, problem: &Problem, tableau: &Tableau<T>) {
        let n = problem.variables();
        self.multipliers.clear();
        let columns = &tableau.columns;
        for ((&v, &cost), &value) in columns.variable.iter().zip(&columns.cost).zip(&columns.value) {
            match (v as usize).checked_sub(n) {
                None => self.point[v as usize] = value.to_f64(),
                Some(i) if cost != T::ZERO => {
                    let (scale, (head, tail)) = (problem.ranges()[i].scale, cost.split());
                    self.multipliers.push((i, head * scale));
                    if tail != 0.0 {
                        self.multipliers.push((i, tail * scale));
                    }
                }
                Some(_) => {}
            }
        }
        for (&v, &value) in tableau.rows.variable.iter().zip(&tableau.rows.value) {
            if (v as usize) < n {
                // The point is always in the box, and never NaN.
                let value = value.to_f64();
                self.point[v as usize] = if value.is_nan() { 0.0 } else { value.clamp(-1.0, 1.0) };
            }
        }
    }
}
