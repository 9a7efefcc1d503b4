//! The gain that minimises the F-radius of the next set.

use nalgebra::{Cholesky, SMatrix};

use crate::EstimatorError;
use crate::error::check_finite;

/// Smallest accepted ratio of a squared Cholesky pivot of `S` to the diagonal entry it came from.
const PIVOT_LIMIT: f64 = 1e-13;

/// `L = A P C' S^-1` with `S = C P C' + Q_v`: the minimiser of `|| [(A - L C) H, D_w H_w, -L D_v H_v] ||_F`.
///
/// Shapes `A: n x n`, `P = H H': n x n`, `C: m x n`, `Q_v = D_v H_v H_v' D_v': m x m`, `L: n x m`. `S` is factored by Cholesky.
///
/// **Guarantee:** approximate (a gain is a choice: every `L` gives a valid set).
/// **Source:** paper 000, (12); Combastel 2015.
///
/// # Errors
/// [`EstimatorError::NotFinite`] if `S` is not finite: an argument is not, or its products overflow.
/// [`EstimatorError::SingularInnovation`] if `S` is not positive definite to working accuracy: a combination of outputs with
/// neither noise nor spread.
///
/// ```
/// use estimators::f_radius_gain;
/// use nalgebra::{Matrix1, Matrix1x2, Matrix2, Vector2};
/// let spread = Matrix2::new(4.0, 0.0, 0.0, 1.0);
/// let gain = f_radius_gain(&Matrix2::identity(), &spread, &Matrix1x2::new(1.0, 0.0), &Matrix1::new(1.0))?;
/// assert!((gain - Vector2::new(0.8, 0.0)).norm() < 1e-15);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
pub fn f_radius_gain<const N: usize, const M: usize>(
    a: &SMatrix<f64, N, N>,
    p: &SMatrix<f64, N, N>,
    c: &SMatrix<f64, M, N>,
    q_v: &SMatrix<f64, M, M>,
) -> Result<SMatrix<f64, N, M>, EstimatorError> {
    let seen = c * p;
    let s = seen * c.transpose() + q_v;
    check_finite("innovation covariation S", s.as_slice())?;
    let singular = |pivot_ratio| EstimatorError::SingularInnovation { outputs: M, pivot_ratio, limit: PIVOT_LIMIT };
    let factor = Cholesky::new(s).ok_or(singular(0.0))?;
    let l = factor.l_dirty();
    let ratios = (0..M).map(|i| l[(i, i)] * l[(i, i)] / s[(i, i)]);
    // A NaN ratio is not accepted either.
    if !ratios.clone().all(|ratio| ratio >= PIVOT_LIMIT) {
        return Err(singular(ratios.fold(f64::INFINITY, f64::min)));
    }
    Ok(a * factor.solve(&seen).transpose())
}
