//! Experiment `vehicle-polar`: unscented Kalman filter against linearised zonotopic filter, paper 001, section 5.2.
//!
//! Reading order: [`plant`], [`filters`], [`setting`], [`figures`], [`tables`] and [`report`].

pub mod figures;
pub mod filters;
pub mod plant;
pub mod report;
pub mod setting;
pub mod tables;

use crate::contest::{Cell, Noise, course, study, timings};
use crate::{Context, Experiment, Output, Results, ScenarioError};
use filters::{GUARANTEED, PUBLISHED};
use setting::Setting;

/// Runs of a cell: full size (the paper's), quick.
const RUNS: (usize, usize) = (100, 4);
/// Most runs of other settings.
const VARIANT_RUNS: usize = 20;

/// Table 2 and Figure 2 of paper 001.
#[derive(Clone, Copy, Debug)]
pub struct VehiclePolarExperiment;

impl Experiment for VehiclePolarExperiment {
    fn name(&self) -> &'static str {
        "vehicle-polar"
    }

    fn describe(&self) -> &'static str {
        "paper 001: unscented Kalman filter against zonotopic filter, a vehicle seen by range and bearing (Table 2, Figure 2)"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let few = runs.min(VARIANT_RUNS);
        let setting = Setting::fitted(Noise::Gaussian);
        let fitted = study(context, runs, &setting, Noise::Gaussian.name(), &PUBLISHED)?;
        let bounded = Setting::fitted(Noise::Truncated);
        let truncated = study(context, few, &bounded, Noise::Truncated.name(), &PUBLISHED[..2])?;
        let guaranteed = study(context, few, &bounded, Noise::Truncated.name(), &GUARANTEED)?;
        let mut others = Vec::new();
        for (label, setting) in tables::other_readings() {
            others.extend(study(context, few, &setting, label, &PUBLISHED)?);
        }
        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(tables::table_2(&fitted));
        results.rows.extend(tables::readings(&others));
        results.rows.extend(tables::half_widths(&fitted));
        results.rows.extend(tables::containment(&[&fitted, &truncated, &guaranteed, &others]));
        let timings = timings(context, &setting, "vehicle", &PUBLISHED, 27.2 / 0.226)?;
        let (truth, courses) = course(context, &setting, &PUBLISHED[..2])?;
        let last = |cell: &Cell<4>| cell.runs.iter().map(|run| run.diverged).max().flatten();
        let diverged = [last(&guaranteed[0]), last(&guaranteed[1])];
        let report = report::report([runs, few], &results, &timings, diverged);
        Ok(Output { results, timings, report, figures: vec![figures::figure_2(&truth, &courses)], curves: Vec::new() })
    }
}
