//! What the experiments of paper 001 share: statistical and set-valued filters on the same noises, and what is counted.

use std::time::Instant;

use estimators::kalman::{Flat, Forecast, Kalman, Motion, Observe, Sensor};
use estimators::{Estimator, EstimatorError, SetFilter, ZfMethod};
use scalars::Interval;
use setrep::Membership;

use crate::{Mode, Row, ScenarioError};

/// Standard deviations of the confidence intervals that are shown and counted.
pub const SIGMAS: f64 = 3.0;
/// Repetitions of a timed run.
const TIMING_REPETITIONS: usize = 5;

/// How noises are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Noise {
    /// As in the paper: without bounds.
    Gaussian,
    /// Drawn again while beyond three standard deviations.
    Truncated,
}

impl Noise {
    /// The name used in rows and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gaussian => "gaussian",
            Self::Truncated => "truncated at 3 sigma",
        }
    }
}

/// A filter of either kind, of `N` states.
pub trait Contestant<const N: usize> {
    /// A prediction, then an update by `y`.
    ///
    /// # Errors
    /// What the filter says.
    fn advance(&mut self, y: &[f64]) -> Result<(), EstimatorError>;

    /// Mean or center.
    fn center(&self) -> [f64; N];

    /// Half widths of the interval of each state: three standard deviations, or of the set's hull.
    fn half_widths(&self) -> [f64; N];

    /// Whether the state lies in the region that the filter states: all confidence intervals, or the set.
    ///
    /// # Errors
    /// What the set says.
    fn holds(&self, state: &[f64; N]) -> Result<bool, ScenarioError>;
}

impl<Mo, Rule, const N: usize, const M: usize, const W: usize, const V: usize> Contestant<N>
    for Kalman<Mo, Rule, Flat, N, M, W, V>
where
    Mo: Motion<Flat, N, W, Input = [f64]> + Sensor<Flat, N, M, V>,
    Rule: Forecast<Mo, Flat, N, W> + Observe<Mo, Flat, N, M, V>,
{
    fn advance(&mut self, y: &[f64]) -> Result<(), EstimatorError> {
        self.predict(&[])?;
        self.update(y)
    }

    fn center(&self) -> [f64; N] {
        (*self.belief().mean()).into()
    }

    fn half_widths(&self) -> [f64; N] {
        (self.belief().standard_deviations() * SIGMAS).into()
    }

    fn holds(&self, state: &[f64; N]) -> Result<bool, ScenarioError> {
        Ok(in_box(self.center(), self.half_widths(), state))
    }
}

/// A zonotopic filter of `N` states.
#[derive(Debug, Clone)]
pub struct Zonotopic<const LINEARIZED: bool>(pub SetFilter<ZfMethod<LINEARIZED>>);

/// Sets of more generators than this are looked at through their hull alone: exact membership would take all their facets.
const MEMBERSHIP_GENERATORS: usize = 60;

impl<const LINEARIZED: bool, const N: usize> Contestant<N> for Zonotopic<LINEARIZED> {
    fn advance(&mut self, y: &[f64]) -> Result<(), EstimatorError> {
        self.0.predict(&[])?;
        self.0.update(y)
    }

    fn center(&self) -> [f64; N] {
        std::array::from_fn(|i| self.0.enclosure().center()[i])
    }

    fn half_widths(&self) -> [f64; N] {
        std::array::from_fn(|i| self.0.hull()[i].rad())
    }

    fn holds(&self, state: &[f64; N]) -> Result<bool, ScenarioError> {
        let set = self.0.enclosure();
        if set.num_generators() > MEMBERSHIP_GENERATORS {
            return Ok(in_box(self.center(), self.half_widths(), state));
        }
        let point: Vec<Interval> = state.iter().map(|&x| Interval::point(x)).collect();
        Ok(set.membership(&point)? != Membership::ProvenOutside)
    }
}

/// Whether a state lies between the bounds of all intervals.
#[must_use]
pub fn in_box<const N: usize>(center: [f64; N], half_widths: [f64; N], state: &[f64; N]) -> bool {
    (0..N).all(|i| (state[i] - center[i]).abs() <= half_widths[i])
}

/// What is looked at.
#[derive(Debug, Clone, Copy)]
pub struct Watch<'a> {
    /// Steps up to this one do not count for [`Record::late_rmse`].
    pub late: usize,
    /// Steps at which half widths are kept.
    pub marks: &'a [usize],
    /// A half width beyond this is a divergence.
    pub limit: f64,
    /// Containment is looked at every so many steps.
    pub stride: usize,
}

/// What became of a filter in one run of steps `1..=len`.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<const N: usize> {
    /// Root mean square errors over all steps (47); NaN after a divergence.
    pub rmse: [f64; N],
    /// The same over the late steps.
    pub late_rmse: [f64; N],
    /// Half widths at the marks; NaN beyond a divergence.
    pub marks: Vec<[f64; N]>,
    /// Steps at which containment was looked at, and of these: with the state in the region, and in all intervals.
    pub watched: usize,
    /// Steps with the state in the region.
    pub held: usize,
    /// Steps with the state in all intervals.
    pub boxed: usize,
    /// Updates that were proven to contradict the prediction; the filter went on without them.
    pub refuted: usize,
    /// Step at which the filter failed or outgrew the limit.
    pub diverged: Option<usize>,
}

/// Center and half widths of one step.
pub type Course<const N: usize> = Vec<([f64; N], [f64; N])>;

