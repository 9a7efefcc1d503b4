//! A factorisation of small row sums, `L C = T + M B`, by a linear program. Approximate.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SupportedConeT};

use crate::Matrix;

/// What is minimised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Goal {
    /// The largest `sum_k |C_jk|`.
    LargestRow,
    /// The sum of all `|C_jk|`, with `sum_k |C_jk| <= 1` for each `j`.
    Total,
}

/// `C: m x k` and `M: p x q` with `L C = T + M B`, shapes `L: p x m`, `T: p x k`, `B: q x k`; `None` if the solver has no answer.
pub(super) fn factorize(l: &Matrix, t: &Matrix, b: &Matrix, goal: Goal) -> Option<(Matrix, Matrix)> {
    let (p, m, k, q) = (l.rows(), l.cols(), t.cols(), b.rows());
    // Unknowns: C, bounds of |C|, M, and the largest row sum.
    let (bounds, multipliers, largest) = (m * k, 2 * m * k, 2 * m * k + p * q);
    let mut triplets = Triplets::default();
    for column in 0..k {
        for row in 0..p {
            // Rows in units of their largest entry.
            let scale = (0..m).fold(0.0_f64, |s, j| s.max(l[(row, j)].abs()));
            let scale = if scale > 0.0 { 1.0 / scale } else { 1.0 };
            for j in 0..m {
                triplets.push(column * m + j, scale * l[(row, j)]);
            }
            for e in 0..q {
                triplets.push(multipliers + row * q + e, -b[(e, column)]);
            }
            triplets.end_row(scale * t[(row, column)]);
        }
    }
    let equalities = triplets.rows();
    for entry in 0..m * k {
        for sign in [1.0, -1.0] {
            triplets.push(entry, sign);
            triplets.push(bounds + entry, -1.0);
            triplets.end_row(0.0);
        }
    }
    for j in 0..m {
        (0..k).for_each(|column| triplets.push(bounds + column * m + j, 1.0));
        match goal {
            Goal::LargestRow => triplets.push(largest, -1.0),
            Goal::Total => {}
        }
        triplets.end_row(if goal == Goal::Total { 1.0 } else { 0.0 });
    }
    let mut objective = vec![0.0; largest + 1];
    match goal {
        Goal::LargestRow => objective[largest] = 1.0,
        Goal::Total => objective[bounds..multipliers].fill(1.0),
    }
    if goal == Goal::Total {
        // An unknown without a part is fixed.
        triplets.push(largest, 1.0);
        triplets.end_row(0.0);
    }
    let cones = [SupportedConeT::ZeroConeT(equalities), SupportedConeT::NonnegativeConeT(triplets.rows() - equalities)];
    let solution = triplets.solve(&objective, &cones)?;
    let c = Matrix::from_column_slice(m, k, &solution[..m * k]).ok()?;
    // Undo the scaling of the rows.
    let mut multiplier = Matrix::zeros(p, q);
    for row in 0..p {
        let scale = (0..m).fold(0.0_f64, |s, j| s.max(l[(row, j)].abs()));
        let scale = if scale > 0.0 { scale } else { 1.0 };
        for e in 0..q {
            multiplier[(row, e)] = scale * solution[multipliers + row * q + e];
        }
    }
    Some((c, multiplier))
}

/// Rows `a'x (= or <=) b` being collected.
#[derive(Default)]
struct Triplets {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    right: Vec<f64>,
}

impl Triplets {
    fn rows(&self) -> usize {
        self.right.len()
    }

    fn push(&mut self, column: usize, value: f64) {
        if value != 0.0 {
            self.rows.push(self.right.len());
            self.columns.push(column);
            self.values.push(value);
        }
    }

    fn end_row(&mut self, right: f64) {
        self.right.push(right);
    }

    /// The minimiser as far as the solver came; `None` if it is not finite.
    fn solve(self, objective: &[f64], cones: &[SupportedConeT<f64>]) -> Option<Vec<f64>> {
        let n = objective.len();
        let finite = self.values.iter().chain(&self.right).all(|x| x.is_finite());
        if !finite {
            return None;
        }
        let a = CscMatrix::new_from_triplets(self.right.len(), n, self.rows, self.columns, self.values);
        let settings = DefaultSettingsBuilder::default().verbose(false).presolve_enable(false).build().ok()?;
        let quadratic = CscMatrix::zeros((n, n));
        let mut solver = DefaultSolver::new(&quadratic, objective, &a, &self.right, cones, settings).ok()?;
        solver.solve();
        let x = core::mem::take(&mut solver.solution.x);
        x.iter().all(|x| x.is_finite()).then_some(x)
    }
}
