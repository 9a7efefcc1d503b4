//! Monte Carlo runs of several filters from several initial estimates, all on the same noises.

use std::time::Instant;

use crate::inzsmf::cases::{STEPS, TABLE_I};
use crate::inzsmf::tracking::{Tracker, metrics_of};
use crate::metrics::RunMetrics;
use crate::noise::NoiseKind;
use crate::vehicle::{Pose, Truth, Vehicle};
use crate::{Context, Mode, ScenarioError, monte_carlo};

/// Name of the random streams: run `i` has the same noises in every study, for every filter and every initial estimate.
const STREAMS: &str = "inzsmf";

/// Repetitions of a timed run.
const TIMING_REPETITIONS: usize = 5;

/// A filter with its settings, ready to be started at an initial estimate.
pub type Contender = crate::contender::Contender<Pose, dyn Tracker>;

/// The metrics of all runs of one filter from one initial estimate.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Index in [`TABLE_I`].
    pub case: usize,
    /// The filter's name.
    pub method: String,
    /// Its mode.
    pub mode: Mode,
    /// Metrics, run by run.
    pub runs: Vec<RunMetrics>,
}

impl Cell {
    /// One metric of all runs; `metric` is an index in [`RunMetrics::NAMES`].
    #[must_use]
    pub fn samples(&self, metric: usize) -> Vec<f64> {
        self.runs.iter().map(|run| run.values()[metric]).collect()
    }

    /// Mean over the runs of one metric.
    #[must_use]
    pub fn mean(&self, metric: usize) -> f64 {
        self.samples(metric).iter().sum::<f64>() / self.runs.len() as f64
    }
}

/// The truth of run `run`.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn truth_of(context: &Context<'_>, kind: NoiseKind, steps: usize, run: usize) -> Result<Truth, ScenarioError> {
    Ok(Vehicle::new().simulate(kind, steps, &mut monte_carlo::stream(context.seed, STREAMS, run))?)
}

/// Runs every pair (initial estimate, contender) with uniform noises; one cell a pair, in their order.
///
/// # Errors
/// Those of the filters.
pub fn study(
    context: &Context<'_>,
    label: &str,
    runs: usize,
    pairs: &[(usize, &Contender)],
) -> Result<Vec<Cell>, ScenarioError> {
    let by_run = monte_carlo::run(context, label, runs, |run, _| {
        let truth = truth_of(context, NoiseKind::Uniform, STEPS, run)?;
        let metrics =
            |&(case, contender): &(usize, &Contender)| metrics_of(&truth, &mut *contender.start(TABLE_I[case].pose)?);
        pairs.iter().map(metrics).collect::<Result<Vec<_>, ScenarioError>>()
    })?;
    let cell = |(index, &(case, contender)): (usize, &(usize, &Contender))| Cell {
        case,
        method: contender.method.clone(),
        mode: contender.mode,
        runs: by_run.iter().map(|metrics| metrics[index]).collect(),
    };
    Ok(pairs.iter().enumerate().map(cell).collect())
}

/// The cell of a case, a method and a mode.
#[must_use]
pub fn find<'a>(cells: &'a [Cell], case: usize, method: &str, mode: Mode) -> Option<&'a Cell> {
    cells.iter().find(|cell| cell.case == case && cell.method == method && cell.mode == mode)
}

/// Mean wall-clock time of one step, in seconds, metrics included: the fastest of a few repetitions of one run.
///
/// # Errors
/// Those of the filter.
pub fn step_time_s(
    context: &Context<'_>,
    truth: &Truth,
    contender: &Contender,
    case: usize,
) -> Result<f64, ScenarioError> {
    let mut fastest = f64::INFINITY;
    for _ in 0..context.repetitions(TIMING_REPETITIONS) {
        let mut tracker = contender.start(TABLE_I[case].pose)?;
        let start = Instant::now();
        metrics_of(truth, &mut *tracker)?;
        fastest = fastest.min(start.elapsed().as_secs_f64() / truth.outputs.len().max(1) as f64);
    }
    Ok(fastest)
}
