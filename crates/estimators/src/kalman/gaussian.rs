//! [`Gaussian`]: a mean and a covariance, as a square root.

use nalgebra::{SMatrix, SVector};

use super::chart::Chart;
use super::root;
use crate::EstimatorError;
use crate::error::check_finite;

/// A Gaussian belief: a mean and the covariance `P = S S'` of the error around it, in the coordinates of a [`Chart`].
///
/// The lower triangular root `S` is what is stored, so a covariance is positive semidefinite by construction.
///
/// ```
/// use estimators::kalman::{Flat, Gaussian};
/// use nalgebra::{Matrix2, Vector2};
/// let belief = Gaussian::<Flat, 2>::new(Vector2::new(3.0, 4.0), &Matrix2::new(4.0, 1.0, 1.0, 0.25))?;
/// assert_eq!(belief.standard_deviations(), Vector2::new(2.0, 0.5));
/// // The covariance is singular: what lies off its line has no finite distance.
/// assert_eq!(belief.nees(&Vector2::new(5.0, 4.5))?, 1.0);
/// assert_eq!(belief.nees(&Vector2::new(5.0, 4.0))?, f64::INFINITY);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaussian<C: Chart<N>, const N: usize> {
    mean: C::Point,
    root: SMatrix<f64, N, N>,
}

impl<C: Chart<N>, const N: usize> Gaussian<C, N> {
    /// The belief with a mean and a covariance `P: N x N`, positive semidefinite.
    ///
    /// # Errors
    /// [`EstimatorError::NotFinite`], [`EstimatorError::NotSymmetric`], [`EstimatorError::NotPositive`].
    pub fn new(mean: C::Point, covariance: &SMatrix<f64, N, N>) -> Result<Self, EstimatorError> {
        C::check(&mean)?;
        Ok(Self { mean, root: root::factor("covariance", covariance)? })
    }

    /// The belief with a mean and the covariance `R R'`, for any `R: N x N`.
    ///
    /// # Errors
    /// [`EstimatorError::NotFinite`].
    pub fn from_root(mean: C::Point, root: &SMatrix<f64, N, N>) -> Result<Self, EstimatorError> {
        Self::checked(mean, root::triangular(root))
    }

    /// From a lower triangular root.
    pub(super) fn checked(mean: C::Point, root: SMatrix<f64, N, N>) -> Result<Self, EstimatorError> {
        C::check(&mean)?;
        check_finite("root of the covariance", root.as_slice())?;
        Ok(Self { mean, root })
    }

    /// The mean.
    #[must_use]
    pub fn mean(&self) -> &C::Point {
        &self.mean
    }

    /// The lower triangular root `S`, with a diagonal that is not negative.
    #[must_use]
    pub fn root(&self) -> &SMatrix<f64, N, N> {
        &self.root
    }

    /// The covariance `P = S S'`.
    #[must_use]
    pub fn covariance(&self) -> SMatrix<f64, N, N> {
        self.root * self.root.transpose()
    }

    /// The standard deviations `sqrt(P_ii)`.
    #[must_use]
    pub fn standard_deviations(&self) -> SVector<f64, N> {
        SVector::from_fn(|i, _| self.root.row(i).iter().fold(0.0, |norm: f64, entry| norm.hypot(*entry)))
    }

    /// Normalised estimation error squared, `e' P^-1 e` for the error `e` of the mean against `truth`; its mean is `N` for a filter
    /// whose covariance is right. Infinite where `P` is singular and has no such error.
    ///
    /// # Errors
    /// A truth that is not finite, or that the chart does not reach.
    pub fn nees(&self, truth: &C::Point) -> Result<f64, EstimatorError> {
        C::check(truth)?;
        Ok(squared_distance(&self.root, &C::difference(truth, &self.mean)?))
    }
}

/// `e' (S S')^-1 e` by forward substitution; infinite if `S` has no such `e` in its range.
pub(super) fn squared_distance<const N: usize>(root: &SMatrix<f64, N, N>, e: &SVector<f64, N>) -> f64 {
    let mut z = SVector::<f64, N>::zeros();
    for i in 0..N {
        let known: f64 = (0..i).map(|j| root[(i, j)] * z[j]).sum();
        let rest = e[i] - known;
        z[i] = match (root[(i, i)] > 0.0, rest.abs() <= 4.0 * N as f64 * f64::EPSILON * (e[i].abs() + known.abs())) {
            (true, _) => rest / root[(i, i)],
            (false, true) => 0.0,
            (false, false) => return f64::INFINITY,
        };
    }
    z.norm_squared()
}
