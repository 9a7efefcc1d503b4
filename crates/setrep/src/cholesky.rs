//! Cholesky factors of small symmetric matrices in caller-owned storage, for choices that no guarantee rests on.

/// Cholesky factor of a symmetric positive definite matrix, in its lower triangle (column-major); a pivot that is not positive makes
/// the results NaN or large, which only spoils the choice.
pub(crate) fn factorise(a: &mut [f64], n: usize) {
    for k in 0..n {
        let pivot = a[k * n + k].sqrt();
        for i in k..n {
            a[k * n + i] /= pivot;
        }
        for j in k + 1..n {
            let scale = a[k * n + j];
            for i in j..n {
                a[j * n + i] -= scale * a[k * n + i];
            }
        }
    }
}

/// Solves `L x = b` in place.
pub(crate) fn solve_lower(factor: &[f64], n: usize, x: &mut [f64]) {
    for k in 0..n {
        x[k] /= factor[k * n + k];
        for i in k + 1..n {
            x[i] -= factor[k * n + i] * x[k];
        }
    }
}

/// Solves `L L' x = b` in place.
pub(crate) fn solve(factor: &[f64], n: usize, x: &mut [f64]) {
    solve_lower(factor, n, x);
    for k in (0..n).rev() {
        for i in k + 1..n {
            x[k] -= factor[k * n + i] * x[i];
        }
        x[k] /= factor[k * n + k];
    }
}
