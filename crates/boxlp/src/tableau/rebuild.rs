//! Rebuilding: the end of the drift that many exchanges accumulate.

use super::Tableau;
use crate::problem::Problem;
use crate::real::Real;

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

impl<T: Real> Tableau<T> {
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
                false if side < T::ZERO => Mark::Lower,
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
        self.weights.clear();
        loop {
            let mut best = (T::from(T::REBUILD_PIVOT), 0, 0);
            for r in (0..rows).filter(|&r| marks[n + r] == Mark::Pending) {
                let row = self.row(r);
                for q in (0..n).filter(|&q| marks[q] == Mark::Pending) {
                    if row[q].abs() > best.0 {
                        best = (row[q].abs(), r, q);
                    }
                }
            }
            let (pivot, r, q) = best;
            if pivot <= T::from(T::REBUILD_PIVOT) {
                break;
            }
            self.exchange(r, q, T::ZERO, &[]);
            marks[n + r] = Mark::Settled;
            marks[q] = Mark::Settled;
        }
        self.age = 0;
        self.marks = marks;
    }
}
