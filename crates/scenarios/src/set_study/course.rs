//! One filter along one trajectory: [`follow`], and the [`Course`] that is noted of it.

use estimators::{EstimatorError, Phase};
use scalars::Interval;
use setrep::{Membership, SetError, Workspace};

use super::{SetEstimator, Trajectory};
use crate::ScenarioError;
use crate::region::{Containment, in_box};

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// With the last step.
    Complete,
    /// The filter proved a contradiction at this step.
    Contradiction(usize),
    /// The enclosures left the finite numbers at this step.
    Diverged(usize),
}

/// A size of a set.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// Its name in the rows.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its value.
    pub of: fn(&dyn SetEstimator, &mut Workspace) -> Result<f64, SetError>,
}

/// Half the longest side of the hull.
pub const RADIUS: Measure = Measure { name: "radius", unit: "", of: |filter, _| Ok(radius(filter.hull())) };

/// Half the longest side of a box.
#[must_use]
pub fn radius(hull: &[Interval]) -> f64 {
    hull.iter().map(Interval::rad).fold(0.0, f64::max)
}

/// What is noted of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// One sequence a measure, one value a step `k = 0 ..= N`; infinite from the step on at which the filter gave up.
    pub values: Vec<Vec<f64>>,
    /// The truth against the set and the hull, step by step.
    pub containment: Containment,
    /// How it ended.
    pub end: End,
}

impl Course {
    /// Runs a filter and notes measures and containment.
    ///
    /// # Errors
    /// Those of the set operations, and those of the filter that are neither contradictions nor a lack of bounds.
    pub fn of(
        trajectory: &Trajectory,
        filter: &mut dyn SetEstimator,
        measures: &[Measure],
    ) -> Result<Self, ScenarioError> {
        let (mut workspace, mut containment) = (Workspace::new(), Containment::default());
        let mut values = vec![Vec::with_capacity(trajectory.states.len()); measures.len()];
        let end = follow(trajectory, filter, &mut |_| {}, &mut |k, filter| {
            for (values, measure) in values.iter_mut().zip(measures) {
                values.push((measure.of)(filter, &mut workspace)?);
            }
            containment.add(verdict(&trajectory.states[k], filter, &mut workspace)?);
            Ok(())
        })?;
        if matches!(end, End::Contradiction(_)) {
            // The truth is proven to keep the bounds: a filter that is left without a state has lost it.
            containment.add(Membership::ProvenOutside);
        }
        values.iter_mut().for_each(|values| values.resize(trajectory.states.len(), f64::INFINITY));
        Ok(Self { values, containment, end })
    }
}

/// Runs a filter: an update at `k = 0`, then prediction and update; `observe` sees it after every update.
///
/// # Errors
/// Those of `observe`; those of the filter that are neither contradictions nor a lack of bounds.
pub fn follow(
    trajectory: &Trajectory,
    filter: &mut dyn SetEstimator,
    trace: &mut dyn FnMut(Phase),
    observe: &mut dyn FnMut(usize, &dyn SetEstimator) -> Result<(), ScenarioError>,
) -> Result<End, ScenarioError> {
    for (k, output) in trajectory.outputs.iter().enumerate() {
        let predicted = if k == 0 { Ok(()) } else { filter.predict(&trajectory.inputs[k - 1], trace) };
        match predicted.and_then(|()| filter.update(output, trace)) {
            Ok(()) => observe(k, filter)?,
            Err(EstimatorError::Inconsistent(_)) => return Ok(End::Contradiction(k)),
            Err(EstimatorError::Bound(_) | EstimatorError::Set(_) | EstimatorError::NotFinite { .. }) => {
                return Ok(End::Diverged(k));
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(End::Complete)
}

/// Whether the state lies in the set and in the hull, as far as its enclosure tells.
fn verdict(state: &[Interval], filter: &dyn SetEstimator, workspace: &mut Workspace) -> Result<Membership, SetError> {
    let in_hull = in_box(filter.hull(), state);
    let in_set = filter.region().membership(state, workspace)?;
    Ok(match (in_hull, in_set) {
        (Membership::ProvenOutside, _) | (_, Membership::ProvenOutside) => Membership::ProvenOutside,
        (Membership::ProvenInside, Membership::ProvenInside) => Membership::ProvenInside,
        _ => Membership::Undecided,
    })
}
