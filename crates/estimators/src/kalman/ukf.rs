//! [`Ukf`]: the unscented Kalman filter, on a vector space or on a group.

use nalgebra::{SMatrix, SVector};

use super::chart::Chart;
use super::filter::{Forecast, Kalman, Observe};
use super::gaussian::Gaussian;
use super::innovation::Joint;
use super::model::{Motion, Sensor};
use super::sigma_points::{SigmaPoints, Weights};
use crate::EstimatorError;

/// Unscented Kalman filter: motion and sensor are evaluated at sigma points of states and noises together.
///
/// Prediction (22) and transformed outputs (23) are unscented transformations of the augmented variables `(x, w)` and `(x, v)`,
/// so noises need not be additive; then `K = P_xy P_yy^-1` (24), `xhat + K z` (25), `P - K P_yy K'` (26), the last by triangularising
/// the joint root, without the subtraction. [`SigmaPoints`] says where the points are; symmetric by default, as in the paper.
///
/// On a group ([`OnGroup`](super::OnGroup)) the points are `Xhat` shifted by tangent vectors, and a mean is the element around which the
/// weighted logarithms add up to 0; angles are not averaged. Outputs are combined by [`Sensor::residual`] against that of the
/// center, so angles among them are not averaged either.
///
/// **Guarantee:** [`Guarantee::Statistical`](crate::Guarantee::Statistical).
/// **Source:** paper 001, Algorithm 2.1 and (22)-(26); on groups Brossard, Barrau, Bonnabel 2020.
///
/// ```
/// use estimators::kalman::{ByFunction, Flat, Gaussian, SigmaPoints, Ukf};
/// use estimators::Estimator;
/// use nalgebra::{Matrix1, Vector1};
/// use nonlin_bounds::function;
///
/// // The square of a Gaussian of mean 1 and variance 1/4 has mean 1 + 1/4: exactly so for every set of points.
/// let square = ByFunction::new(function!(|[x, w]: 2| -> 1 { [x.sqr() + w] }));
/// let sensor = ByFunction::new(function!(|[x, v]: 2| -> 1 { [x + v] }));
/// let start = Gaussian::new(Vector1::new(1.0), &Matrix1::new(0.25))?;
/// let mut filter: Ukf<_, Flat, 1, 1, 1, 1> = Ukf::new((square, sensor), start, &Matrix1::new(1e-3), &Matrix1::new(0.1))?
///     .with_points(SigmaPoints::Central { weight: 1.0 / 3.0 })?;
/// filter.predict(&[])?;
/// assert!((filter.belief().mean()[0] - 1.25).abs() < 1e-15);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
pub type Ukf<Mo, C, const N: usize, const M: usize, const W: usize, const V: usize> =
    Kalman<Mo, Unscented<<C as Chart<N>>::Point>, C, N, M, W, V>;

/// Most corrections of a mean on a group.
const MEAN_ITERATIONS: usize = 50;
/// The length of the last, relative to the largest deviation.
const MEAN_TOLERANCE: f64 = 1e-12;
/// The same where corrections have stopped to shrink, as they do at rounding; deviations shorter than the second are taken for that.
const STALLED: (f64, f64) = (1e-2, 1e-8);

/// The rule of the [`Ukf`]: a set of sigma points, and room for their images.
#[derive(Debug, Clone)]
pub struct Unscented<P> {
    points: SigmaPoints,
    images: Vec<P>,
    outputs: Vec<f64>,
}

impl<P> Default for Unscented<P> {
    fn default() -> Self {
        Self { points: SigmaPoints::Symmetric, images: Vec::new(), outputs: Vec::new() }
    }
}

impl<Mo, P, C, const N: usize, const M: usize, const W: usize, const V: usize> Kalman<Mo, Unscented<P>, C, N, M, W, V>
where
    C: Chart<N>,
{
    /// Sets the sigma points.
    ///
    /// # Errors
    /// [`EstimatorError::NoSigmaPoints`] for weights that give none in `N + W` or `N + V` dimensions.
    pub fn with_points(mut self, points: SigmaPoints) -> Result<Self, EstimatorError> {
        points.weights(N + W)?;
        points.weights(N + V)?;
        self.rule.points = points;
        Ok(self)
    }

    /// The sigma points.
    pub fn points(&self) -> SigmaPoints {
        self.rule.points
    }
}

/// Calls `visit` with state deviation and noise of every sigma point but the center, in pairs `+-`.
fn for_each_point<const N: usize, const W: usize>(
    root: &SMatrix<f64, N, N>,
    noise: &SMatrix<f64, W, W>,
    spread: f64,
    mut visit: impl FnMut(&SVector<f64, N>, &SVector<f64, W>),
) {
    for sign in [spread, -spread] {
        for column in root.column_iter() {
            visit(&(column * sign), &SVector::zeros());
        }
        for column in noise.column_iter() {
            visit(&SVector::zeros(), &(column * sign));
        }
    }
}

