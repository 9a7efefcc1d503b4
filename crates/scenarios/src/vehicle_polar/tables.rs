//! Rows of `results.json` from the cells of the studies.

use super::plant::Bearing;
use super::setting::{MARKS, Setting};
use crate::Row;
use crate::contest::{Cell, Noise, Paper};

/// Name of the table of other readings of the settings.
pub const READINGS: &str = "other readings";
/// Name of the table of half widths.
pub const HALF_WIDTHS: &str = "half widths";
/// Name of the table of containment and divergence.
pub const CONTAINMENT: &str = "containment";

/// Units of the states.
const UNITS: [&str; 4] = ["m", "m", "m/s", "m/s"];
/// The paper's Table 2: one row for both filters.
const TABLE_2: [f64; 4] = [0.87, 0.87, 0.22, 0.22];

/// Settings that the paper's text admits as well.
#[must_use]
pub fn other_readings() -> [(&'static str, Setting); 3] {
    let fitted = Setting::fitted(Noise::Gaussian);
    [
        ("tan as printed", Setting { bearing: Bearing::Tan, ..fitted }),
        ("estimate (3,3,0.5,0.5)", Setting { estimate: [3.0, 3.0, 0.5, 0.5], ..fitted }),
        ("500 s", Setting { steps: 1000, ..fitted }),
    ]
}

/// Table 2 with the settings that fit.
#[must_use]
pub fn table_2(cells: &[Cell<4>]) -> Vec<Row> {
    let rows = |cell: &Cell<4>| {
        let paper = (cell.method != "ekf").then_some(Paper::Same(TABLE_2));
        cell.error_rows("Table 2", UNITS, false, paper)
    };
    cells.iter().flat_map(rows).collect()
}

/// The errors with other settings.
#[must_use]
pub fn readings(cells: &[Cell<4>]) -> Vec<Row> {
    let rows = |cell: &Cell<4>| {
        let mut rows = cell.error_rows(READINGS, UNITS, false, Some(Paper::Other(TABLE_2)));
        rows.push(cell.row(READINGS, "divergences", "runs").value(cell.diverged() as f64));
        rows
    };
    cells.iter().flat_map(rows).collect()
}

/// Half widths of the bounds of `x1` and `x4` at some steps.
#[must_use]
pub fn half_widths(cells: &[Cell<4>]) -> Vec<Row> {
    cells.iter().flat_map(|cell| cell.half_width_rows(HALF_WIDTHS, UNITS, &[0, 3], &MARKS)).collect()
}

/// How often the truth is held, and what goes wrong.
#[must_use]
pub fn containment(studies: &[&[Cell<4>]]) -> Vec<Row> {
    studies.iter().copied().flatten().flat_map(|cell| cell.containment_rows(CONTAINMENT)).collect()
}
