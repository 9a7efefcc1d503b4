//! Proven corrections of coordinates: how little suffices to make up for a residual.

use nalgebra::DMatrix;
use scalars::Interval;
use scalars::rounding::{add_up, div_up, mul_up, sub_down};

use crate::Matrix;

/// Pivots below this share of their row count as zero.
const RANK_TOLERANCE: f64 = 1e-10;

/// A matrix `L: p x m` with `p` of its columns and their approximate inverse.
///
/// For every residual `|e| <= rho` there is a correction `D` with `L D = e` that is zero but in the chosen columns, where it is at most
/// `|K| rho + |I - K L_B| max(|K| rho) / (1 - q)`: with `K` near `L_B^-1` and `|I - K L_B| <= q < 1` the matrix `L_B` is regular, and its
/// solution is `D = K e + (I - K L_B) D`.
pub(super) struct Correction<'a> {
    matrix: &'a Matrix,
    /// Rows that are not zero, the columns chosen for them, and `K`.
    rows: Vec<usize>,
    columns: Vec<usize>,
    inverse: DMatrix<f64>,
}

impl<'a> Correction<'a> {
    /// Chooses columns by elimination with full pivoting; `None` if the nonzero rows are dependent.
    pub(super) fn new(matrix: &'a Matrix) -> Option<Self> {
        let norm = |i: usize| matrix.columns().fold(0.0_f64, |m, column| m.max(column[i].abs()));
        let rows: Vec<usize> = (0..matrix.rows()).filter(|&i| norm(i) > 0.0).collect();
        let p = rows.len();
        let mut a = DMatrix::from_fn(p, matrix.cols(), |i, j| matrix[(rows[i], j)] / norm(rows[i]));
        let mut columns = vec![usize::MAX; p];
        for _ in 0..p {
            let (mut best, mut at) = (RANK_TOLERANCE, None);
            for j in 0..matrix.cols() {
                for i in (0..p).filter(|&i| columns[i] == usize::MAX) {
                    if a[(i, j)].abs() > best {
                        (best, at) = (a[(i, j)].abs(), Some((i, j)));
                    }
                }
            }
            let (row, column) = at?;
            columns[row] = column;
            for i in (0..p).filter(|&i| columns[i] == usize::MAX) {
                let share = a[(i, column)] / a[(row, column)];
                for j in 0..matrix.cols() {
                    a[(i, j)] -= share * a[(row, j)];
                }
            }
        }
        let inverse = DMatrix::from_fn(p, p, |i, k| matrix[(rows[i], columns[k])]).try_inverse()?;
        Some(Self { matrix, rows, columns, inverse })
    }

    /// Subtracts from the columns of `c` what brings `L c` near `target`. Approximate.
    pub(super) fn polish(&self, target: &Matrix, c: &mut Matrix) {
        for column in 0..c.cols() {
            let residual: Vec<f64> = self
                .rows
                .iter()
                .map(|&i| {
                    let product = (0..self.matrix.cols()).map(|j| self.matrix[(i, j)] * c[(j, column)]);
                    target[(i, column)] - product.sum::<f64>()
                })
                .collect();
            for (k, &j) in self.columns.iter().enumerate() {
                let step: f64 = residual.iter().enumerate().map(|(i, r)| self.inverse[(k, i)] * r).sum();
                c[(j, column)] += step;
            }
        }
    }

    /// Bounds of the correction in each column for residuals within `rho`; `None` if none is proven.
    pub(super) fn bounds(&self, rho: &[f64]) -> Option<Vec<f64>> {
        let p = self.rows.len();
        let mut bounds = vec![0.0; self.matrix.cols()];
        if (0..rho.len()).any(|i| rho[i] != 0.0 && !self.rows.contains(&i)) {
            return None;
        }
        if rho.iter().all(|&r| r == 0.0) {
            return Some(bounds);
        }
        let steps: Vec<f64> = (0..p)
            .map(|k| (0..p).fold(0.0, |sum, i| add_up(sum, mul_up(self.inverse[(k, i)].abs(), rho[self.rows[i]]))))
            .collect();
        let sums: Vec<f64> = (0..p).map(|k| self.defect_row(k)).collect();
        let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        let q = largest(&sums);
        let proven = q < 0.5 && steps.iter().all(|s| s.is_finite());
        if !proven {
            return None;
        }
        let reach = div_up(largest(&steps), sub_down(1.0, q));
        for (k, &j) in self.columns.iter().enumerate() {
            bounds[j] = add_up(steps[k], mul_up(sums[k], reach));
        }
        Some(bounds)
    }

    /// Upper bound of the sum of row `k` of `|I - K L_B|`.
    fn defect_row(&self, k: usize) -> f64 {
        let p = self.rows.len();
        (0..p).fold(0.0, |sum, l| {
            let unit = if k == l { Interval::ONE } else { Interval::ZERO };
            let entry = (0..p).fold(unit, |rest, i| {
                let factor = self.matrix[(self.rows[i], self.columns[l])];
                rest - Interval::point(self.inverse[(k, i)]) * Interval::point(factor)
            });
            add_up(sum, entry.mag())
        })
    }
}
