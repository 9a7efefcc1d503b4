//! The filters of the experiment.

use estimators::{Estimator, EstimatorError, Phase, Rcz, RczOptions, RczState};
use scalars::Interval;
use setrep::ConstrainedZonotope;

use super::plant::{start, system};
use crate::figure::Look;
use crate::region::Region;
use crate::set_study::{Contender, SetEstimator};
use crate::{Mode, ScenarioError};

/// Names of the filters, the tightest first, and what distinguishes each.
pub const METHODS: [(&str, &str); 3] = [
    ("rcz", "`RczOptions::slow`: re-encoding every 10th step, 2 n constraints chosen by linear programs"),
    ("rcz/every-step", "re-encoding at every step, n constraints chosen by single rows"),
    ("rcz/box", "the interval hull after every update instead of the set"),
];

/// The filters for `n` tanks.
#[must_use]
pub fn contenders(n: usize) -> Vec<Contender> {
    METHODS.iter().map(|(name, _)| Contender::new(*name, Mode::Rigorous, move |()| build(name, n))).collect()
}

/// The filter of a name.
///
/// # Errors
/// Those of the filter.
fn build(name: &str, n: usize) -> Result<Box<dyn SetEstimator>, ScenarioError> {
    let filter = |options| -> Result<Rcz, ScenarioError> { Ok(Rcz::new(system(n)?, start(n)?, options)?) };
    Ok(match name {
        "rcz" => Box::new(filter(RczOptions::slow(n))?),
        "rcz/every-step" => Box::new(filter(RczOptions { constraints: n, ..RczOptions::fast(n) })?),
        _ => {
            let filter = filter(RczOptions { constraints: 0, ..RczOptions::fast(n) })?;
            Box::new(Boxed { spare: filter.state().clone(), filter })
        }
    })
}

/// How the curves of a filter look.
#[must_use]
pub fn look(method: &str) -> Look {
    METHODS.iter().position(|(name, _)| *name == method).map_or(Look::REFERENCE, |index| Look::nth(index).solid())
}

/// A filter that keeps nothing but the hull.
#[derive(Debug)]
struct Boxed {
    filter: Rcz,
    /// The state with its hull as set.
    spare: RczState,
}

impl SetEstimator for Boxed {
    fn predict(&mut self, input: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        self.filter.predict_traced(input, trace)
    }

    fn update(&mut self, output: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        SetEstimator::update(&mut self.filter, output, trace)?;
        self.spare.clone_from(self.filter.state());
        self.spare.set = ConstrainedZonotope::from_intervals(&self.spare.hull)?;
        self.filter.restore(&self.spare)
    }

    fn hull(&self) -> &[Interval] {
        self.filter.hull()
    }

    fn region(&self) -> &dyn Region {
        self.filter.enclosure()
    }
}
