//! The scratch of a solve, and what is read off its end.

use crate::bound::{Multiplier, Residual};
use crate::certificate::Certificate;
use crate::fixed_point::FixedPoint;
use crate::problem::Problem;
use crate::ratio_test::RatioTest;
use crate::tableau::Tableau;

/// Scratch of a solve, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    pub(crate) ratio_test: RatioTest,
    pub(crate) residual: Residual,
    pub(crate) multipliers: Vec<Multiplier>,
    pub(crate) point: Vec<f64>,
    /// Proof of the last [`Ending::Empty`](crate::dual_simplex::Ending::Empty).
    pub(crate) certificate: Certificate,
    /// The objective of a feasibility problem.
    pub(crate) zeros: Vec<f64>,
    /// Scratch of a proof of non-emptiness.
    pub(crate) fixed_point: FixedPoint,
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
        self.fixed_point.resize(n);
    }

    /// Reads the multipliers off the reduced costs and the point off the vertex.
    pub(crate) fn read(&mut self, problem: &Problem, tableau: &Tableau) {
        let n = problem.variables();
        self.multipliers.clear();
        let columns = &tableau.columns;
        for ((&v, &cost), &value) in columns.variable.iter().zip(&columns.cost).zip(&columns.value) {
            match (v as usize).checked_sub(n) {
                None => self.point[v as usize] = value,
                Some(i) if cost != 0.0 => {
                    self.multipliers.push((i, cost * problem.ranges()[i].scale));
                }
                Some(_) => {}
            }
        }
        for (&v, &value) in tableau.rows.variable.iter().zip(&tableau.rows.value) {
            if (v as usize) < n {
                // The point is always in the box, and never NaN.
                self.point[v as usize] = if value.is_nan() { 0.0 } else { value.clamp(-1.0, 1.0) };
            }
        }
    }
}
