//! Experiment `wifibot`: the filters of paper 000 on real logs of a wheeled robot.
//!
//! Reading order: [`odometry`] (increments and their bounds), [`filters`], [`study`] (runs), [`figures`], [`report`] (rows and text).

pub mod figures;
pub mod filters;
pub mod odometry;
pub mod report;
pub mod study;

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

/// ZSMF and InZSMF on logs 2 and 3: wheel odometry, position fixes once a second, unknown first heading.
#[derive(Clone, Copy, Debug)]
pub struct WifibotExperiment;

impl Experiment for WifibotExperiment {
    fn name(&self) -> &'static str {
        "wifibot"
    }

    fn describe(&self) -> &'static str {
        "ZSMF and InZSMF on real logs of a wheeled robot: odometry, position fixes at 1 Hz, unknown first heading"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let courses = LOGS.map(|number| Course::new(number, &load(context.data, self.name(), number)?));
        let mut results = Results::new(self.name(), context.seed, runs);
        let (mut studies, mut timings) = (Vec::new(), Vec::new());
        for course in courses {
            let course = course?;
            let study = Study::new(context, &course, runs)?;
            results.rows.extend(report::rows(&course, &study));
            timings.extend(time(&course, &study)?);
            studies.push((course, study));
        }
        let figures = studies.iter().map(|(course, study)| figures::figure(course, study)).collect();
        let report = report::report(&studies, &results, &timings);
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
