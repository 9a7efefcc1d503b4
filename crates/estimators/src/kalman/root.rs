//! Lower triangular square roots of covariances, `P = S S'`, changed column by column with plane rotations.
//!
//! Adding a column keeps `P` positive semidefinite whatever rounding does; no covariance is ever subtracted from another but where a
//! weight of the unscented transformation is negative.

use nalgebra::{SMatrix, SVector};

use crate::EstimatorError;
use crate::error::check_finite;

/// A pivot below this times its diagonal entry counts as zero.
const ZERO_PIVOT: f64 = 1e-14;
/// Entries beside a zero pivot, or across the diagonal, may be off by this times what a covariance admits there.
const SLACK: f64 = 1e-7;

/// The lower triangular `S` with `S S' = P`; a zero pivot gives a zero column (nalgebra's Cholesky refuses those).
pub(super) fn factor<const N: usize>(
    what: &'static str,
    p: &SMatrix<f64, N, N>,
) -> Result<SMatrix<f64, N, N>, EstimatorError> {
    check_finite(what, p.as_slice())?;
    let mut s = SMatrix::<f64, N, N>::zeros();
    for j in 0..N {
        let pivot = p[(j, j)] - s.row(j).norm_squared();
        if pivot < -ZERO_PIVOT * p[(j, j)].abs() {
            return Err(EstimatorError::NotPositive { what, index: j, value: pivot });
        }
        let regular = pivot > ZERO_PIVOT * p[(j, j)].abs();
        if regular {
            s[(j, j)] = pivot.sqrt();
        }
        for i in j + 1..N {
            let admitted = SLACK * p[(i, i)].abs().sqrt() * p[(j, j)].abs().sqrt();
            if (p[(i, j)] - p[(j, i)]).abs() > admitted {
                return Err(EstimatorError::NotSymmetric { what, row: i, col: j });
            }
            let rest = p[(i, j)] - s.row(i).dot(&s.row(j));
            if regular {
                s[(i, j)] = rest / s[(j, j)];
            } else if rest.abs() > admitted {
                return Err(EstimatorError::NotPositive { what, index: j, value: pivot });
            }
        }
    }
    Ok(s)
}

/// The lower triangular `S+` with `S+ S+' = R R'`, for any square `R`.
pub(super) fn triangular<const N: usize>(r: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    let mut s = SMatrix::zeros();
    for column in r.column_iter() {
        add(&mut s, column.into_owned());
    }
    s
}

/// `S S' + x x'`.
pub(super) fn add<const N: usize>(s: &mut SMatrix<f64, N, N>, mut x: SVector<f64, N>) {
    for j in 0..N {
        if let Some(turn) = Turn::new(s[(j, j)], x[j]) {
            turn.apply(&mut s.column_mut(j).as_mut_slice()[j..], &mut x.as_mut_slice()[j..]);
        }
    }
}

/// The plane rotation that turns `(a, b)` into `(sqrt(a^2 + b^2), 0)`.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    cos: f64,
    sin: f64,
}

impl Turn {
    /// None where there is nothing to turn.
    #[inline]
    pub(super) fn new(a: f64, b: f64) -> Option<Self> {
        let squared = a * a + b * b;
        // Squares of very small and very large numbers leave the range; the slow way does not.
        let norm = if squared > 1e-280 && squared < f64::INFINITY { squared.sqrt() } else { a.hypot(b) };
        (b != 0.0 && norm > 0.0).then(|| Self { cos: a / norm, sin: b / norm })
    }

    #[inline]
    pub(super) fn apply(self, left: &mut [f64], right: &mut [f64]) {
        for (a, b) in left.iter_mut().zip(right) {
            (*a, *b) = (self.cos * *a + self.sin * *b, self.cos * *b - self.sin * *a);
        }
    }
}

/// The hyperbolic rotation that turns `(a, b)` into `(sqrt(a^2 - b^2), 0)`: removes a column.
#[derive(Clone, Copy)]
pub(super) struct Squeeze {
    cosh: f64,
    sinh: f64,
}

impl Squeeze {
    /// The error is `a^2 - b^2` where that leaves no positive pivot.
    #[inline]
    pub(super) fn new(a: f64, b: f64) -> Result<Option<Self>, f64> {
        // Relative to a^2, which may leave the range.
        let rest = ((a - b) / a) * ((a + b) / a);
        match b {
            0.0 => Ok(None),
            _ if rest > 0.0 => Ok(Some(Self { cosh: rest.sqrt(), sinh: b / a })),
            _ => Err((a - b) * (a + b)),
        }
    }

    /// In the mixed form, which is stable.
    #[inline]
    pub(super) fn apply(self, left: &mut [f64], right: &mut [f64]) {
        for (a, b) in left.iter_mut().zip(right) {
            *a = (*a - self.sinh * *b) / self.cosh;
            *b = self.cosh * *b - self.sinh * *a;
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix2, Matrix3, Vector3};

    use super::{add, factor, triangular};
    use crate::EstimatorError;

    #[test]
    fn factors_semidefinite_matrices_and_refuses_others() {
        let half = Matrix3::new(2.0, 0.0, 0.0, -1.0, 0.0, 0.0, 3.0, 0.0, 0.5);
        let s = factor("P", &(half * half.transpose())).unwrap();
        assert!((s - half).norm() < 1e-14, "{s}");
        let wrong = factor("P", &Matrix2::new(1.0, 2.0, 2.0, 1.0)).unwrap_err();
        assert_eq!(wrong, EstimatorError::NotPositive { what: "P", index: 1, value: -3.0 });
        let wrong = factor("P", &Matrix2::new(1.0, 0.5, 0.0, 1.0)).unwrap_err();
        assert_eq!(wrong, EstimatorError::NotSymmetric { what: "P", row: 1, col: 0 });
        let wrong = factor("P", &Matrix2::new(0.0, 0.1, 0.1, 1.0)).unwrap_err();
        assert!(matches!(wrong, EstimatorError::NotPositive { index: 0, .. } | EstimatorError::NotSymmetric { .. }));
        assert!(factor("P", &Matrix2::new(f64::NAN, 0.0, 0.0, 1.0)).is_err());
    }

    #[test]
    fn columns_add_up() {
        let r = Matrix3::new(1.0, 2.0, -3.0, 0.0, 0.0, 4.0, 5.0, -6.0, 0.25);
        let x = Vector3::new(0.3, 0.0, -7.0);
        let mut s = triangular(&r);
        add(&mut s, x);
        assert!((s * s.transpose() - (r * r.transpose() + x * x.transpose())).norm() < 1e-13);
        // At any scale.
        for scale in [1e-200, 1e200] {
            let mut large = triangular(&(r * scale));
            add(&mut large, x * scale);
            assert!((large / scale - s).norm() < 1e-13, "{scale}: {large}");
        }
        assert!(s.upper_triangle().norm() - s.diagonal().norm() == 0.0 && s.diagonal().min() >= 0.0);
    }
}
