//! Experiment `batch-reactor`: unscented Kalman filter against zonotopic filter, paper 001, section 5.1.
//!
//! Reading order: [`plant`], [`filters`], [`setting`], [`figures`], [`tables`] and [`report`].

pub mod figures;
pub mod filters;
pub mod plant;
pub mod report;
pub mod setting;
pub mod tables;

use crate::contest::{Noise, course, study, timings};
use crate::{Context, Experiment, Figure, Output, Results, ScenarioError};
use filters::{Contender, PUBLISHED, VARIANTS};
use plant::Rates;
use setting::{STEPS_PER_SECOND, Setting};

/// Runs of a cell: full size (the paper's), quick.
const RUNS: (usize, usize) = (100, 10);
/// Most runs of the variants.
const VARIANT_RUNS: usize = 20;

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
        let few = runs.min(VARIANT_RUNS);
        let cells = |noise: Noise, runs: usize, contenders: &[Contender]| {
            study(context, runs, &Setting::of_the_paper(noise), noise.name(), contenders)
        };
        let gaussian = cells(Noise::Gaussian, runs, &PUBLISHED)?;
        let truncated = cells(Noise::Truncated, runs, &PUBLISHED)?;
        let variants = cells(Noise::Gaussian, few, &VARIANTS)?;
        let per_second = Setting { rates: Rates::PerSecond, noise: Noise::Gaussian, steps: STEPS_PER_SECOND };
        let per_second = study(context, few, &per_second, "rates per second", &PUBLISHED)?;

        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(tables::table_1(&gaussian));
        results.rows.extend(tables::readings(&gaussian, &per_second));
        results.rows.extend(tables::half_widths(&gaussian));
        results.rows.extend(tables::half_widths(&truncated));
        results.rows.extend(tables::containment(&[&gaussian, &truncated, &variants]));
        let bounded = Setting::of_the_paper(Noise::Truncated);
        let timings = timings(context, &bounded, "reactor", &PUBLISHED, 40.0 / 1.5)?;
        let figures = figures(context)?;
        let report = report::report([runs, few], &results, &timings);
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// Figure 1 with the paper's filters, and with bounded noise and tightened strips.
fn figures(context: &Context<'_>) -> Result<Vec<Figure>, ScenarioError> {
    let figure = |name: &str, title: &str, noise: Noise, zonotopic: Contender| {
        let (truth, courses) = course(context, &Setting::of_the_paper(noise), &[PUBLISHED[0], zonotopic])?;
        Ok::<_, ScenarioError>(figures::figure_1(name, title, &truth, &courses))
    };
    Ok(vec![
        figure("figure-1", "One run, Gaussian noise (paper: Figure 1)", Noise::Gaussian, PUBLISHED[1])?,
        figure("figure-1-tightened", "One run, noise truncated at 3 sigma", Noise::Truncated, PUBLISHED[3])?,
    ])
}
