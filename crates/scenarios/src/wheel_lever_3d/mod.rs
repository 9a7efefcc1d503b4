//! Experiment `wheel-lever-3d`: unknown wheel scale and antenna in space, where rotations do not commute.
//!
//! In the plane a lever arm that does not move in the body makes the motion group-affine, because rotations of the plane commute. In
//! space it does not: the error `E^X` after a turn `Omega` depends on the estimated lever arm by `Xhat x (Omega' - I) w`. What that costs is
//! measured here. Reading order: [`model`], [`study`], [`report`].

pub mod model;
pub mod report;
pub mod study;

use crate::{Context, Experiment, Output, Results, ScenarioError};
use study::{LEVERS_M, cell};

/// Runs of a cell: full size, quick.
const RUNS: (usize, usize) = (100, 10);

/// The filters of paper 002 in space.
#[derive(Clone, Copy, Debug)]
pub struct WheelLever3dExperiment;

impl Experiment for WheelLever3dExperiment {
    fn name(&self) -> &'static str {
        "wheel-lever-3d"
    }

    fn describe(&self) -> &'static str {
        "unknown wheel scale and antenna in space: how far the two-frame error is from moving by itself, and what that costs"
    }

    fn run(&self, context: &Context<'_>) -> Result<Output, ScenarioError> {
        let runs = context.runs_or(RUNS.0, RUNS.1);
        let cells = LEVERS_M.iter().map(|lever| cell(context, *lever, runs)).collect::<Result<Vec<_>, _>>()?;
        let mut results = Results::new(self.name(), context.seed, runs);
        results.rows.extend(report::residuals()?);
        results.rows.extend(cells.iter().flat_map(report::rows));
        let report = report::report(&results);
        Ok(Output { results, timings: Vec::new(), report, figures: Vec::new(), curves: Vec::new() })
    }
}
