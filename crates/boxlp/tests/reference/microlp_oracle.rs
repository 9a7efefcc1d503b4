//! `microlp` (primal and dual simplex) as an oracle.

use crate::common::norm1;
use boxlp::Problem;
use microlp::{ComparisonOp, OptimizationDirection, Variable};

/// What the oracle says about a problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Answer {
    Optimum(f64),
    Infeasible,
    Failed,
}

fn add_rows(lp: &mut microlp::Problem, problem: &Problem, x: &[Variable], slack: Option<Variable>) {
    for i in 0..problem.rows() {
        let row = problem.row(i);
        let norm = norm1(row);
        let (lower, upper) = problem.range(i);
        let mut terms: Vec<(Variable, f64)> = x.iter().copied().zip(row.iter().copied()).collect();
        if lower == upper && slack.is_none() {
            lp.add_constraint(terms.as_slice(), ComparisonOp::Eq, lower);
            continue;
        }
        if upper.is_finite() {
            terms.extend(slack.map(|t| (t, -norm)));
            lp.add_constraint(terms.as_slice(), ComparisonOp::Le, upper);
        }
        terms.truncate(x.len());
        if lower.is_finite() {
            terms.extend(slack.map(|t| (t, norm)));
            lp.add_constraint(terms.as_slice(), ComparisonOp::Ge, lower);
        }
    }
}

fn answer(lp: &microlp::Problem) -> Answer {
    match lp.solve() {
        Ok(outcome) => outcome.into_solution().map_or(Answer::Failed, |s| Answer::Optimum(s.objective())),
        Err(microlp::Error::Infeasible) => Answer::Infeasible,
        Err(_) => Answer::Failed,
    }
}

/// `max c'x` over the set.
pub(crate) fn maximize(problem: &Problem, objective: &[f64]) -> Answer {
    let mut lp = microlp::Problem::new(OptimizationDirection::Maximize);
    let x: Vec<Variable> = objective.iter().map(|&c| lp.add_var(c, (-1.0, 1.0))).collect();
    add_rows(&mut lp, problem, &x, None);
    answer(&lp)
}

/// `min t` such that every row holds up to `t` of its 1-norm: how far the set is from having a point.
pub(crate) fn miss(problem: &Problem) -> Answer {
    let mut lp = microlp::Problem::new(OptimizationDirection::Minimize);
    let x: Vec<Variable> = (0..problem.variables()).map(|_| lp.add_var(0.0, (-1.0, 1.0))).collect();
    let t = lp.add_var(1.0, (0.0, f64::INFINITY));
    add_rows(&mut lp, problem, &x, Some(t));
    answer(&lp)
}
