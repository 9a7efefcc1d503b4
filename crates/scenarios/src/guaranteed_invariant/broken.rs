//! Noises beyond the bounds that the filter is told: when it proves that something is wrong.

use crate::guaranteed_invariant::follow::{Start, StripRun};
use crate::guaranteed_invariant::noise::{Drive, truth_of};
use crate::{Context, ScenarioError, monte_carlo};

/// Steps of a run.
pub const STEPS: usize = 400;
/// The noises are this many times their bounds; the first keeps them.
pub const EXCESS: [f64; 3] = [1.0, 1.05, 1.2];
/// Noises of the study.
pub const DRIVES: [Drive; 2] = [Drive::Uniform, Drive::Dwell];

/// All runs of one noise and excess.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// The noises.
    pub drive: Drive,
    /// How many times their bounds.
    pub excess: f64,
    /// Step of the proof, run by run; none if there was none.
    pub steps: Vec<Option<usize>>,
}

impl Broken {
    /// The steps of the proofs.
    #[must_use]
    pub fn found(&self) -> Vec<f64> {
        self.steps.iter().flatten().map(|&step| step as f64).collect()
    }
}

/// Runs the study, heading unknown.
///
/// # Errors
/// Those of the filter and of the simulator.
pub fn study(context: &Context<'_>, runs: usize) -> Result<Vec<Broken>, ScenarioError> {
    let plan: Vec<(Drive, f64)> = DRIVES.into_iter().flat_map(|drive| EXCESS.map(|excess| (drive, excess))).collect();
    let found = monte_carlo::run(context, "broken bounds", plan.len() * runs, |index, _| {
        let (drive, excess) = plan[index / runs];
        let truth = truth_of(context, drive, excess, STEPS, index % runs)?;
        Ok::<_, ScenarioError>(StripRun::new(&truth, Start::UnknownHeading, |_, _| Ok(()))?.contradiction)
    })?;
    let broken = |(&(drive, excess), steps): (&(Drive, f64), &[_])| Broken { drive, excess, steps: steps.to_vec() };
    Ok(plan.iter().zip(found.chunks(runs)).map(broken).collect())
}
