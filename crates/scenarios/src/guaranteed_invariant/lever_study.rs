//! Study (b): the nine settings of Problem 3.

use crate::guaranteed_invariant::lever::simulate;
use crate::guaranteed_invariant::lever_run::LeverRun;
use crate::guaranteed_invariant::settings::{FIX_EVERY, SETTINGS, Setting};
use crate::{Context, ScenarioError, monte_carlo};

/// Runs of a setting, one entry a run.
pub type Runs = Vec<LeverRun>;

/// Runs every setting `runs` times; run `i` has the same random numbers in all of them.
///
/// # Errors
/// Those of the filter and of the simulator.
pub fn study(context: &Context<'_>, runs: usize) -> Result<Vec<Runs>, ScenarioError> {
    let all = monte_carlo::run(context, "scale and lever arm", SETTINGS.len() * runs, |index, _| {
        run(context, &SETTINGS[index / runs], index % runs)
    })?;
    Ok(all.chunks(runs).map(<[LeverRun]>::to_vec).collect())
}

fn run(context: &Context<'_>, setting: &Setting, run: usize) -> Result<LeverRun, ScenarioError> {
    let bounds = setting.step_bounds();
    let mut rng = monte_carlo::stream(context.seed, "guaranteed-invariant, lever", run);
    let noise = (setting.kind, &bounds);
    let truth = simulate(setting.constants, setting.increments(), FIX_EVERY, noise, &mut rng)?;
    LeverRun::new(&truth, &bounds)
}