/// Follows `states` (`x_1..`) by their `outputs` (`y_1..`); `keep` is called after every step.
///
/// # Errors
/// Those of looking at a set; a filter that fails has diverged.
pub fn follow<const N: usize, const M: usize>(
    filter: &mut dyn Contestant<N>,
    states: &[[f64; N]],
    outputs: &[[f64; M]],
    watch: &Watch<'_>,
    mut keep: impl FnMut([f64; N], [f64; N]),
) -> Result<Record<N>, ScenarioError> {
    let (mut all, mut late) = ([0.0; N], [0.0; N]);
    let mut record = Record {
        rmse: [f64::NAN; N],
        late_rmse: [f64::NAN; N],
        marks: vec![[f64::NAN; N]; watch.marks.len()],
        watched: 0,
        held: 0,
        boxed: 0,
        refuted: 0,
        diverged: None,
    };
    for (k, (x, y)) in (1..).zip(states.iter().zip(outputs)) {
        match filter.advance(y) {
            Ok(()) => {}
            Err(EstimatorError::Inconsistent(_)) => record.refuted += 1,
            Err(_) => record.diverged = Some(k),
        }
        let (center, half_widths) = (filter.center(), filter.half_widths());
        // NaN is beyond the limit, too.
        if !half_widths.iter().chain(&center).all(|x| x.abs() <= watch.limit) {
            record.diverged = record.diverged.or(Some(k));
        }
        if record.diverged.is_some() {
            return Ok(record);
        }
        keep(center, half_widths);
        for i in 0..N {
            let squared = (x[i] - center[i]) * (x[i] - center[i]);
            all[i] += squared;
            late[i] += if k > watch.late { squared } else { 0.0 };
        }
        if let Some(mark) = watch.marks.iter().position(|&mark| mark == k) {
            record.marks[mark] = half_widths;
        }
        if k % watch.stride == 0 {
            record.watched += 1;
            record.held += usize::from(filter.holds(x)?);
            record.boxed += usize::from(in_box(center, half_widths, x));
        }
    }
    record.rmse = all.map(|sum| (sum / states.len() as f64).sqrt());
    record.late_rmse = late.map(|sum| (sum / states.len().saturating_sub(watch.late) as f64).sqrt());
    Ok(record)
}

/// Mean time of a step in nanoseconds, nothing else counted: the fastest of a few repetitions of one run.
pub fn step_time_ns<const N: usize, const M: usize>(
    start: impl Fn() -> Result<Box<dyn Contestant<N>>, ScenarioError>,
    outputs: &[[f64; M]],
) -> Result<f64, ScenarioError> {
    let mut fastest = f64::INFINITY;
    for _ in 0..TIMING_REPETITIONS {
        let mut filter = start()?;
        let start = Instant::now();
        for y in outputs {
            filter.advance(y)?;
        }
        fastest = fastest.min(start.elapsed().as_nanos() as f64 / outputs.len().max(1) as f64);
    }
    Ok(fastest)
}

/// All runs of one filter in one setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell<const N: usize> {
    /// What varies, in ASCII.
    pub label: String,
    /// Name in the rows.
    pub method: String,
    /// What is rigorous, for sets.
    pub mode: Option<Mode>,
    /// Run by run.
    pub runs: Vec<Record<N>>,
}

impl<const N: usize> Cell<N> {
    /// A row of a table about this cell, without a number yet.
    #[must_use]
    pub fn row(&self, table: &str, metric: impl Into<String>, unit: &str) -> Row {
        let row = Row::new(table, &*self.label, &*self.method).metric(metric, unit);
        if let Some(mode) = self.mode { row.mode(mode) } else { row }
    }

    /// A number of every run.
    pub fn samples(&self, of: impl Fn(&Record<N>) -> f64) -> Vec<f64> {
        self.runs.iter().map(of).collect()
    }

    /// Number of runs that diverged.
    #[must_use]
    pub fn diverged(&self) -> usize {
        self.runs.iter().filter(|run| run.diverged.is_some()).count()
    }

    /// Errors of all states, over all steps or over the late ones; `paper` has the paper's.
    pub fn error_rows(&self, table: &str, units: [&str; N], late: bool, paper: Option<Paper<N>>) -> Vec<Row> {
        let row = |i: usize| {
            let row = self.row(table, format!("RMSE(x{})", i + 1), units[i]);
            let row = match paper {
                Some(Paper::Same(numbers)) => row.paper(numbers[i]),
                Some(Paper::Other(numbers)) => row.paper_ref(numbers[i]),
                None => row,
            };
            row.mean_of(&self.samples(|run| if late { run.late_rmse[i] } else { run.rmse[i] }))
        };
        (0..N).map(row).collect()
    }

    /// How often the truth was held, and what went wrong.
    #[must_use]
    pub fn containment_rows(&self, table: &str) -> Vec<Row> {
        let share = |count: fn(&Record<N>) -> usize| {
            self.samples(|run| if run.watched == 0 { f64::NAN } else { count(run) as f64 / run.watched as f64 })
        };
        let throughout = self.runs.iter().filter(|run| run.held == run.watched && run.diverged.is_none()).count();
        let refuted: usize = self.runs.iter().map(|run| run.refuted).sum();
        vec![
            self.row(table, "containment", "").mean_of(&share(|run| run.held)),
            self.row(table, "containment(hull)", "").mean_of(&share(|run| run.boxed)),
            self.row(table, "runs_contained", "runs").value(throughout as f64),
            self.row(table, "empty_intersections", "steps").value(refuted as f64),
            self.row(table, "divergences", "runs").value(self.diverged() as f64),
        ]
    }
}

/// The paper's numbers beside ours: of the same settings, or for reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Paper<const N: usize> {
    /// Same settings.
    Same([f64; N]),
    /// Other settings.
    Other([f64; N]),
}
