//! Experiment `vehicle-polar`: unscented Kalman filter against linearised zonotopic filter, paper 001, section 5.2.
//!
//! Reading order: [`plant`], [`filters`], [`study`], [`report`].

pub mod filters;
pub mod plant;
pub mod report;
pub mod study;

use crate::contest::{Noise, step_time_ns};
use crate::{Context, Experiment, Output, Results, Row, ScenarioError};
use filters::{Contender, PUBLISHED};
use plant::Bearing;
use study::{Setting, study};

/// Runs of a cell: full size (the paper's), quick.
const RUNS: (usize, usize) = (100, 4);

/// Table 2 and Figure 2 of paper 001.
#[derive(Clone, Copy, Debug)]
pub struct VehiclePolarExperiment;

impl Experiment for VehiclePolarExperiment {
    fn name(&self) -> &'static str {
        "vehicle-polar"
    }

    fn describe(&self) -> &'static str {
        "paper 001: unscented Kalman filter against zonotopic filter on a vehicle seen by range and bearing (Table 2, Figure 2)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let fitted = study(context, runs, Setting::fitted(Noise::Gaussian), "gaussian", &PUBLISHED)?;
        let mut others = Vec::new();
        for (label, setting) in report::other_readings() {
            others.extend(study(context, runs, setting, label, &PUBLISHED)?);
        }
        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(report::table_2(&fitted));
        results.rows.extend(report::readings(&others));
        results.rows.extend(fitted.iter().chain(&others).flat_map(|cell| cell.containment_rows(report::CONTAINMENT)));
        let timings = timings(context)?;
        let report = report::report(runs, &results, &timings);
        Ok(Output { results, timings, report, figures: Vec::new(), curves: Vec::new() })
    }
}

/// Times of a step, one after the other on one thread.
fn timings(context: &Context<'_>) -> Result<Vec<Row>, ScenarioError> {
    let setting = Setting::fitted(Noise::Gaussian);
    let truth = setting.truth(context, 0);
    let time = |contender: &Contender| {
        let ns = step_time_ns(|| contender.start(Bearing::Atan, setting.estimate), &truth.outputs)?;
        Ok(Row::new("timing", "vehicle", contender.method).metric("ns_per_step", "ns").value(ns))
    };
    PUBLISHED.iter().map(time).collect()
}
