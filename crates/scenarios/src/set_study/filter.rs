//! [`SetEstimator`]: what a study asks of a filter, whatever its sets.

use estimators::{Estimator, EstimatorError, Method, Phase, SetFilter};
use scalars::Interval;

use crate::region::Region;

/// A filter of a study with its settings.
pub type Contender = crate::contender::Contender<(), dyn SetEstimator>;

/// A set-valued filter.
pub trait SetEstimator {
    /// From `x_k` to `x_{k+1}`; `trace` is called at the end of each phase.
    ///
    /// # Errors
    /// Those of the filter, which is then unchanged.
    fn predict(&mut self, input: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError>;

    /// Cuts the set with a measurement of all outputs, and with the invariant where the filter uses it.
    ///
    /// # Errors
    /// Those of the filter, which is then unchanged.
    fn update(&mut self, output: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError>;

    /// A box that holds the state.
    fn hull(&self) -> &[Interval];

    /// The set.
    fn region(&self) -> &dyn Region;
}

impl<M: Method> SetEstimator for SetFilter<M>
where
    M::Set: Region,
{
    fn predict(&mut self, input: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        self.predict_traced(input, trace)
    }

    fn update(&mut self, output: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        let output: Vec<Option<f64>> = output.iter().copied().map(Some).collect();
        self.update_traced(&output, &[], trace)
    }

    fn hull(&self) -> &[Interval] {
        SetFilter::hull(self)
    }

    fn region(&self) -> &dyn Region {
        self.enclosure()
    }
}
