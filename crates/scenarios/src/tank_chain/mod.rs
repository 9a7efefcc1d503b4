//! Experiment `tank-chain`: a long chain of tanks, slow and weakly measured.
//!
//! Reading order: [`plant`], [`contenders`] (the filters), [`ideal`] (the yardstick), [`cases`] (runs), [`scaling`] (longer chains),
//! [`figures`], [`report`].

pub mod cases;
pub mod contenders;
pub mod figures;
pub mod ideal;
pub mod plant;
pub mod report;
pub mod scaling;

use crate::noise::NoiseKind;
use crate::{Context, Experiment, Output, Results, ScenarioError};
use cases::{Case, Outcome};

/// Runs of a case: full size, quick.
const RUNS: (usize, usize) = (6, 2);
/// Most runs of thirty tanks, which take long; their yardstick would take longer still.
const LONG_RUNS: usize = 1;
/// Most runs with a yardstick: that of 200 steps has 1200 generators and 600 constraints.
const IDEALS: usize = 2;
/// Sizes of the longer chains: full size, quick.
const SIZES: (&[usize], &[usize]) = (&[3, 6, 12, 30, 60], &[3, 6, 12]);

/// Chains of 6 and 30 tanks, and how radius and time grow up to 60.
#[derive(Clone, Copy, Debug)]
pub struct TankChainExperiment;

impl Experiment for TankChainExperiment {
    fn name(&self) -> &'static str {
        "tank-chain"
    }

    fn describe(&self) -> &'static str {
        "a long, slow, weakly measured chain of tanks: how the ranged CZ filter remembers, and how it grows to 60 states"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let outcomes = cases(context.quick, runs).into_iter().map(|case| Outcome::new(context, case));
        let outcomes = outcomes.collect::<Result<Vec<_>, _>>()?;
        let points = scaling::points(context, if context.quick { SIZES.1 } else { SIZES.0 })?;
        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(outcomes.iter().flat_map(report::rows));
        results.rows.extend(report::size_rows(&points));
        let timings = report::timings(&points);
        let report = report::report(&outcomes, &results, &timings);
        let figures = vec![figures::radii(&outcomes), figures::sizes(&points)];
        Ok(Output { results, timings, report, figures, curves: Vec::new() })
    }
}

/// Six tanks with three kinds of noise; thirty tanks in the full size.
fn cases(quick: bool, runs: usize) -> Vec<Case> {
    let six = |kind| Case {
        n: 6,
        kind,
        steps: if quick { 50 } else { 200 },
        runs,
        listed: if quick { &[10, 20, 50] } else { &[10, 20, 50, 100, 200] },
        ideals: if kind == NoiseKind::Uniform { IDEALS } else { 0 },
    };
    let mut cases: Vec<Case> = [NoiseKind::Uniform, NoiseKind::Vertices, NoiseKind::ConstantVertex].map(six).into();
    if !quick {
        let (kind, runs) = (NoiseKind::Uniform, runs.min(LONG_RUNS));
        cases.push(Case { n: 30, kind, steps: 50, runs, listed: &[10, 20, 50], ideals: 0 });
    }
    cases
}
