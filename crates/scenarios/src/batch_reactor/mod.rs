//! Experiment `batch-reactor`: unscented Kalman filter against zonotopic filter, paper 001, section 5.1.
//!
//! Reading order: [`plant`], [`filters`], [`study`], [`report`].

pub mod filters;
pub mod plant;
pub mod report;
pub mod study;

use crate::contest::{Noise, step_time_ns};
use crate::{Context, Experiment, Output, Results, Row, ScenarioError};
use filters::PUBLISHED;
use plant::Rates;
use study::{STEPS_PER_SECOND, Setting, study};

/// Runs of a cell: full size (the paper's), quick.
const RUNS: (usize, usize) = (100, 10);

/// Table 1 and Figure 1 of paper 001.
#[derive(Clone, Copy, Debug)]
pub struct BatchReactorExperiment;

impl Experiment for BatchReactorExperiment {
    fn name(&self) -> &'static str {
        "batch-reactor"
    }

    fn describe(&self) -> &'static str {
        "paper 001: unscented Kalman filter against zonotopic filter on a batch reactor (Table 1, Figure 1)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let gaussian = study(context, runs, Setting::of_the_paper(Noise::Gaussian), "gaussian", &PUBLISHED)?;
        let per_second = Setting { rates: Rates::PerSecond, noise: Noise::Gaussian, steps: STEPS_PER_SECOND };
        let per_second = study(context, runs, per_second, "rates per second", &PUBLISHED)?;

        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(report::table_1(&gaussian));
        results.rows.extend(report::readings(&gaussian, &per_second));
        results.rows.extend(gaussian.iter().flat_map(|cell| cell.containment_rows(report::CONTAINMENT)));
        let timings = timings(context)?;
        let report = report::report(runs, &results, &timings);
        Ok(Output { results, timings, report, figures: Vec::new(), curves: Vec::new() })
    }
}

/// Times of a step, one after the other on one thread.
fn timings(context: &Context<'_>) -> Result<Vec<Row>, ScenarioError> {
    let truth = Setting::of_the_paper(Noise::Gaussian).truth(context, 0)?;
    let time = |contender: &filters::Contender| {
        let ns = step_time_ns(|| contender.start(Rates::PerMinute), &truth.outputs)?;
        Ok(Row::new("timing", "reactor", contender.method).metric("ns_per_step", "ns").value(ns))
    };
    PUBLISHED.iter().map(time).collect()
}
