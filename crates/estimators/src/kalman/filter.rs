//! [`Kalman`]: what the filters of this family have in common.

use nalgebra::{SMatrix, SVector};

use super::chart::Chart;
use super::gaussian::Gaussian;
use super::innovation::{Innovation, Joint};
use super::model::{Motion, Sensor};
use super::root;
use crate::error::{check_finite, check_size};
use crate::{Estimator, EstimatorError, Guarantee};

/// How a belief goes through a motion: what makes a filter an [`Ekf`](super::Ekf) or a [`Ukf`](super::Ukf).
pub trait Forecast<Mo: Motion<C, N, W>, C: Chart<N>, const N: usize, const W: usize> {
    /// The belief after a step; `process` is the root of the noises' covariance.
    ///
    /// # Errors
    /// Results that are not finite, a covariance that is not one.
    fn forecast(
        &mut self,
        motion: &Mo,
        belief: &Gaussian<C, N>,
        process: &SMatrix<f64, W, W>,
        input: &Mo::Input,
    ) -> Result<Gaussian<C, N>, EstimatorError>;
}

/// How a belief goes through a sensor.
pub trait Observe<Se: Sensor<C, N, M, V>, C: Chart<N>, const N: usize, const M: usize, const V: usize> {
    /// The joint spread of outputs and states, and the innovation of `y`; `noise` is the root of the noises' covariance.
    ///
    /// # Errors
    /// A covariance that is not one.
    fn observe(
        &mut self,
        sensor: &Se,
        belief: &Gaussian<C, N>,
        noise: &SMatrix<f64, V, V>,
        y: &SVector<f64, M>,
    ) -> Result<(Joint<N, M>, SVector<f64, M>), EstimatorError>;
}

/// A Kalman filter with `N` states, `M` outputs, `W` process noises and `V` output noises; [`Ekf`](super::Ekf), [`Ukf`](super::Ukf) and
/// [`Kf`](super::Kf) are its forms.
///
/// The belief is a [`Gaussian`] kept as a square root. An update triangularises the joint root of outputs and states, which gives gain,
/// innovation and corrected root at once (`Joint`): algebraically the covariance in Joseph's form, and positive semidefinite
/// whatever rounding does. **Reset:** on a curved space the corrected covariance belongs to coordinates around the predicted mean;
/// [`with_reset`](Self::with_reset) moves it to those around the corrected one. Off by default, as published filters have it.
///
/// A call that fails leaves the filter as it was; a step allocates nothing once it has run.
///
/// **Guarantee:** [`Guarantee::Statistical`].
#[derive(Debug, Clone)]
pub struct Kalman<Mo, Rule, C: Chart<N>, const N: usize, const M: usize, const W: usize, const V: usize> {
    pub(super) model: Mo,
    pub(super) rule: Rule,
    pub(super) belief: Gaussian<C, N>,
    pub(super) process: SMatrix<f64, W, W>,
    noise: SMatrix<f64, V, V>,
    innovation: Option<Innovation<M>>,
    reset: bool,
    /// Largest accepted NIS of the model's own sensor.
    gate: f64,
}

