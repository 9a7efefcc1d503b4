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

/// Solves `L X = B` in place for many right-hand sides, stored row after row.
pub(crate) fn solve_lower_rows(factor: &[f64], n: usize, rows: &mut [f64]) {
    let width = rows.len() / n.max(1);
    for k in 0..n {
        let (head, tail) = rows.split_at_mut((k + 1) * width);
        let row = &mut head[k * width..];
        let pivot = 1.0 / factor[k * n + k];
        row.iter_mut().for_each(|x| *x *= pivot);
        for (below, &scale) in tail.chunks_exact_mut(width).zip(&factor[k * n + k + 1..]) {
            below.iter_mut().zip(row.iter()).for_each(|(y, x)| *y -= scale * x);
        }
    }
}

/// The last `m` rows of the solution of `L' X = B` in place, from those of `B`: the others do not matter.
pub(crate) fn solve_upper_end(factor: &[f64], n: usize, m: usize, rows: &mut [f64]) {
    let width = rows.len() / m.max(1);
    for k in (0..m).rev() {
        let (head, tail) = rows.split_at_mut((k + 1) * width);
        let row = &mut head[k * width..];
        let column = (n - m + k) * n + n - m + k;
        for (below, &scale) in tail.chunks_exact(width).zip(&factor[column + 1..]) {
            row.iter_mut().zip(below).for_each(|(x, y)| *x -= scale * y);
        }
        let pivot = 1.0 / factor[column];
        row.iter_mut().for_each(|x| *x *= pivot);
    }
}
