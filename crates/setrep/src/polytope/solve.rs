//! Small square linear systems with a proven error bound, and the choice of independent rows by pivoting.

use scalars::rounding::UNIT_ROUNDOFF;

use super::error_free::{dot_compensated, two_product};
use crate::bounds::two_sum;

/// Underflow of a few hundred operations on numbers of moderate size stays below this.
const TINY: f64 = 1e-300;

/// Slack factor for the rounding of the error bounds themselves, which are sums of at most a few hundred positive terms.
const SLACK: f64 = 1.0 + 1e-12;

/// Pivots below this share of the first one count as none.
const SMALLEST_PIVOT: f64 = 1e-12;

/// Rows and columns of `rank` pivots of a row-major matrix, chosen by complete pivoting; `None` beside a pivot that is too small.
///
/// A heuristic: independence is proven afterwards by [`Solver::solve`] or by exact elimination.
pub(super) fn pivots(matrix: &mut [f64], cols: usize, rank: usize) -> Option<(Vec<usize>, Vec<usize>)> {
    let rows = matrix.len() / cols;
    let (mut row_order, mut col_order): (Vec<usize>, Vec<usize>) = ((0..rows).collect(), (0..cols).collect());
    let mut first = 0.0;
    if rank > rows.min(cols) {
        return None;
    }
    for step in 0..rank {
        let (mut best, mut at) = (0.0, (step, step));
        for i in step..rows {
            let row = &matrix[row_order[i] * cols..(row_order[i] + 1) * cols];
            for j in step..cols {
                let size = row[col_order[j]].abs();
                if size > best {
                    (best, at) = (size, (i, j));
                }
            }
        }
        if step == 0 {
            first = best;
        }
        if !(best > SMALLEST_PIVOT * first && best.is_finite()) {
            return None;
        }
        row_order.swap(step, at.0);
        col_order.swap(step, at.1);
        let (pivot_row, pivot_col) = (row_order[step], col_order[step]);
        let inverse = 1.0 / matrix[pivot_row * cols + pivot_col];
        for &i in &row_order[step + 1..] {
            let factor = matrix[i * cols + pivot_col] * inverse;
            if factor != 0.0 {
                for &j in &col_order[step..] {
                    matrix[i * cols + j] -= factor * matrix[pivot_row * cols + j];
                }
            }
        }
    }
    Some((row_order, col_order))
}

/// Scratch of verified solves.
#[derive(Default)]
pub(super) struct Solver {
    work: Vec<f64>,
    inverse: Vec<f64>,
    weighted: Vec<f64>,
    residual: Vec<f64>,
    /// The computed solution.
    pub(super) solution: Vec<f64>,
    /// Bounds of its error, entry by entry.
    pub(super) radius: Vec<f64>,
}

impl Solver {
    /// Solves `B z = c` for a row-major `n x n` matrix with entries of moderate size. True if `B` is proven regular; then the exact
    /// solution lies within `radius` of `solution`, in each entry.
    ///
    /// With `R` near `B^-1` and `b = |I - R B|_inf < 1`: `B` is regular and `|z* - z| <= |R| |c - B z| + b/(1 - b) max(|R| |c - B z|)`,
    /// where the residual is compensated (error near `u^2`) and every bound includes the rounding of its evaluation.
    pub(super) fn solve(&mut self, n: usize, matrix: &[f64], rhs: &[f64]) -> bool {
        if !self.invert(n, matrix) {
            return false;
        }
        let u = UNIT_ROUNDOFF;
        let size = n as f64 + 4.0;
        let norms: Vec<f64> = matrix.chunks_exact(n).map(|row| row.iter().map(|x| x.abs()).sum()).collect();
        self.solution.clear();
        self.solution.resize(n, 0.0);
        for _ in 0..2 {
            self.residual.clear();
            for (row, &c) in matrix.chunks_exact(n).zip(rhs) {
                self.residual.push(residual(row, &self.solution, c).0);
            }
            for i in 0..n {
                let correction: f64 =
                    self.inverse[i * n..(i + 1) * n].iter().zip(&self.residual).map(|(r, x)| r * x).sum();
                self.solution[i] += correction;
            }
        }
        // What is nearly zero is often zero; any solution will do, the bounds below hold for it.
        let largest = self.solution.iter().fold(0.0_f64, |m, z| m.max(z.abs()));
        for z in self.solution.iter_mut().filter(|z| z.abs() < 2f64.powi(-80) * largest) {
            *z = 0.0;
        }
        // Bounds of the final residual.
        self.residual.clear();
        for (row, &c) in matrix.chunks_exact(n).zip(rhs) {
            let (value, error) = residual(row, &self.solution, c);
            self.residual.push((value.abs() + error) * SLACK);
        }
        let (mut contraction, mut largest) = (0.0_f64, 0.0_f64);
        self.weighted.clear();
        for i in 0..n {
            let inverse = &self.inverse[i * n..(i + 1) * n];
            let mut defect = 0.0;
            for j in 0..n {
                let mut entry = if i == j { -1.0 } else { 0.0 };
                for l in 0..n {
                    entry += inverse[l] * matrix[l * n + j];
                }
                defect += entry.abs();
            }
            let magnitude: f64 = inverse.iter().zip(&norms).map(|(r, norm)| r.abs() * norm).sum();
            let row_contraction = (defect + size * u * (magnitude + 1.0) + TINY) * SLACK;
            let weighted = inverse.iter().zip(&self.residual).map(|(r, x)| r.abs() * x).sum::<f64>() * SLACK;
            // max() would drop a NaN.
            if !(row_contraction < 0.25 && weighted.is_finite()) {
                return false;
            }
            contraction = contraction.max(row_contraction);
            largest = largest.max(weighted);
            self.weighted.push(weighted);
        }
        let common = contraction / (1.0 - contraction) * largest * SLACK;
        self.radius.clear();
        self.radius
            .extend(self.weighted.iter().map(|w| if w + common == 0.0 { 0.0 } else { (w + common) * SLACK + TINY }));
        true
    }

