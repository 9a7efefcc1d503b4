//! Rows of the experiments of paper 004, beside the paper's numbers.

use super::sizes::{FACETS, VERTICES, VOLUME};
use crate::results::mean_and_sd;
use crate::set_study::rows::{at_steps, containment};
use crate::set_study::{Cell, Measure};
use crate::{Row, Table};

/// Volumes of the paper, `k = 0 ..= 4`, by method.
pub type PaperVolumes = [(&'static str, [f64; 5])];

/// Rows of a cell: volumes beside the paper's (`reproduces`: its settings), numbers of vertices and facets of V-H, containment.
#[must_use]
pub fn rows(
    table: &str,
    row: &str,
    cell: &Cell,
    unit: &'static str,
    paper: &PaperVolumes,
    reproduces: bool,
) -> Vec<Row> {
    let steps = [0, 1, 2, 3, 4];
    let method = cell.method.split('/').next().unwrap_or_default();
    let printed = paper.iter().find(|(name, _)| *name == method).map(|(_, volumes)| volumes);
    let plain = method == cell.method;
    let mut rows = at_steps(table, row, cell, (0, Measure { unit, ..VOLUME }), &steps);
    if let Some(printed) = printed {
        rows = rows
            .into_iter()
            .zip(printed)
            .map(|(row, &volume)| if reproduces && plain { row.paper(volume) } else { row.paper_ref(volume) })
            .collect();
    }
    if method == "vh" {
        rows.extend(at_steps(FACES, row, cell, (1, VERTICES), &steps));
        rows.extend(at_steps(FACES, row, cell, (2, FACETS), &steps));
    }
    rows.extend(containment(row, cell));
    rows
}

/// Name of the table of vertices and facets.
pub const FACES: &str = "Vertices and facets";

/// Rows of one table as one; the cells are as [`Table::LEGEND`] says.
pub fn pivot<'a>(rows: &'a [Row], table: &'a str) -> Table {
    Table::pivot(rows.iter().filter(move |row| row.table_name() == table))
}

/// The distance of each mean from the paper's, `k = 0 ..= 4`, in standard errors of the difference: the paper's number is a mean over
/// `paper_runs` runs, which spread as ours do.
#[must_use]
pub fn standard_errors(cell: &Cell, printed: &[f64; 5], paper_runs: usize) -> Vec<f64> {
    let error = |(k, paper): (usize, &f64)| {
        let volumes = cell.at(0, k);
        let (mean, sd) = mean_and_sd(&volumes).unwrap_or((f64::NAN, None));
        let runs = 1.0 / volumes.len() as f64 + 1.0 / paper_runs as f64;
        (mean - paper) / (sd.unwrap_or(f64::NAN) * runs.sqrt())
    };
    printed.iter().enumerate().map(error).collect()
}

/// Whether every mean volume of one cell is at most that of another, up to rounding.
#[must_use]
pub fn is_nowhere_larger(cell: &Cell, than: &Cell) -> bool {
    cell.curve(0).iter().zip(than.curve(0)).all(|(a, b)| *a <= b * (1.0 + 1e-6))
}
