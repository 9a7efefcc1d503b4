//! Monte Carlo runs of all filters on the same noises.

use super::filters::Contender;
use super::plant::{Rates, Truth, simulate};
use crate::contest::{Cell, Course, Noise, Watch, follow};
use crate::{Context, ScenarioError, monte_carlo};

/// Steps of a run, 25 min: with the steps left out, the fit to all four entries of Table 1.
pub const STEPS: usize = 1500;
/// Steps left out of the root mean squares, 28 s.
pub const DROPPED: usize = 28;
/// Steps at which half widths are shown.
pub const MARKS: [usize; 7] = [1, 10, 30, 60, 120, 300, 1500];
/// Steps with rates per second.
pub const STEPS_PER_SECOND: usize = 200;

/// Half widths beyond this, atm, are a divergence: the pressures themselves are below 5.
const LIMIT: f64 = 50.0;

/// A setting of the plant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setting {
    /// Time unit of the rates.
    pub rates: Rates,
    /// Measurement noise.
    pub noise: Noise,
    /// Number of steps.
    pub steps: usize,
}

impl Setting {
    /// The paper's plant.
    #[must_use]
    pub fn of_the_paper(noise: Noise) -> Self {
        Self { rates: Rates::PerMinute, noise, steps: STEPS }
    }

    /// The truth of run `run`: the same for all filters.
    ///
    /// # Errors
    /// [`ScenarioError::Truth`] if it cannot be proven.
    pub fn truth(&self, context: &Context<'_>, run: usize) -> Result<Truth, ScenarioError> {
        let rng = &mut monte_carlo::stream(context.seed, "batch-reactor", run);
        Ok(simulate(self.rates, self.noise, self.steps, rng)?)
    }

    fn watch(&self) -> Watch<'static> {
        Watch { late: DROPPED, marks: &MARKS, limit: LIMIT, stride: 1 }
    }
}

/// Runs all filters; one cell each.
///
/// # Errors
/// Truths that cannot be proven; a filter that fails has diverged.
pub fn study(
    context: &Context<'_>,
    runs: usize,
    setting: Setting,
    label: &str,
    contenders: &[Contender],
) -> Result<Vec<Cell<2>>, ScenarioError> {
    let by_run = monte_carlo::run(context, &format!("batch-reactor {label}"), runs, |run, _| {
        let truth = setting.truth(context, run)?;
        let record = |contender: &Contender| {
            let mut filter = contender.start(setting.rates)?;
            follow(&mut *filter, &truth.states, &truth.outputs, &setting.watch(), |_, _| {})
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
) -> Result<(Truth, Course<2>), ScenarioError> {
    let truth = setting.truth(context, run)?;
    let mut course = Vec::with_capacity(setting.steps);
    let mut filter = contender.start(setting.rates)?;
    follow(&mut *filter, &truth.states, &truth.outputs, &setting.watch(), |center, half_widths| {
        course.push((center, half_widths));
    })?;
    Ok((truth, course))
}
