//! Rows and text of the experiment.

use super::plant::Bearing;
use super::study::{STEPS, Setting};
use crate::contest::{Cell, Noise, Paper};
use crate::{Report, Results, Row, Table};

/// Name of the table of other readings of the settings.
pub const READINGS: &str = "other readings";
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
    cells.iter().flat_map(|cell| cell.error_rows(READINGS, UNITS, false, Some(Paper::Other(TABLE_2)))).collect()
}

/// Puts tables and figures together.
#[must_use]
pub fn report(runs: usize, results: &Results, timings: &[Row]) -> Report {
    let mut report =
        Report::new("vehicle-polar: unscented Kalman filter against zonotopic filter (paper 001, section 5.2)");
    report
        .heading("Table 2")
        .paragraph(format!("{runs} runs of {STEPS} steps of 0.5 s. {}", Table::LEGEND))
        .table(Table::pivot(results.table("Table 2")))
        .heading("Other readings")
        .table(Table::pivot(results.table(READINGS)))
        .heading("Containment")
        .table(Table::pivot(results.table(CONTAINMENT)))
        .heading("Time of a step")
        .table(Table::pivot(timings));
    report
}
