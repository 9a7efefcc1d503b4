//! Monte Carlo runs of all filters on the same noises.

use super::filters::{Contender, ESTIMATE};
use super::plant::{Bearing, Truth, simulate};
use crate::contest::{Cell, Course, Noise, Watch, follow};
use crate::{Context, ScenarioError, monte_carlo};

/// Steps of a run, 520 s: errors grow with the range, so the paper's Table 2 says how long its runs were, to about 5 %.
pub const STEPS: usize = 1040;
/// Steps at which half widths are shown.
pub const MARKS: [usize; 5] = [1, 10, 100, 500, 1000];

/// Half widths beyond this, m or m/s, are a divergence.
const LIMIT: f64 = 1e4;
/// Containment in sets of thousands of generators is looked at now and then.
const STRIDE: usize = 20;

/// A setting of plant and filters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// What stands for the bearing.
    pub bearing: Bearing,
    /// Noises.
    pub noise: Noise,
    /// Number of steps.
    pub steps: usize,
    /// Initial estimate.
    pub estimate: [f64; 4],
}

impl Setting {
    /// The settings that fit the paper's tables.
    #[must_use]
    pub fn fitted(noise: Noise) -> Self {
        Self { bearing: Bearing::Atan, noise, steps: STEPS, estimate: ESTIMATE }
    }

    /// The truth of run `run`: drawn anew for each, the same for all filters.
    #[must_use]
    pub fn truth(&self, context: &Context<'_>, run: usize) -> Truth {
        simulate(self.bearing, self.noise, self.steps, &mut monte_carlo::stream(context.seed, "vehicle-polar", run))
    }

    fn watch() -> Watch<'static> {
        Watch { late: 0, marks: &MARKS, limit: LIMIT, stride: STRIDE }
    }
}

/// Runs all filters; one cell each.
///
/// # Errors
/// Those of looking at a set; a filter that fails has diverged.
pub fn study(
    context: &Context<'_>,
    runs: usize,
    setting: Setting,
    label: &str,
    contenders: &[Contender],
) -> Result<Vec<Cell<4>>, ScenarioError> {
    let by_run = monte_carlo::run(context, &format!("vehicle-polar {label}"), runs, |run, _| {
        let truth = setting.truth(context, run);
        let record = |contender: &Contender| {
            let mut filter = contender.start(setting.bearing, setting.estimate)?;
            follow(&mut *filter, &truth.states, &truth.outputs, &Setting::watch(), |_, _| {})
        };
        contenders.iter().map(record).collect::<Result<Vec<_>, ScenarioError>>()
    })?;
    let cell = |(index, contender): (usize, &Contender)| Cell {
        label: label.to_owned(),
        method: contender.method.to_owned(),
        mode: contender.mode(),
        runs: by_run.iter().map(|records| records[index].clone()).collect(),
    };
    Ok(contenders.iter().enumerate().map(cell).collect())
}

/// One run of one filter, step by step.
///
/// # Errors
/// As [`study`].
pub fn course(
    context: &Context<'_>,
    setting: Setting,
    contender: &Contender,
    run: usize,
) -> Result<(Truth, Course<4>), ScenarioError> {
    let truth = setting.truth(context, run);
    let mut course = Vec::with_capacity(setting.steps);
    let mut filter = contender.start(setting.bearing, setting.estimate)?;
    follow(&mut *filter, &truth.states, &truth.outputs, &Setting::watch(), |center, half_widths| {
        course.push((center, half_widths));
    })?;
    Ok((truth, course))
}
