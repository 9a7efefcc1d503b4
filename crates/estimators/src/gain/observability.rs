//! Observability of a pair `(A, C)`.

use nalgebra::{DMatrix, DVector};

use crate::EstimatorError;
use crate::error::{check_finite, check_size};

/// Numerical rank of the observability matrix `[C; C A; ..; C A^(n-1)]`, shapes `A: n x n`, `C: p x n`.
///
/// The rank is the dimension of the smallest `A'`-invariant space that holds the rows of `C`. An orthonormal basis of it is
/// grown by Gram-Schmidt, so powers of `A` (whose columns become parallel) are never formed. A direction counts as new
/// if it leaves the basis by more than `n^2 2^-48` times `|A|` (for the rows of `C`: times `|C|`), Frobenius norms.
/// The pair is observable if the rank is `n`.
///
/// **Guarantee:** approximate: a rank decided by a threshold.
/// **Source:** Kalman's rank condition; Rosenbrock's staircase form without the transformation of `A`.
///
/// # Errors
/// [`EstimatorError::Size`] and [`EstimatorError::NotFinite`] for a pair that is none.
///
/// ```
/// use estimators::observability_rank;
/// use nalgebra::DMatrix;
/// // A position that integrates a speed: seen through the position both are known, through the speed only one.
/// let a = DMatrix::from_row_slice(2, 2, &[1.0, 0.1, 0.0, 1.0]);
/// assert_eq!(observability_rank(&a, &DMatrix::from_row_slice(1, 2, &[1.0, 0.0]))?, 2);
/// assert_eq!(observability_rank(&a, &DMatrix::from_row_slice(1, 2, &[0.0, 1.0]))?, 1);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
pub fn observability_rank(a: &DMatrix<f64>, c: &DMatrix<f64>) -> Result<usize, EstimatorError> {
    let n = check_pair(a, c)?;
    let (a, c) = (a / binade(largest(a)), c / binade(largest(c)));
    let tolerance = (n * n) as f64 * 2f64.powi(-48);
    let a_norm = a.norm();
    let mut basis: Vec<DVector<f64>> = Vec::with_capacity(n);
    for row in pivoted_rows(&c, tolerance) {
        basis.push(row);
    }
    let mut next = 0;
    while next < basis.len() && basis.len() < n {
        let candidate = a.tr_mul(&basis[next]);
        if let Some(new) = new_direction(&basis, candidate, tolerance * a_norm) {
            basis.push(new);
        }
        next += 1;
    }
    Ok(basis.len())
}

/// Checks shapes and entries of a pair and returns the number of states.
pub(super) fn check_pair(a: &DMatrix<f64>, c: &DMatrix<f64>) -> Result<usize, EstimatorError> {
    let n = a.nrows();
    check_size("columns of A", n, a.ncols())?;
    check_size("columns of C", n, c.ncols())?;
    check_finite("A", a.as_slice())?;
    check_finite("C", c.as_slice())?;
    Ok(n)
}

/// Largest entry, by absolute value.
pub(super) fn largest(matrix: &DMatrix<f64>) -> f64 {
    matrix.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// The power of two at or below a finite positive number (1 for zero): dividing by it scales exactly, and afterwards squares
/// neither over- nor underflow where it matters.
pub(super) fn binade(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    if x == 0.0 { 1.0 } else { f64::from_bits(x.max(f64::MIN_POSITIVE).to_bits() & EXPONENT) }
}

/// Orthonormal basis of the row space of `C`, largest remaining row first.
fn pivoted_rows(c: &DMatrix<f64>, tolerance: f64) -> Vec<DVector<f64>> {
    let threshold = tolerance * c.norm();
    let mut basis: Vec<DVector<f64>> = Vec::new();
    while basis.len() < c.ncols() {
        let best = (0..c.nrows())
            .map(|i| remainder(&basis, c.row(i).transpose()))
            .max_by(|x, y| x.norm().total_cmp(&y.norm()));
        match best {
            Some(v) if v.norm() > threshold => basis.push(v.normalize()),
            _ => break,
        }
    }
    basis
}

/// The unit vector of what `v` adds to the span of `basis`, if it adds more than `threshold`.
fn new_direction(basis: &[DVector<f64>], v: DVector<f64>, threshold: f64) -> Option<DVector<f64>> {
    let v = remainder(basis, v);
    (v.norm() > threshold).then(|| v.normalize())
}

/// `v` less its projection on the span of an orthonormal basis, projected twice to be orthogonal to rounding.
fn remainder(basis: &[DVector<f64>], mut v: DVector<f64>) -> DVector<f64> {
    for _ in 0..2 {
        for b in basis {
            v.axpy(-b.dot(&v), b, 1.0);
        }
    }
    v
}
