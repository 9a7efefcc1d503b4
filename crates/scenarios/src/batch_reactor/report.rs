//! Rows and text of the experiment.

use super::study::DROPPED;
use crate::contest::{Cell, Paper};
use crate::{Report, Results, Row, Table};

/// Name of the table of other readings of the settings.
pub const READINGS: &str = "other readings";
/// Name of the table of containment and divergence.
pub const CONTAINMENT: &str = "containment";

/// The paper's Table 1, atm.
fn paper(method: &str) -> Option<[f64; 2]> {
    match method {
        "ukf" => Some([0.0111, 0.0162]),
        "zf" => Some([0.0363, 0.103]),
        _ => None,
    }
}

/// Table 1 with the settings that fit.
#[must_use]
pub fn table_1(cells: &[Cell<2>]) -> Vec<Row> {
    let rows = |cell: &Cell<2>| cell.error_rows("Table 1", ["atm"; 2], true, paper(&cell.method).map(Paper::Same));
    cells.iter().flat_map(rows).collect()
}

/// The errors by the letter of (47), and with rates per second.
#[must_use]
pub fn readings(gaussian: &[Cell<2>], per_second: &[Cell<2>]) -> Vec<Row> {
    let relabelled = gaussian.iter().map(|cell| Cell { label: "all steps".into(), ..cell.clone() });
    let rows = |cell: Cell<2>| {
        cell.error_rows(READINGS, ["atm"; 2], false, paper(&cell.method).map(Paper::Other))
    };
    relabelled.chain(per_second.iter().cloned()).flat_map(rows).collect()
}

/// Puts tables and figures together.
#[must_use]
pub fn report(runs: usize, results: &Results, timings: &[Row]) -> Report {
    let mut report = Report::new("batch-reactor: unscented Kalman filter against zonotopic filter (paper 001, section 5.1)");
    report
        .heading("Table 1")
        .paragraph(format!(
            "{runs} runs of 25 min; the first {DROPPED} s are left out of the root mean squares. {}",
            Table::LEGEND
        ))
        .table(Table::pivot(results.table("Table 1")))
        .heading("Other readings")
        .table(Table::pivot(results.table(READINGS)))
        .heading("Containment")
        .table(Table::pivot(results.table(CONTAINMENT)))
        .heading("Time of a step")
        .table(Table::pivot(timings));
    report
}
