//! Eigenvectors of a small symmetric matrix by Jacobi rotations, in caller-owned storage.

/// Sweeps after which the rotations stop; convergence is quadratic, a handful suffices.
const MAX_SWEEPS: usize = 20;

/// Overwrites `vectors` (`n x n`, column-major) by approximate eigenvectors of the symmetric matrix `a`, which becomes nearly diagonal.
///
/// Approximate: nothing rests on the result being exact; it is orthogonal to working precision.
pub(crate) fn eigenvectors(a: &mut [f64], n: usize, vectors: &mut Vec<f64>) {
    vectors.clear();
    vectors.resize(n * n, 0.0);
    for i in 0..n {
        vectors[i * n + i] = 1.0;
    }
    for _ in 0..MAX_SWEEPS {
        let mut rotated = false;
        for p in 0..n {
            for q in p + 1..n {
                let (diagonal, off) = (a[p * n + p].abs().max(a[q * n + q].abs()), a[q * n + p]);
                if off.abs() > f64::EPSILON * 0.5 * diagonal {
                    rotate(a, n, vectors, p, q);
                    rotated = true;
                }
            }
        }
        if !rotated {
            return;
        }
    }
}

/// One rotation in the plane `(p, q)` that annihilates `a_pq`.
fn rotate(a: &mut [f64], n: usize, vectors: &mut [f64], p: usize, q: usize) {
    let theta = (a[q * n + q] - a[p * n + p]) / (2.0 * a[q * n + p]);
    let t = theta.signum() / (theta.abs() + (1.0 + theta * theta).sqrt());
    let c = 1.0 / (1.0 + t * t).sqrt();
    let s = t * c;
    for k in 0..n {
        (a[p * n + k], a[q * n + k]) = (c * a[p * n + k] - s * a[q * n + k], s * a[p * n + k] + c * a[q * n + k]);
    }
    for k in 0..n {
        (a[k * n + p], a[k * n + q]) = (c * a[k * n + p] - s * a[k * n + q], s * a[k * n + p] + c * a[k * n + q]);
        (vectors[p * n + k], vectors[q * n + k]) =
            (c * vectors[p * n + k] - s * vectors[q * n + k], s * vectors[p * n + k] + c * vectors[q * n + k]);
    }
}