/// The weighted mean of points on a chart; the first is the center.
fn mean<C: Chart<N>, const N: usize>(images: &[C::Point], weights: &Weights) -> Result<C::Point, EstimatorError> {
    let [center, others @ ..] = images else {
        return Err(EstimatorError::NoConvergence { what: "mean of no sigma points" });
    };
    let (mut mean, mut previous) = (*center, f64::INFINITY);
    for _ in 0..MEAN_ITERATIONS {
        let mut step = C::difference(center, &mean)? * weights.mean;
        let mut farthest = step.norm();
        for image in others {
            let deviation = C::difference(image, &mean)?;
            farthest = farthest.max(deviation.norm());
            step += deviation * weights.others;
        }
        mean = C::shift(&mean, &step);
        let length = step.norm();
        if C::FLAT || length <= MEAN_TOLERANCE * farthest {
            return Ok(mean);
        }
        if length >= 0.9 * previous && (length <= STALLED.0 * farthest || farthest <= STALLED.1) {
            return Ok(mean);
        }
        previous = length;
    }
    Err(EstimatorError::NoConvergence { what: "mean of the sigma points" })
}

impl<Mo, C, const N: usize, const W: usize> Forecast<Mo, C, N, W> for Unscented<C::Point>
where
    C: Chart<N>,
    Mo: Motion<C, N, W>,
{
    fn forecast(
        &mut self,
        motion: &Mo,
        belief: &Gaussian<C, N>,
        process: &SMatrix<f64, W, W>,
        input: &Mo::Input,
    ) -> Result<Gaussian<C, N>, EstimatorError> {
        let weights = self.points.weights(N + W)?;
        let images = &mut self.images;
        images.clear();
        images.push(motion.transition(belief.mean(), input, &SVector::zeros()));
        for_each_point(belief.root(), process, weights.spread, |dx, w| {
            images.push(motion.transition(&C::shift(belief.mean(), dx), input, w));
        });
        for image in images.iter() {
            C::check(image)?;
        }
        let mean = mean::<C, N>(images, &weights)?;
        let mut joint = Joint::<N, 0>::new();
        let share = weights.others.sqrt();
        for image in &images[1..] {
            joint.add(SVector::zeros(), C::difference(image, &mean)? * share);
        }
        let center = C::difference(&images[0], &mean)? * weights.covariance.abs().sqrt();
        if weights.covariance >= 0.0 {
            joint.add(SVector::zeros(), center);
        } else {
            joint.remove("predicted covariance", SVector::zeros(), center)?;
        }
        Gaussian::checked(mean, *joint.states())
    }
}

impl<Se, C, P, const N: usize, const M: usize, const V: usize> Observe<Se, C, N, M, V> for Unscented<P>
where
    C: Chart<N, Point = P>,
    Se: Sensor<C, N, M, V>,
{
    fn observe(
        &mut self,
        sensor: &Se,
        belief: &Gaussian<C, N>,
        noise: &SMatrix<f64, V, V>,
        y: &SVector<f64, M>,
    ) -> Result<(Joint<N, M>, SVector<f64, M>), EstimatorError> {
        let weights = self.points.weights(N + V)?;
        let outputs = &mut self.outputs;
        outputs.clear();
        let center = sensor.output(belief.mean(), &SVector::zeros());
        let mut step = SVector::zeros();
        for_each_point(belief.root(), noise, weights.spread, |dx, v| {
            let output = sensor.output(&C::shift(belief.mean(), dx), v);
            step += sensor.residual(&output, &center) * weights.others;
            outputs.extend_from_slice(output.as_slice());
        });
        let predicted = center + step;
        let mut joint = Joint::new();
        let share = weights.others.sqrt();
        let mut images = outputs.iter().copied();
        for_each_point(belief.root(), noise, weights.spread, |dx, _| {
            // As many numbers as were kept above, also where there are no outputs.
            let output = SVector::from_iterator(images.by_ref().take(M));
            joint.add(sensor.residual(&output, &predicted) * share, dx * share);
        });
        let center = sensor.residual(&center, &predicted) * weights.covariance.abs().sqrt();
        if weights.covariance >= 0.0 {
            joint.add(center, SVector::zeros());
        } else {
            joint.remove("covariance of the outputs", center, SVector::zeros())?;
        }
        Ok((joint, sensor.residual(y, &predicted)))
    }
}
