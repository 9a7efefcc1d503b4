//! How long the phases of a step take.

use std::time::{Duration, Instant};

use estimators::Phase;

use super::course::follow;
use super::{Contender, Trajectory};
use crate::{Row, ScenarioError};

/// Repetitions of a timed run, of which the fastest counts.
const REPETITIONS: usize = 5;

/// Seconds a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PhaseTimes {
    /// Prediction.
    pub prediction: f64,
    /// Update.
    pub update: f64,
    /// Consistency, where it is a phase of its own.
    pub consistency: f64,
    /// Reduction, wherever it happens.
    pub reduction: f64,
}

impl PhaseTimes {
    /// All phases together.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.prediction + self.update + self.consistency + self.reduction
    }

    fn of(&mut self, phase: Phase) -> &mut f64 {
        match phase {
            Phase::Update => &mut self.update,
            Phase::Consistency => &mut self.consistency,
            Phase::Reduction => &mut self.reduction,
            _ => &mut self.prediction,
        }
    }
}

/// Times a filter along a trajectory on this thread, as far as it gets.
///
/// # Errors
/// Those of the filter.
pub fn phase_times(trajectory: &Trajectory, contender: &Contender) -> Result<PhaseTimes, ScenarioError> {
    let mut fastest: Option<PhaseTimes> = None;
    for _ in 0..REPETITIONS {
        let (mut filter, mut steps) = (contender.start(())?, 0_usize);
        let (mut times, mut mark) = (PhaseTimes::default(), Instant::now());
        // What lies between the calls of the filter is so little that it need not be told from its first phase.
        let mut trace = |phase: Phase| {
            let now = Instant::now();
            *times.of(phase) += Duration::as_secs_f64(&(now - mark));
            mark = now;
        };
        follow(trajectory, &mut *filter, &mut trace, &mut |k, _| {
            steps = k + 1;
            Ok(())
        })?;
        let steps = steps.max(1) as f64;
        for phase in [&mut times.prediction, &mut times.update, &mut times.consistency, &mut times.reduction] {
            *phase /= steps;
        }
        if fastest.is_none_or(|fastest| times.total() < fastest.total()) {
            fastest = Some(times);
        }
    }
    Ok(fastest.unwrap_or_default())
}

/// Rows of `timings.json`: `ART` in all and by phase, and `ns_per_step`; `paper` has the paper's total and reduction times in seconds.
#[must_use]
pub fn rows(table: &str, row: &str, contender: &Contender, times: &PhaseTimes, paper: Option<[f64; 2]>) -> Vec<Row> {
    let start = |metric: &str, seconds: f64| {
        Row::new(table, row, &*contender.method).mode(contender.mode).metric(metric, "s").value(seconds)
    };
    let beside = |row: Row, which: usize| if let Some(paper) = paper { row.paper_ref(paper[which]) } else { row };
    vec![
        beside(start("ART", times.total()), 0),
        start("ART(prediction)", times.prediction),
        start("ART(update)", times.update),
        start("ART(consistency)", times.consistency),
        beside(start("ART(reduction)", times.reduction), 1),
        start("ns_per_step", 1e9 * times.total()).metric("ns_per_step", "ns"),
    ]
}
