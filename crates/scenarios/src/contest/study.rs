//! [`study`](self::study()): all runs of all filters of an experiment on the same noises, and their times.

use std::time::Instant;

use rand_chacha::ChaCha8Rng;

use super::{Cell, Contestant, Named, Truth, Watch, follow};
use crate::{Context, Mode, Row, ScenarioError, monte_carlo};

/// Repetitions of a timed run.
const TIMING_REPETITIONS: usize = 5;

/// A setting of plant and filters, of `N` states and `M` outputs.
pub trait Arena<const N: usize, const M: usize>: Sync {
    /// Name of the experiment.
    const NAME: &'static str;
    /// What distinguishes the filters.
    type Kind: Copy + Sync;

    /// One run of the plant.
    ///
    /// # Errors
    /// [`ScenarioError::Truth`] if it cannot be proven.
    fn simulate(&self, rng: &mut ChaCha8Rng) -> Result<Truth<N, M>, ScenarioError>;

    /// A filter at its start.
    ///
    /// # Errors
    /// Those of the constructors.
    fn start(&self, kind: Self::Kind) -> Result<Box<dyn Contestant<N>>, ScenarioError>;

    /// What is looked at.
    fn watch(&self) -> Watch<'static>;

    /// The truth of run `run`: the same for all filters.
    ///
    /// # Errors
    /// As [`simulate`](Self::simulate).
    fn truth(&self, context: &Context<'_>, run: usize) -> Result<Truth<N, M>, ScenarioError> {
        self.simulate(&mut monte_carlo::stream(context.seed, Self::NAME, run))
    }
}

/// A filter under a name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contender<K> {
    /// Name in the rows.
    pub method: &'static str,
    /// What is rigorous, for sets.
    pub mode: Option<Mode>,
    /// Which filter.
    pub kind: K,
}

/// Runs all filters; one cell each.
///
/// # Errors
/// Truths that cannot be proven, filters that cannot be started, and those of [`follow`](super::follow()).
pub fn study<A: Arena<N, M>, const N: usize, const M: usize>(
    context: &Context<'_>,
    runs: usize,
    arena: &A,
    label: &str,
    contenders: &[Contender<A::Kind>],
) -> Result<Vec<Cell<N>>, ScenarioError> {
    let by_run = monte_carlo::run(context, &format!("{} {label}", A::NAME), runs, |run, _| {
        let truth = arena.truth(context, run)?;
        let record = |contender: &Contender<A::Kind>| {
            follow(&mut *arena.start(contender.kind)?, &truth, &arena.watch(), |_, _| {})
        };
        contenders.iter().map(record).collect::<Result<Vec<_>, ScenarioError>>()
    })?;
    let cell = |(index, contender): (usize, &Contender<A::Kind>)| Cell {
        label: label.to_owned(),
        method: contender.method.to_owned(),
        mode: contender.mode,
        runs: by_run.iter().map(|records| records[index].clone()).collect(),
    };
    Ok(contenders.iter().enumerate().map(cell).collect())
}

/// The first run of each filter, step by step.
///
/// # Errors
/// As [`study`](self::study()).
pub fn course<A: Arena<N, M>, const N: usize, const M: usize>(
    context: &Context<'_>,
    arena: &A,
    contenders: &[Contender<A::Kind>],
) -> Result<(Truth<N, M>, Vec<Named<N>>), ScenarioError> {
    let truth = arena.truth(context, 0)?;
    let course = |contender: &Contender<A::Kind>| {
        let mut course = Vec::with_capacity(truth.states.len());
        follow(&mut *arena.start(contender.kind)?, &truth, &arena.watch(), |center, half_widths| {
            course.push((center, half_widths));
        })?;
        Ok::<_, ScenarioError>((contender.method, course))
    };
    let courses = contenders.iter().map(course).collect::<Result<_, _>>()?;
    Ok((truth, courses))
}

/// Times of a step, one after the other on one thread: the fastest of a few repetitions of the first run, and the ratio to the first
/// contender, for `zf` beside the paper's.
///
/// # Errors
/// As [`study`](self::study()), and those of the filters.
pub fn timings<A: Arena<N, M>, const N: usize, const M: usize>(
    context: &Context<'_>,
    arena: &A,
    label: &str,
    contenders: &[Contender<A::Kind>],
    paper_ratio: f64,
) -> Result<Vec<Row>, ScenarioError> {
    let truth = arena.truth(context, 0)?;
    let mut rows = Vec::new();
    let mut first = f64::NAN;
    for contender in contenders {
        let mut ns = f64::INFINITY;
        for _ in 0..context.repetitions(TIMING_REPETITIONS) {
            let mut filter = arena.start(contender.kind)?;
            let start = Instant::now();
            for y in &truth.outputs {
                filter.advance(y)?;
            }
            ns = ns.min(start.elapsed().as_nanos() as f64 / truth.outputs.len().max(1) as f64);
        }
        if first.is_nan() {
            first = ns;
        }
        let row = |metric, unit| Row::new("timing", label, contender.method).metric(metric, unit);
        rows.push(row("ns_per_step", "ns").value(ns));
        let ratio = row("time/ukf", "").value(ns / first);
        rows.push(if contender.method == "zf" { ratio.paper_ref(paper_ratio) } else { ratio });
    }
    Ok(rows)
}
