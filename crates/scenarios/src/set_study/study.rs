//! Many runs of several filters on the same noises.

use rand_chacha::ChaCha8Rng;

use super::{Contender, Course, End, Measure, Trajectory};
use crate::results::mean_and_sd;
use crate::{Context, Mode, ScenarioError, monte_carlo};

/// The runs of one filter.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// The filter's name.
    pub method: String,
    /// Its mode.
    pub mode: Mode,
    /// What was noted, run by run.
    pub runs: Vec<Course>,
}

impl Cell {
    /// A measure at one step, run by run.
    #[must_use]
    pub fn at(&self, measure: usize, step: usize) -> Vec<f64> {
        self.runs.iter().filter_map(|run| run.values[measure].get(step).copied()).collect()
    }

    /// Averages of a measure over the steps `from ..= to`, run by run.
    #[must_use]
    pub fn averages(&self, measure: usize, from: usize, to: usize) -> Vec<f64> {
        let average = |run: &Course| {
            let values = &run.values[measure];
            let some = &values[from.min(values.len())..values.len().min(to.saturating_add(1))];
            mean_and_sd(some).map(|(mean, _)| mean)
        };
        self.runs.iter().filter_map(average).collect()
    }

    /// Averages of a measure over the runs, step by step.
    #[must_use]
    pub fn curve(&self, measure: usize) -> Vec<f64> {
        let steps = self.runs.first().map_or(0, |run| run.values[measure].len());
        (0..steps).map(|k| mean_and_sd(&self.at(measure, k)).map_or(f64::NAN, |(mean, _)| mean)).collect()
    }

    /// Number of runs that ended with a proven contradiction.
    #[must_use]
    pub fn contradictions(&self) -> usize {
        self.runs.iter().filter(|run| matches!(run.end, End::Contradiction(_))).count()
    }

    /// Number of runs whose enclosures left the finite numbers.
    #[must_use]
    pub fn diverged(&self) -> usize {
        self.runs.iter().filter(|run| matches!(run.end, End::Diverged(_))).count()
    }
}

/// Runs every contender along the same trajectories, drawn by `simulate` from the stream of each run.
///
/// `label` fixes the random streams and labels the progress: studies of the same label have the same noises.
///
/// # Errors
/// Those of the simulator and of the filters.
pub fn study<F>(
    context: &Context<'_>,
    label: &str,
    runs: usize,
    simulate: F,
    contenders: &[Contender],
    measures: &[Measure],
) -> Result<Vec<Cell>, ScenarioError>
where
    F: Fn(&mut ChaCha8Rng) -> Result<Trajectory, ScenarioError> + Sync,
{
    let by_run = monte_carlo::run(context, label, runs, |_, rng| {
        let trajectory = simulate(rng)?;
        let course = |contender: &Contender| Course::of(&trajectory, &mut *contender.start(())?, measures);
        contenders.iter().map(course).collect::<Result<Vec<_>, ScenarioError>>()
    })?;
    let mut cells: Vec<Cell> = contenders
        .iter()
        .map(|contender| Cell { method: contender.method.clone(), mode: contender.mode, runs: Vec::new() })
        .collect();
    for courses in by_run {
        cells.iter_mut().zip(courses).for_each(|(cell, course)| cell.runs.push(course));
    }
    Ok(cells)
}

/// The cell of a method in a mode.
#[must_use]
pub fn find<'a>(cells: &'a [Cell], method: &str, mode: Mode) -> Option<&'a Cell> {
    cells.iter().find(|cell| cell.method == method && cell.mode == mode)
}
