//! Study (b): the nine settings of Problem 3.

use crate::guaranteed_invariant::lever::simulate;
use crate::guaranteed_invariant::lever_run::LeverRun;
use crate::guaranteed_invariant::settings::{FIX_EVERY, SETTINGS, SHARP, Setting};
use crate::{Context, ScenarioError, monte_carlo};

/// Runs of a setting, one entry a run; empty if it is left out.
pub type Runs = Vec<LeverRun>;

/// Settings of quick mode, as indices in [`SETTINGS`].
const QUICK: [usize; 3] = [2, 3, SHARP];

/// Runs every setting (in quick mode three) `runs` times; run `i` has the same random numbers in all of them.
///
/// # Errors
/// Those of the filter and of the simulator.
pub fn study(context: &Context<'_>, runs: usize) -> Result<Vec<Runs>, ScenarioError> {
    let settings: Vec<usize> = (0..SETTINGS.len()).filter(|index| !context.quick || QUICK.contains(index)).collect();
    let all = monte_carlo::run(context, "scale and lever arm", settings.len() * runs, |index, _| {
        run(context, &SETTINGS[settings[index / runs]], index % runs)
    })?;
    let mut studies = vec![Runs::new(); SETTINGS.len()];
    for (&setting, runs) in settings.iter().zip(all.chunks(runs)) {
        studies[setting] = runs.to_vec();
    }
    Ok(studies)
}

fn run(context: &Context<'_>, setting: &Setting, run: usize) -> Result<LeverRun, ScenarioError> {
    let bounds = setting.step_bounds();
    let mut rng = monte_carlo::stream(context.seed, "guaranteed-invariant, lever", run);
    let noise = (setting.kind, &bounds);
    let truth = simulate(setting.constants, setting.increments(), FIX_EVERY, noise, &mut rng)?;
    LeverRun::new(&truth, &bounds)
}