impl<Mo, Rule, C, const N: usize, const M: usize, const W: usize, const V: usize> Kalman<Mo, Rule, C, N, M, W, V>
where
    C: Chart<N>,
    Mo: Motion<C, N, W> + Sensor<C, N, M, V>,
    Rule: Forecast<Mo, C, N, W> + Observe<Mo, C, N, M, V>,
{
    /// A filter that starts with a belief about `x_0`, for noises `w` and `v` of covariances `process` (`Q`) and `noise` (`R`).
    ///
    /// # Errors
    /// [`EstimatorError::Size`] for a model of other sizes, [`EstimatorError::NotFinite`], [`EstimatorError::NotSymmetric`],
    /// [`EstimatorError::NotPositive`] for the covariances.
    pub fn new(
        model: Mo,
        initial: Gaussian<C, N>,
        process: &SMatrix<f64, W, W>,
        noise: &SMatrix<f64, V, V>,
    ) -> Result<Self, EstimatorError>
    where
        Rule: Default,
    {
        Motion::<C, N, W>::check(&model)?;
        Sensor::<C, N, M, V>::check(&model)?;
        let process = root::factor("covariance of the process noise", process)?;
        let noise = root::factor("covariance of the output noise", noise)?;
        let rule = Rule::default();
        Ok(Self { model, rule, belief: initial, process, noise, innovation: None, reset: false, gate: f64::INFINITY })
    }

    /// Whether the covariance is moved to the coordinates around the corrected mean.
    #[must_use]
    pub fn with_reset(mut self, reset: bool) -> Self {
        self.reset = reset;
        self
    }

    /// Refuses measurements of the model's own sensor whose [`nis`](Innovation::nis) exceeds `limit`: the update is then
    /// [`EstimatorError::Gated`] and the belief stays the predicted one. Infinite (no gate) by default.
    ///
    /// If the model is right, a share of `1 - p` of the measurements exceeds the `p`-quantile of the chi-squared distribution with `M`
    /// degrees of freedom: for `p` = 99 % these are 6.63, 9.21, 11.34, 13.28 for `M` = 1 to 4, for 99.9 % 10.83, 13.82, 16.27, 18.47.
    ///
    /// # Errors
    /// [`EstimatorError::NotPositive`] for a limit that is NaN or not positive.
    pub fn with_gate(mut self, limit: f64) -> Result<Self, EstimatorError> {
        if limit > 0.0 {
            self.gate = limit;
            Ok(self)
        } else {
            Err(EstimatorError::NotPositive { what: "gate", index: 0, value: limit })
        }
    }

    /// The belief.
    pub fn belief(&self) -> &Gaussian<C, N> {
        &self.belief
    }

    /// Replaces the belief: a restart, or a saved state.
    pub fn set_belief(&mut self, belief: Gaussian<C, N>) {
        (self.belief, self.innovation) = (belief, None);
    }

    /// The model.
    pub fn model(&self) -> &Mo {
        &self.model
    }

    /// The model, to be changed between steps.
    pub fn model_mut(&mut self) -> &mut Mo {
        &mut self.model
    }

    /// Replaces the covariances of the noises, from the next call on.
    ///
    /// # Errors
    /// As [`new`](Self::new); nothing is then replaced.
    pub fn set_noises(
        &mut self,
        process: &SMatrix<f64, W, W>,
        noise: &SMatrix<f64, V, V>,
    ) -> Result<(), EstimatorError> {
        let process = root::factor("covariance of the process noise", process)?;
        let noise = root::factor("covariance of the output noise", noise)?;
        (self.process, self.noise) = (process, noise);
        Ok(())
    }

    /// The innovation of the last update by the model's own sensor; `None` before the first.
    pub fn innovation(&self) -> Option<&Innovation<M>> {
        self.innovation.as_ref()
    }

    /// An update by another sensor, whose noise has the covariance `noise`; its innovation. The gate is not asked.
    ///
    /// # Errors
    /// As [`Estimator::update`] and [`new`](Self::new).
    pub fn update_by<Se, const K: usize, const L: usize>(
        &mut self,
        sensor: &Se,
        noise: &SMatrix<f64, L, L>,
        y: &SVector<f64, K>,
    ) -> Result<Innovation<K>, EstimatorError>
    where
        Se: Sensor<C, N, K, L>,
        Rule: Observe<Se, C, N, K, L>,
    {
        sensor.check()?;
        check_finite("output", y.as_slice())?;
        let noise = root::factor("covariance of the output noise", noise)?;
        let (joint, residual) = self.rule.observe(sensor, &self.belief, &noise, y)?;
        self.correct(&joint, residual, f64::INFINITY)
    }

    fn correct<const K: usize>(
        &mut self,
        joint: &Joint<N, K>,
        residual: SVector<f64, K>,
        gate: f64,
    ) -> Result<Innovation<K>, EstimatorError> {
        let (shift, mut root, innovation) = joint.condition(residual)?;
        let nis = innovation.nis();
        if nis > gate {
            return Err(EstimatorError::Gated { nis, limit: gate });
        }
        check_finite("correction", shift.as_slice())?;
        if self.reset && !C::FLAT {
            root = root::triangular(&(C::transport(&shift) * root));
        }
        self.belief = Gaussian::checked(C::shift(self.belief.mean(), &shift), root)?;
        Ok(innovation)
    }
}

impl<Mo, Rule, C, const N: usize, const M: usize, const W: usize, const V: usize> Estimator
    for Kalman<Mo, Rule, C, N, M, W, V>
where
    C: Chart<N>,
    Mo: Motion<C, N, W> + Sensor<C, N, M, V>,
    Rule: Forecast<Mo, C, N, W> + Observe<Mo, C, N, M, V>,
{
    type Input = Mo::Input;
    type Output = [f64];
    /// The belief: its ellipsoids are confidence regions.
    type Set = Gaussian<C, N>;

    fn predict(&mut self, input: &Mo::Input) -> Result<(), EstimatorError> {
        Motion::<C, N, W>::check(&self.model)?;
        self.model.check_input(input)?;
        self.belief = self.rule.forecast(&self.model, &self.belief, &self.process, input)?;
        Ok(())
    }

    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        check_size("output", M, output.len())?;
        check_finite("output", output)?;
        Sensor::<C, N, M, V>::check(&self.model)?;
        let y = SVector::from_column_slice(output);
        let (joint, residual) = self.rule.observe(&self.model, &self.belief, &self.noise, &y)?;
        self.innovation = Some(self.correct(&joint, residual, self.gate)?);
        Ok(())
    }

    fn step(&mut self, input: &Mo::Input, output: &[f64]) -> Result<(), EstimatorError> {
        let (belief, innovation) = (self.belief, self.innovation);
        self.update(output)?;
        self.predict(input).inspect_err(|_| (self.belief, self.innovation) = (belief, innovation))
    }

    fn enclosure(&self) -> &Gaussian<C, N> {
        &self.belief
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::Statistical
    }
}
