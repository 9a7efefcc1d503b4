//! Linear systems with interval coefficients `A d in b`: Gauss-Seidel steps, and an approximate inverse to precondition with.

use scalars::Interval;

use super::reverse::factor;

/// Shrinks every `d_j` by one row `sum_j a_j d_j in b`; false if nothing is left.
///
/// `suffix` is scratch. Terms before `j` enter with their new ranges.
pub(super) fn revise_row(a: &[Interval], b: Interval, d: &mut [Interval], suffix: &mut Vec<Interval>) -> bool {
    // suffix[k]: the sum of the last k terms.
    suffix.clear();
    suffix.push(Interval::ZERO);
    let mut sum = Interval::ZERO;
    for (&coefficient, &side) in a.iter().zip(&*d).rev() {
        sum += coefficient * side;
        suffix.push(sum);
    }
    let mut prefix = Interval::ZERO;
    let n = d.len();
    for j in 0..n {
        let rest = b - (prefix + suffix[n - 1 - j]);
        d[j] = factor(rest, a[j], d[j]);
        if d[j].is_empty() {
            return false;
        }
        prefix += a[j] * d[j];
    }
    true
}

/// An approximate left inverse `C` (`n x m`, by rows) of a matrix `J` (`m x n`, by rows, `m >= n`): the inverse, or that of least
/// squares. False if there is none within floating point.
///
/// Not an enclosure: any `C` makes a valid preconditioner.
pub(super) fn left_inverse(j: &[f64], m: usize, n: usize, c: &mut Vec<f64>, normal: &mut Vec<f64>) -> bool {
    c.clear();
    c.resize(n * m, 0.0);
    normal.clear();
    if m == n {
        normal.extend_from_slice(j);
        (0..n).for_each(|i| c[i * n + i] = 1.0);
    } else {
        // J'J C = J'.
        for a in 0..n {
            for b in 0..n {
                normal.push((0..m).map(|i| j[i * n + a] * j[i * n + b]).sum());
            }
            (0..m).for_each(|i| c[a * m + i] = j[i * n + a]);
        }
    }
    eliminate(normal, n, c, m) && c.iter().all(|x| x.is_finite())
}

/// Gauss-Jordan elimination with row pivoting: `rhs <- matrix^-1 rhs`; false at a zero pivot.
fn eliminate(matrix: &mut [f64], n: usize, rhs: &mut [f64], cols: usize) -> bool {
    for k in 0..n {
        let size = |i: usize| matrix[i * n + k].abs();
        let pivot = (k..n).fold(k, |best, i| if size(i) > size(best) { i } else { best });
        if size(pivot) == 0.0 {
            return false;
        }
        if pivot != k {
            (0..n).for_each(|l| matrix.swap(k * n + l, pivot * n + l));
            (0..cols).for_each(|l| rhs.swap(k * cols + l, pivot * cols + l));
        }
        let inverse = 1.0 / matrix[k * n + k];
        (0..n).for_each(|l| matrix[k * n + l] *= inverse);
        (0..cols).for_each(|l| rhs[k * cols + l] *= inverse);
        for i in (0..n).filter(|&i| i != k) {
            let factor = matrix[i * n + k];
            if factor != 0.0 {
                (0..n).for_each(|l| matrix[i * n + l] -= factor * matrix[k * n + l]);
                (0..cols).for_each(|l| rhs[i * cols + l] -= factor * rhs[k * cols + l]);
            }
        }
    }
    true
}
