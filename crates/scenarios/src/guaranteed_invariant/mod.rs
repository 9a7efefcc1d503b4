//! Experiment `guaranteed-invariant`: the filter of strips, which never loses the state, beside the filters of paper 000 that do.
//!
//! Reading order: [`noise`] and [`follow`] (paper 000's vehicle), [`planar`] and [`broken`] (studies on it), [`lever`] and [`settings`]
//! (Problem 3 of paper 002), [`lever_run`] and [`lever_study`], [`robot`], [`robot_spans`] and [`robot_study`] (real logs), [`courses`] and [`figures`],
//! [`tables`], [`robot_tables`], [`findings`] and [`report`].

pub mod broken;
pub mod courses;
pub mod figures;
pub mod findings;
pub mod follow;
pub mod lever;
pub mod lever_run;
pub mod lever_study;
pub mod noise;
pub mod planar;
pub mod report;
pub mod robot;
pub mod robot_spans;
pub mod robot_study;
pub mod robot_tables;
pub mod settings;
pub mod tables;

use std::time::Instant;

use crate::{Context, Experiment, Output, Results, Row, ScenarioError};
use findings::Evidence;
use follow::{Start, StripRun};
use noise::{Drive, truth_of};
use planar::{STRIPS, Scale};

/// Steps of a timed run.
const TIMED_STEPS: usize = 500;

/// Guaranteed sets on planar groups from an unknown heading; with unknown scale and lever arm; on real logs.
#[derive(Clone, Copy, Debug)]
pub struct GuaranteedInvariantExperiment;

impl Experiment for GuaranteedInvariantExperiment {
    fn name(&self) -> &'static str {
        "guaranteed-invariant"
    }

    fn describe(&self) -> &'static str {
        "guaranteed sets on planar groups: paper 000's vehicle, Problem 3 of paper 002, robot logs"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let scale = Scale::of(context);
        let cells = planar::strips(context, &scale)?;
        let first_order = planar::first_order(context, &scale)?;
        let losses = planar::losses(context, &scale)?;
        let broken = broken::study(context, scale.runs)?;
        let levers = lever_study::study(context, context.runs_or(20, 1))?;
        let logs = match robot_study::study(context, self.name(), context.runs_or(5, 1)) {
            Err(ScenarioError::DataMissing { .. }) => Vec::new(),
            logs => logs?,
        };
        let uniform = courses::record(context, Drive::Uniform)?;
        let constant = courses::record(context, Drive::ConstantVertex)?;
        let timings = timings(context)?;

        let mut results = Results::new(self.name(), context.seed, scale.runs);
        results.rows.extend(tables::sizes(&cells));
        results.rows.extend(tables::sizes(&first_order));
        results.rows.extend(tables::containment(&cells, &losses));
        results.rows.extend(tables::broken(&broken));
        results.rows.extend(tables::lever(&levers));
        results.rows.extend(robot_tables::rows(&logs));
        let evidence = Evidence {
            strips: &cells,
            first_order: &first_order,
            losses: &losses,
            broken: &broken,
            levers: &levers,
            logs: &logs,
        };
        let report = report::report(&scale, &evidence, &results, &timings);
        let mut figures = vec![figures::main(&uniform, &constant), figures::lever(&levers)];
        if !logs.is_empty() {
            figures.push(figures::robot(&logs));
        }
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// Time of a step from an unknown heading, truth comparison included.
fn timings(context: &Context<'_>) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    for drive in [Drive::Uniform, Drive::ConstantVertex] {
        let truth = truth_of(context, drive, 1.0, TIMED_STEPS, 0)?;
        let start = Instant::now();
        StripRun::new(&truth, Start::UnknownHeading, |_, _| Ok(()))?;
        let ns = start.elapsed().as_nanos() as f64 / TIMED_STEPS as f64;
        rows.push(Row::new("timing", drive.name(), STRIPS).metric("ns_per_step", "ns").value(ns));
    }
    Ok(rows)
}
