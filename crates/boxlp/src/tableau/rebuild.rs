//! Rebuilding: the end of the drift that many exchanges accumulate.

use super::Tableau;
use crate::problem::Problem;

/// Smallest entry an exchange may divide by when a basis is rebuilt.
pub(super) const REBUILD_PIVOT: f64 = 1e-9;

/// What a rebuild has to do with a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Mark {
    /// To be exchanged: a structural variable into the basis, a logical out of it.
    Pending,
    /// A structural variable that stays nonbasic, at its lower bound.
    Lower,
    /// Nothing to do.
    Settled,
}

impl Tableau {
    /// The tableau of the same basis computed afresh from the data: ends the drift of many exchanges.
    ///
    /// The structural variables of the basis enter again by complete pivoting; one that is dependent on the others (to
    /// working accuracy) stays out: any basis will do.
    pub(crate) fn rebuild(&mut self, problem: &Problem) {
        let n = self.variables;
        let mut marks = core::mem::take(&mut self.marks);
        marks.clear();
        marks.resize(n, Mark::Pending);
        marks.resize(n + self.rows.variable.len(), Mark::Settled);
        for (&v, &side) in self.columns.variable.iter().zip(&self.columns.side) {
            marks[v as usize] = match v as usize >= n {
                true => Mark::Pending,
                false if side < 0.0 => Mark::Lower,
                false => Mark::Settled,
            };
        }
        let rows = problem.rows();
        let margin = self.margin;
        self.load(problem);
        self.set_bounds(problem, margin);
        for j in 0..n {
            if marks[j] == Mark::Lower {
                self.columns.flip(j);
            }
        }
        loop {
            let mut best = (REBUILD_PIVOT, 0, 0);
            for r in (0..rows).filter(|&r| marks[n + r] == Mark::Pending) {
                let row = self.row(r);
                for q in (0..n).filter(|&q| marks[q] == Mark::Pending) {
                    if row[q].abs() > best.0 {
                        best = (row[q].abs(), r, q);
                    }
                }
            }
            let (pivot, r, q) = best;
            if pivot <= REBUILD_PIVOT {
                break;
            }
            self.exchange(r, q, 0.0, &[]);
            marks[n + r] = Mark::Settled;
            marks[q] = Mark::Settled;
        }
        self.age = 0;
        self.marks = marks;
    }

    /// Largest difference between a row's activity at `point` and the value of its logical.
    pub(crate) fn drift(&self, problem: &Problem, point: &[f64]) -> f64 {
        let n = self.variables;
        let basic = self.rows.variable.iter().zip(&self.rows.value);
        let nonbasic = self.columns.variable.iter().zip(&self.columns.value);
        let mut drift = 0.0_f64;
        for (&v, &value) in basic.chain(nonbasic) {
            if let Some(i) = (v as usize).checked_sub(n) {
                let activity: f64 = problem.row(i).iter().zip(point).map(|(a, x)| a * x).sum();
                drift = drift.max((activity * problem.ranges()[i].scale - value).abs());
            }
        }
        drift
    }
}
