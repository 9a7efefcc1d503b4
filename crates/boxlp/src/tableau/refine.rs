//! Refinement: the vertex compared with the data, and corrected by the tableau's own inverse.

use super::{Tableau, dot};
use crate::problem::Problem;

impl Tableau<f64> {
    /// Corrects the values of the basic variables, whose structural part is `point`.
    ///
    /// A nonbasic logical has a bound as its value; the activity of its row at the point is off by `rho`. The basic variables move by
    /// `T rho`, and are off by `|rho|` times the relative error of `T` then. Plain sums will do: what is left of `rho` is their rounding.
    pub(crate) fn refine(&mut self, problem: &Problem, point: &[f64]) {
        let n = self.variables;
        let activity = |i: usize| {
            let sum: f64 = problem.row(i).iter().zip(point).map(|(a, x)| a * x).sum();
            sum * problem.ranges()[i].scale
        };
        // The padding stays zero.
        let Self { pivot_row: misses, columns, rows, matrix, stride, .. } = self;
        for ((miss, &v), &value) in misses.iter_mut().zip(&columns.variable).zip(&columns.value) {
            *miss = (v as usize).checked_sub(n).map_or(0.0, |i| value - activity(i));
        }
        misses[n..].fill(0.0);
        for ((value, &v), row) in rows.value.iter_mut().zip(&rows.variable).zip(matrix.chunks_exact(*stride)) {
            let start = (v as usize).checked_sub(n).map_or_else(|| point[v as usize], activity);
            *value = start + dot(row, misses);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_on_nearly_dependent_rows_is_found_again() {
        let mut problem = Problem::new(3).unwrap();
        let (a, b) = ([1.0, 0.5, 0.25], [1.0 + 3e-7, 0.5 - 7e-7, 0.25 + 2e-7]);
        problem.push_row(&a, 0.2, 0.2).unwrap();
        problem.push_row(&b, 0.2 + 1e-8, 0.2 + 1e-8).unwrap();
        problem.push_row(&[0.3, -0.2, 0.1], -0.6, 0.6).unwrap();
        let mut tableau = Tableau::<f64>::default();
        tableau.build(&problem);
        tableau.exchange(0, 0, 0.0, &[]);
        tableau.exchange(1, 1, 0.0, &[]);
        tableau.place();
        let point = |tableau: &Tableau<f64>| [tableau.rows.value[0], tableau.rows.value[1], tableau.columns.value[2]];
        let off = point(&tableau).map(|x| x + 1e-4);
        assert!(problem.largest_miss(&off) > 1e-5);
        // The third one is nonbasic: it stays on its bound.
        let off = [off[0], off[1], tableau.columns.value[2]];
        tableau.refine(&problem, &off);
        let refined = point(&tableau);
        tableau.refine(&problem, &refined);
        let refined = point(&tableau);
        assert!(problem.largest_miss(&refined) < 1e-15, "{:e}", problem.largest_miss(&refined));
        let activity = 0.3 * refined[0] - 0.2 * refined[1] + 0.1 * refined[2];
        assert!((tableau.rows.value[2] - activity).abs() < 1e-15);
    }
}
