//! Experiment `wheel-lever`: three Kalman filters of a robot with unknown wheel radius and antenna, paper 002, section VI-B.
//!
//! Reading order: [`filters`], [`setting`] (plant and noises), [`study`] (runs), [`autonomy`] (Propositions 1 to 4), [`tables`], [`figures`] and
//! [`report`].

pub mod autonomy;
pub mod figures;
pub mod filters;
pub mod report;
pub mod setting;
pub mod study;
pub mod tables;

use std::time::Instant;

use crate::{Context, Experiment, Output, Results, Row, ScenarioError, monte_carlo};
use filters::Method;
use setting::{ALT, BEST, Setting, VARIANTS};
use study::{Cell, cell};

/// Runs of a cell: full size, quick.
const RUNS: (usize, usize) = (500, 60);
/// Most runs of the variants.
const VARIANT_RUNS: usize = 100;
/// Standard deviations of the first heading, degrees: of Figure 2 (top), and of Table I.
pub const HEADINGS_DEG: [f64; 2] = [100.0, 200.0];

/// Table I, Figure 2 and Propositions 1 to 4 of paper 002.
#[derive(Clone, Copy, Debug)]
pub struct WheelLeverExperiment;

impl Experiment for WheelLeverExperiment {
    fn name(&self) -> &'static str {
        "wheel-lever"
    }

    fn describe(&self) -> &'static str {
        "paper 002: EKF, imperfect IEKF and TFG-IEKF with unknown wheel radius and antenna (Table I, Figure 2, Propositions 1 to 4)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let cells = |settings: &[Setting], headings: &[f64], runs: usize| {
            let cases = settings.iter().flat_map(|setting| headings.iter().map(move |degrees| (setting, *degrees)));
            cases.map(|(setting, degrees)| cell(context, setting, degrees, runs)).collect::<Result<Vec<Cell>, _>>()
        };
        let main = cells(&[BEST, ALT], &HEADINGS_DEG, runs)?;
        let variants = cells(&VARIANTS, &HEADINGS_DEG[1..], runs.min(VARIANT_RUNS))?;
        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(tables::table_1(&main));
        results.rows.extend(tables::errors(&main));
        results.rows.extend(tables::variants(&variants));
        results.rows.extend(autonomy::rows()?);
        let timings = time(context)?;
        let figures = vec![figures::figure_2(&main)];
        let report = report::report(&main, &variants, &results, &timings);
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// Time of a second of a run (ten predictions and an update), on one thread.
fn time(context: &Context<'_>) -> Result<Vec<Row>, ScenarioError> {
    let drive = BEST.drive(HEADINGS_DEG[1], &mut monte_carlo::stream(context.seed, "wheel-lever/timing", 0));
    let mut rows = Vec::new();
    for method in Method::ALL {
        let mut filter = BEST.start(method, &drive)?;
        let start = Instant::now();
        for second in &drive.seconds {
            for step in &second.steps {
                filter.predict(step)?;
            }
            filter.update(second.fix)?;
        }
        let ns = start.elapsed().as_nanos() as f64 / drive.seconds.len() as f64;
        rows.push(Row::new("timing", "ten predictions, one update", method.name()).metric("ns", "ns").value(ns));
    }
    Ok(rows)
}
