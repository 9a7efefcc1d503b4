//! [`Ekf`]: the extended Kalman filter, on a vector space or on a group.

use nalgebra::{SMatrix, SVector};

use super::chart::Chart;
use super::filter::{Forecast, Kalman, Observe};
use super::gaussian::Gaussian;
use super::innovation::Joint;
use super::model::{SmoothMotion, SmoothSensor};
use super::root;
use crate::EstimatorError;

/// Extended Kalman filter: motion and sensor are linearised at the mean.
///
/// ```text
/// predict   xhat+ = f(xhat, u, 0)            P+ = A P A' + B Q B'
/// update    z = y - h(xhat, 0)               P_yy = H P H' + D R D',  K = P H' P_yy^-1
///           xhat shifted by K z              P+ = (I - K H) P (I - K H)' + K D R D' K'
/// ```
///
/// with the Jacobians of [`SmoothMotion`] and [`SmoothSensor`], in the coordinates of the chart `C`: `R^N` ([`Flat`](super::Flat)) or
/// a group with the left- or right-invariant error ([`OnGroup`](super::OnGroup)). Covariances are carried as roots.
///
/// **Guarantee:** [`Guarantee::Statistical`](crate::Guarantee::Statistical), to first order.
/// **Source:** paper 001, (24)-(26) with (41)-(44); paper 002 for groups.
pub type Ekf<Mo, C, const N: usize, const M: usize, const W: usize, const V: usize> =
    Kalman<Mo, Linearization, C, N, M, W, V>;

/// The rule of the [`Ekf`]: derivatives at the mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Linearization;

/// A motion about a mean: where the mean goes, and what errors and noises of the step become.
pub(super) struct LinearStep<P, const N: usize, const W: usize> {
    /// `A`.
    pub(super) map: SMatrix<f64, N, N>,
    /// `B` times the root of the noises' covariance.
    pub(super) noises: SMatrix<f64, N, W>,
    pub(super) to: P,
}

impl<P, const N: usize, const W: usize> LinearStep<P, N, W> {
    pub(super) fn new<Mo, C>(motion: &Mo, mean: &P, process: &SMatrix<f64, W, W>, input: &Mo::Input) -> Self
    where
        C: Chart<N, Point = P>,
        Mo: SmoothMotion<C, N, W>,
    {
        let (map, b) = motion.motion_jacobians(mean, input);
        Self { map, noises: b * process, to: motion.transition(mean, input, &SVector::zeros()) }
    }
}

impl<Mo, C, const N: usize, const W: usize> Forecast<Mo, C, N, W> for Linearization
where
    C: Chart<N>,
    Mo: SmoothMotion<C, N, W>,
{
    fn forecast(
        &mut self,
        motion: &Mo,
        belief: &Gaussian<C, N>,
        process: &SMatrix<f64, W, W>,
        input: &Mo::Input,
    ) -> Result<Gaussian<C, N>, EstimatorError> {
        let LinearStep { map, noises, to } = LinearStep::new(motion, belief.mean(), process, input);
        let mut spread = root::triangular(&(map * belief.root()));
        for noise in noises.column_iter() {
            root::add(&mut spread, noise.into_owned());
        }
        Gaussian::checked(to, spread)
    }
}

impl<Se, C, const N: usize, const M: usize, const V: usize> Observe<Se, C, N, M, V> for Linearization
where
    C: Chart<N>,
    Se: SmoothSensor<C, N, M, V>,
{
    fn observe(
        &mut self,
        sensor: &Se,
        belief: &Gaussian<C, N>,
        noise: &SMatrix<f64, V, V>,
        y: &SVector<f64, M>,
    ) -> Result<(Joint<N, M>, SVector<f64, M>), EstimatorError> {
        let (h, d) = sensor.output_jacobians(belief.mean());
        let mut joint = Joint::new();
        for v in (d * noise).column_iter() {
            joint.add(v.into_owned(), SVector::zeros());
        }
        for x in belief.root().column_iter() {
            joint.add(h * x, x.into_owned());
        }
        let predicted = sensor.output(belief.mean(), &SVector::zeros());
        Ok((joint, sensor.residual(y, &predicted)))
    }
}
