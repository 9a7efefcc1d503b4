//! [`LinearModel`] and the Kalman filter [`Kf`] for it.

use nalgebra::{SMatrix, SVector};

use super::chart::Flat;
use super::ekf::Ekf;
use super::model::{Motion, Sensor, SmoothMotion, SmoothSensor};
use crate::EstimatorError;
use crate::error::check_finite;

/// Kalman filter of a linear model: the [`Ekf`], which is exact for it.
///
/// With Gaussian noises the mean has the least variance of all estimates, and the covariance is that of its error.
/// **Source:** Kalman 1960; the update is (24)-(26) of paper 001.
///
/// ```
/// use estimators::Estimator;
/// use estimators::kalman::{Gaussian, Kf, LinearModel};
/// use nalgebra::{Matrix1, Matrix1x2, Matrix2, Vector2};
///
/// // A mass with an unknown push every 0.1 s; its position is measured.
/// let model = LinearModel::new(Matrix2::new(1.0, 0.1, 0.0, 1.0), Vector2::new(0.005, 0.1), Matrix1x2::new(1.0, 0.0))?;
/// let start = Gaussian::new(Vector2::zeros(), &Matrix2::from_diagonal_element(100.0))?;
/// let mut filter = Kf::new(model, start, &Matrix1::new(0.01), &Matrix1::new(0.04))?;
/// for k in 0..200 {
///     filter.step(&Vector2::zeros(), &[0.1 * f64::from(k)])?; // moving at speed 1
/// }
/// assert!((filter.belief().mean()[1] - 1.0).abs() < 1e-2);
/// assert!(filter.belief().standard_deviations()[0] < 0.2);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
pub type Kf<const N: usize, const M: usize, const W: usize> = Ekf<LinearModel<N, M, W>, Flat, N, M, W, M>;

/// The model `x+ = A x + u + B w`, `y = C x + v`; the input `u` is the known part of the step, `N` numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearModel<const N: usize, const M: usize, const W: usize> {
    a: SMatrix<f64, N, N>,
    b: SMatrix<f64, N, W>,
    c: SMatrix<f64, M, N>,
}

impl<const N: usize, const M: usize, const W: usize> LinearModel<N, M, W> {
    /// The model with `A: N x N`, `B: N x W`, `C: M x N`. What varies over time is replaced by
    /// [`model_mut`](super::Kalman::model_mut) between steps.
    ///
    /// # Errors
    /// [`EstimatorError::NotFinite`].
    pub fn new(a: SMatrix<f64, N, N>, b: SMatrix<f64, N, W>, c: SMatrix<f64, M, N>) -> Result<Self, EstimatorError> {
        check_finite("A", a.as_slice())?;
        check_finite("B", b.as_slice())?;
        check_finite("C", c.as_slice())?;
        Ok(Self { a, b, c })
    }
}

impl<const N: usize, const M: usize, const W: usize> Motion<Flat, N, W> for LinearModel<N, M, W> {
    type Input = SVector<f64, N>;

    fn transition(&self, x: &SVector<f64, N>, u: &SVector<f64, N>, w: &SVector<f64, W>) -> SVector<f64, N> {
        self.a * x + u + self.b * w
    }

    fn check_input(&self, u: &SVector<f64, N>) -> Result<(), EstimatorError> {
        check_finite("input", u.as_slice())
    }
}

impl<const N: usize, const M: usize, const W: usize> SmoothMotion<Flat, N, W> for LinearModel<N, M, W> {
    fn motion_jacobians(&self, _: &SVector<f64, N>, _: &SVector<f64, N>) -> (SMatrix<f64, N, N>, SMatrix<f64, N, W>) {
        (self.a, self.b)
    }
}

impl<const N: usize, const M: usize, const W: usize> Sensor<Flat, N, M, M> for LinearModel<N, M, W> {
    fn output(&self, x: &SVector<f64, N>, v: &SVector<f64, M>) -> SVector<f64, M> {
        self.c * x + v
    }
}

impl<const N: usize, const M: usize, const W: usize> SmoothSensor<Flat, N, M, M> for LinearModel<N, M, W> {
    fn output_jacobians(&self, _: &SVector<f64, N>) -> (SMatrix<f64, M, N>, SMatrix<f64, M, M>) {
        (self.c, SMatrix::identity())
    }
}
