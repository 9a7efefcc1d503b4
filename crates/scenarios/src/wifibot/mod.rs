//! Experiment `wifibot`: the filters of papers 000 and 002 on real logs of a wheeled robot.
//!
//! Reading order: [`odometry`] (increments and their bounds), [`filters`], [`study`] (runs), [`figures`], [`report`] (rows and text);
//! [`wheels`] (paper 002: unknown wheel scale and lever arm).

pub mod figures;
pub mod filters;
pub mod odometry;
pub mod report;
pub mod study;
pub mod wheels;

use std::time::Instant;

use crate::data::wifibot::load;
use crate::{Context, Experiment, Output, Results, Row, ScenarioError};
use filters::Method;
use odometry::Course;
use study::Study;

/// The logs with a consistent reference and a long course.
pub const LOGS: [u32; 2] = [2, 3];
/// Draws of noise: full size, quick.
const RUNS: (usize, usize) = (100, 10);
/// The same for the filters with unknown wheels.
const WHEEL_RUNS: (usize, usize) = (50, 10);

/// ZSMF, InZSMF and the Kalman filters of paper 002 on logs 2 and 3: wheel odometry, position fixes once a second, unknown first heading.
#[derive(Clone, Copy, Debug)]
pub struct WifibotExperiment;

impl Experiment for WifibotExperiment {
    fn name(&self) -> &'static str {
        "wifibot"
    }

    fn describe(&self) -> &'static str {
        "real logs of a wheeled robot, unknown first heading: ZSMF and InZSMF; EKF and invariant filters with unknown wheels and antenna"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let wheel_runs = context.runs_or(WHEEL_RUNS.0, WHEEL_RUNS.1);
        let mut results = Results::new(self.name(), context.seed, runs);
        let (mut studies, mut wheels, mut timings) = (Vec::new(), Vec::new(), Vec::new());
        for number in LOGS {
            let lines = load(context.data, self.name(), number)?;
            let course = Course::new(number, &lines)?;
            wheels.push(wheels::Study::new(context, number, &lines, wheel_runs)?);
            let study = Study::new(context, &course, runs)?;
            results.rows.extend(report::rows(&course, &study));
            timings.extend(time(&course, &study)?);
            studies.push((course, study));
        }
        results.rows.extend(wheels.iter().flat_map(wheels::report::rows));
        let figures = studies.iter().map(|(course, study)| figures::figure(course, study));
        let figures = figures.chain(wheels.iter().map(wheels::report::figure)).collect();
        let report = report::report(&studies, &wheels, &results, &timings);
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// Time of a prediction and a correction, without metrics, on one thread.
fn time(course: &Course, study: &Study) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    for method in Method::ALL {
        let mut filter = method.start(&study::guess(course, study.first_fixes[0], 0.0), course.bounds())?;
        let start = Instant::now();
        for (window, fix) in course.windows.iter().zip(&study.first_fixes[1..]) {
            filter.predict(window)?;
            filter.correct(*fix)?;
        }
        let ns = start.elapsed().as_nanos() as f64 / course.windows.len() as f64;
        rows.push(Row::new("timing", report::log_name(course), method.name()).metric("ns_per_step", "ns").value(ns));
    }
    Ok(rows)
}