    /// An approximate inverse by Gauss-Jordan elimination with row pivoting, into `self.inverse`.
    fn invert(&mut self, n: usize, matrix: &[f64]) -> bool {
        self.work.clear();
        self.work.extend_from_slice(matrix);
        self.inverse.clear();
        self.inverse.resize(n * n, 0.0);
        for i in 0..n {
            self.inverse[i * n + i] = 1.0;
        }
        for k in 0..n {
            let mut pivot = k;
            for i in k + 1..n {
                if self.work[i * n + k].abs() > self.work[pivot * n + k].abs() {
                    pivot = i;
                }
            }
            let divisor = self.work[pivot * n + k];
            if divisor == 0.0 || !divisor.is_finite() {
                return false;
            }
            for j in 0..n {
                self.work.swap(k * n + j, pivot * n + j);
                self.inverse.swap(k * n + j, pivot * n + j);
                self.work[k * n + j] /= divisor;
                self.inverse[k * n + j] /= divisor;
            }
            for i in 0..n {
                let factor = self.work[i * n + k];
                if i != k && factor != 0.0 {
                    for j in 0..n {
                        self.work[i * n + j] -= factor * self.work[k * n + j];
                        self.inverse[i * n + j] -= factor * self.inverse[k * n + j];
                    }
                }
            }
        }
        true
    }
}

/// `c - row z` with a bound of its error, zero where no operation rounded.
fn residual(row: &[f64], z: &[f64], c: f64) -> (f64, f64) {
    let (mut sum, mut compensation, mut magnitude, mut lost) = (c, 0.0, c.abs(), 0.0);
    for (&a, &x) in row.iter().zip(z) {
        let (product, error) = two_product(a, x);
        let (next, carry) = two_sum(sum, -product);
        sum = next;
        compensation += carry - error;
        lost += carry.abs() + error.abs();
        magnitude += product.abs();
        if product != 0.0 && product.abs() < 1e-240 {
            lost = f64::INFINITY;
        }
    }
    if lost == 0.0 {
        return (sum, 0.0);
    }
    let gamma = 2.0 * (row.len() as f64 + 3.0) * UNIT_ROUNDOFF;
    let value = sum + compensation;
    if lost == f64::INFINITY {
        return (value, gamma * magnitude + TINY);
    }
    (value, UNIT_ROUNDOFF * value.abs() + gamma * gamma * magnitude + TINY)
}

/// [`dot_compensated`] as an upper bound.
pub(super) fn dot_upper(x: &[f64], y: &[f64]) -> f64 {
    let (value, error) = dot_compensated(x, y);
    if error == 0.0 { value } else { scalars::rounding::add_up(value, error) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_are_enclosed_and_integers_exact() {
        let mut solver = Solver::default();
        assert!(solver.solve(2, &[2.0, 1.0, 1.0, 3.0], &[5.0, 10.0]));
        assert_eq!((solver.solution.as_slice(), solver.radius.as_slice()), (&[1.0, 3.0][..], &[0.0, 0.0][..]));
        assert!(solver.solve(2, &[3.0, 1.0, 1.0, 3.0], &[1.0, 0.0]));
        assert!((solver.solution[0] - 0.375).abs() <= solver.radius[0] && solver.radius[0] < 1e-15);
        assert!(!solver.solve(2, &[1.0, 2.0, 2.0, 4.0], &[1.0, 0.0]));
    }

    #[test]
    fn pivoting_finds_independent_rows() {
        let mut matrix = [1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 0.0, 0.0, 1.0];
        assert_eq!(
            pivots(&mut matrix.clone(), 3, 2).map(|(rows, _)| rows[..2].contains(&2) || rows[..2].contains(&1)),
            Some(true)
        );
        assert!(pivots(&mut matrix, 3, 3).is_none());
    }
}
