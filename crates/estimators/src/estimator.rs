//! What every filter offers.

use crate::EstimatorError;

/// What the sets of a filter promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Guarantee {
    /// The state lies in every set if it lies in the first one and the noises keep their bounds; rounding included.
    Rigorous,
    /// As `Rigorous` for a linearised model: terms of second order are dropped, so the state can leave the set.
    FirstOrder,
    /// The sets are confidence regions.
    Statistical,
}

/// A recursive state estimator.
///
/// A call that returns an error leaves the estimator as it was.
pub trait Estimator {
    /// What drives the model over a step.
    type Input: ?Sized;
    /// What is measured.
    type Output: ?Sized;
    /// The form of the sets.
    type Set;

    /// From the estimate of `x_k` to that of `x_k+1`, without a measurement.
    ///
    /// # Errors
    /// Input that is not finite, a result that is not.
    fn predict(&mut self, input: &Self::Input) -> Result<(), EstimatorError>;

    /// Corrects the estimate of `x_k` by a measurement `y_k`.
    ///
    /// # Errors
    /// A measurement of the wrong length or not finite, a gain that does not exist.
    fn update(&mut self, output: &Self::Output) -> Result<(), EstimatorError>;

    /// From the estimate of `x_k` and the measurement `y_k` to the estimate of `x_k+1` (predictor form).
    ///
    /// # Errors
    /// Those of [`predict`](Self::predict) and [`update`](Self::update).
    fn step(&mut self, input: &Self::Input, output: &Self::Output) -> Result<(), EstimatorError>;

    /// Whether the measurements so far contradict the bounds. Filters without intersections cannot tell and answer `Ok`.
    ///
    /// # Errors
    /// A proven contradiction.
    fn consistency(&mut self) -> Result<(), EstimatorError> {
        Ok(())
    }

    /// The set of the last call.
    fn enclosure(&self) -> &Self::Set;

    /// What [`enclosure`](Self::enclosure) promises.
    fn guarantee(&self) -> Guarantee;
}
