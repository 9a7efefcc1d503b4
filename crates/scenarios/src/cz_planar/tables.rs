//! The rows of the experiment.

use super::Study;
use super::plant::START_RADIUS;
use crate::Row;
use crate::noise::NoiseKind;
use crate::set_study::{Cell, RADIUS, ratios, rows};

/// Table of the radii.
pub const RADII: &str = "Figure 3";
/// Table of the average radius ratios.
pub const RATIOS: &str = "ARR";
/// Steps at which radii are listed.
pub const STEPS: [usize; 10] = [0, 1, 2, 3, 4, 5, 6, 8, 10, 20];
/// Averages are taken up to this step.
pub const AVERAGED: usize = 10;
/// A run has converged if the radius at step [`AVERAGED`] is at most this share of that of `X_0`.
pub const CONVERGED: f64 = 1.0 / 3.0;

/// Table 2 of the paper: seconds a step, in all and for reductions.
pub const TABLE_2: [(&str, [f64; 2]); 4] =
    [("zmv", [30.5e-3, 4.4e-3]), ("czmv", [65.3e-3, 4.8e-3]), ("zfo", [47.4e-3, 6.6e-3]), ("czfo", [72.2e-3, 14.2e-3])];

/// All rows.
#[must_use]
pub fn rows(studies: &[Study]) -> Vec<Row> {
    let mut all = Vec::new();
    for Study { kind, cells } in studies {
        all.extend(cells.iter().flat_map(|cell| radii(kind.name(), cell)));
    }
    for Study { cells, .. } in studies.iter().filter(|study| study.kind == NoiseKind::Uniform) {
        let finite: Vec<&Cell> = cells.iter().filter(|cell| cell.diverged() == 0).collect();
        for over in &finite {
            all.extend(finite.iter().map(|of| ratios::row(RATIOS, of, over)));
        }
    }
    for Study { kind, cells } in studies {
        all.extend(cells.iter().flat_map(|cell| rows::containment(kind.name(), cell)));
    }
    all
}

fn radii(row: &str, cell: &Cell) -> Vec<Row> {
    let radius = (0, RADIUS);
    let mut all = rows::at_steps(RADII, row, cell, radius, &STEPS);
    all.push(rows::mean_to(RADII, row, cell, radius, AVERAGED));
    all.push(rows::mean(RADII, row, cell, radius));
    all.push(rows::convergence(RADII, row, cell, 0, AVERAGED, CONVERGED * START_RADIUS));
    all
}
