//! [`Track`]: the Rauch-Tung-Striebel smoother of linear and extended Kalman filters, on vector spaces and on groups.

use nalgebra::SVector;

use super::chart::Chart;
use super::ekf::{Ekf, LinearStep};
use super::gaussian::Gaussian;
use super::innovation::Joint;
use super::model::{Motion, SmoothMotion, SmoothSensor};
use super::root;
use crate::EstimatorError;

/// The predictions of a filter, from which the beliefs about all past states given all measurements are computed backwards.
///
/// ```text
/// G_k = P_k A_k' P_k+1|k^-1
/// e   = coordinates of the smoothed mean k+1 around the predicted one
/// mean k shifted by G_k e,   P_k+ = (P_k - G_k P_k+1|k G_k') + G_k P_k+1+ G_k'
/// ```
///
/// The bracket is a root that falls out of triangularising `x_k` and `x_k+1` together, so no covariance is subtracted and every
/// smoothed one is positive semidefinite. On a curved space means and corrections live in the coordinates of the chart, and covariances are
/// not moved between the coordinates around neighbouring means, to first order, as in a filter without the reset.
///
/// Every prediction from the first to the last must be remembered: one that is not leaves a gap that the smoother does not see.
///
/// **Guarantee:** exact for linear models; [`Guarantee::Statistical`](crate::Guarantee::Statistical), to first order, elsewhere.
/// **Source:** Rauch, Tung, Striebel 1965; on groups van der Laan, Cohen, Arsenault, Forbes, The invariant Rauch-Tung-Striebel smoother, 2020.
///
/// ```
/// use estimators::Estimator;
/// use estimators::kalman::{Gaussian, Kf, LinearModel, Track};
/// use nalgebra::{Matrix1, Vector1};
///
/// // A constant that is measured four times with variance 1: in hindsight it is known equally well at every step.
/// let one = Matrix1::identity();
/// let start = Gaussian::new(Vector1::new(0.0), &Matrix1::new(1e6))?;
/// let mut filter = Kf::new(LinearModel::new(one, one, one)?, start, &Matrix1::zeros(), &one)?;
/// let mut track = Track::with_capacity(3);
/// for (k, y) in [1.0, 3.0, 2.0, 4.0].into_iter().enumerate() {
///     if k > 0 {
///         filter.predict_into(&Vector1::zeros(), &mut track)?;
///     }
///     filter.update(&[y])?;
/// }
/// let beliefs = track.smooth(filter.belief())?;
/// assert!(beliefs.iter().all(|belief| (belief.mean()[0] - 2.5).abs() < 1e-5));
/// assert!((beliefs[0].covariance()[0] - 0.25).abs() < 1e-6);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Track<C: Chart<N>, const N: usize> {
    passes: Vec<Pass<C, N>>,
}

/// One prediction.
#[derive(Debug, Clone, Copy)]
struct Pass<C: Chart<N>, const N: usize> {
    /// Mean before it.
    from: C::Point,
    /// Mean after it.
    to: C::Point,
    /// Errors after ("outputs") and before it ("states").
    joint: Joint<N, N>,
}

impl<C: Chart<N>, const N: usize> Pass<C, N> {
    /// The belief before the prediction given that after it.
    fn before(&self, after: &Gaussian<C, N>) -> Result<Gaussian<C, N>, EstimatorError> {
        let error = C::difference(after.mean(), &self.to)?;
        let mut spread = *self.joint.states();
        for column in after.root().column_iter() {
            root::add(&mut spread, self.joint.gain(&column.into_owned()));
        }
        Gaussian::checked(C::shift(&self.from, &self.joint.gain(&error)), spread)
    }
}

impl<C: Chart<N>, const N: usize> Default for Track<C, N> {
    fn default() -> Self {
        Self::with_capacity(0)
    }
}

impl<C: Chart<N>, const N: usize> Track<C, N> {
    /// No predictions yet; the first `steps` of them allocate nothing.
    #[must_use]
    pub fn with_capacity(steps: usize) -> Self {
        Self { passes: Vec::with_capacity(steps) }
    }

    /// Number of predictions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.passes.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.passes.is_empty()
    }

    /// Forgets all predictions and keeps the room.
    pub fn clear(&mut self) {
        self.passes.clear();
    }

    /// The beliefs before each prediction and, at the end, the `last` one of the filter: one more than predictions.
    ///
    /// # Errors
    /// A mean that the chart does not reach from the predicted one, results that are not finite.
    pub fn smooth(&self, last: &Gaussian<C, N>) -> Result<Vec<Gaussian<C, N>>, EstimatorError> {
        let mut beliefs = vec![*last; self.passes.len() + 1];
        for (k, pass) in self.passes.iter().enumerate().rev() {
            beliefs[k] = pass.before(&beliefs[k + 1])?;
        }
        Ok(beliefs)
    }
}

impl<Mo, C, const N: usize, const M: usize, const W: usize, const V: usize> Ekf<Mo, C, N, M, W, V>
where
    C: Chart<N>,
    Mo: SmoothMotion<C, N, W> + SmoothSensor<C, N, M, V>,
{
    /// [`predict`](crate::Estimator::predict), to the same bits, remembered in a track.
    ///
    /// # Errors
    /// As `predict`; nothing is then remembered.
    pub fn predict_into(&mut self, input: &Mo::Input, track: &mut Track<C, N>) -> Result<(), EstimatorError> {
        Motion::<C, N, W>::check(&self.model)?;
        self.model.check_input(input)?;
        let from = *self.belief.mean();
        let LinearStep { map, noises, to } = LinearStep::new(&self.model, &from, &self.process, input);
        let mut joint = Joint::<N, N>::new();
        for x in self.belief.root().column_iter() {
            joint.add(map * x, x.into_owned());
        }
        for noise in noises.column_iter() {
            joint.add(noise.into_owned(), SVector::zeros());
        }
        self.belief = Gaussian::checked(to, *joint.outputs())?;
        track.passes.push(Pass { from, to, joint });
        Ok(())
    }
}
