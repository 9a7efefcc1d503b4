//! Rows of `results.json` from the cells of the studies.

use super::setting::MARKS;
use crate::Row;
use crate::contest::{Cell, Paper};

/// Name of the table of other readings of the settings.
pub const READINGS: &str = "other readings";
/// Name of the table of half widths.
pub const HALF_WIDTHS: &str = "half widths";
/// Name of the table of containment and divergence.
pub const CONTAINMENT: &str = "containment";

/// The paper's Table 1, atm.
#[must_use]
pub fn paper(method: &str) -> Option<[f64; 2]> {
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
    let relabelled = gaussian.iter().map(|cell| Cell { label: "all 1500 steps".into(), ..cell.clone() });
    let rows = |cell: Cell<2>| {
        let mut rows = cell.error_rows(READINGS, ["atm"; 2], false, paper(&cell.method).map(Paper::Other));
        rows.push(cell.row(READINGS, "divergences", "runs").value(cell.diverged() as f64));
        rows
    };
    relabelled.chain(per_second.iter().cloned()).flat_map(rows).collect()
}

/// Half widths of the bounds at some steps.
#[must_use]
pub fn half_widths(cells: &[Cell<2>]) -> Vec<Row> {
    cells.iter().flat_map(|cell| cell.half_width_rows(HALF_WIDTHS, ["atm"; 2], &[0, 1], &MARKS)).collect()
}

/// How often the truth is held, and what goes wrong.
#[must_use]
pub fn containment(studies: &[&[Cell<2>]]) -> Vec<Row> {
    studies.iter().copied().flatten().flat_map(|cell| cell.containment_rows(CONTAINMENT)).collect()
}
