//! Rows of `results.json` from the cells of the study.

use super::filters::Method;
use super::study::{Cell, Sample, Track};
use crate::Row;

/// Name of the table of convergence.
pub const TABLE_1: &str = "Table I";
/// Name of the table of errors.
pub const ERRORS: &str = "errors";
/// Name of the table of other settings.
pub const VARIANTS: &str = "other settings";
/// Seconds at which errors are shown.
pub const MARKS_S: [usize; 4] = [5, 20, 50, 60];
/// Runs of the paper's table.
pub const PAPER_RUNS: usize = 50;

/// The paper's Table I, percent.
#[must_use]
pub fn paper(method: Method) -> f64 {
    match method {
        Method::Tfg => 98.0,
        Method::Imperfect => 34.0,
        Method::Ekf => 14.0,
    }
}

/// The share of tracks with a property, percent.
pub fn percent<'a>(tracks: impl Iterator<Item = &'a Track>, is: impl Fn(&Track) -> bool) -> f64 {
    let (mut of, mut with) = (0_usize, 0_usize);
    for track in tracks {
        of += 1;
        with += usize::from(is(track));
    }
    100.0 * with as f64 / of as f64
}

/// Label of a cell.
#[must_use]
pub fn label(cell: &Cell, runs: usize) -> String {
    format!("{}, sigma {} deg, {runs} runs", cell.setting.name, cell.heading_deg)
}

/// Convergence in all runs of a cell, and in the first ones as many as the paper has.
fn convergence(table: &str, cell: &Cell, runs: usize, reproduces: bool) -> Vec<Row> {
    let mut rows = Vec::new();
    for method in Method::ALL {
        let tracks = || cell.tracks(method, runs);
        let row = |metric: &str, unit: &str| Row::new(table, label(cell, runs), method.name()).metric(metric, unit);
        let converged = row("convergence", "%").value(percent(tracks(), |track| track.convergent));
        rows.push(match (cell.heading_deg == 200.0, reproduces) {
            (true, true) => converged.paper(paper(method)),
            (true, false) => converged.paper_ref(paper(method)),
            (false, _) => converged,
        });
        rows.push(row("heading within 10 deg at the end", "%").value(percent(tracks(), Track::close)));
        rows.push(row("scale negative at the end", "runs").value(count(tracks(), Track::reversed)));
        rows.push(row("scale negative at any step", "runs").value(count(tracks(), |track| track.least_scale < 0.0)));
        rows.push(row("least scale", "").value(tracks().map(|track| track.least_scale).fold(f64::INFINITY, f64::min)));
        let nees = median(tracks().map(Track::mean_nees).collect());
        rows.push(row("median NEES/6@20..", "").value(nees / 6.0));
    }
    rows
}

fn count<'a>(tracks: impl Iterator<Item = &'a Track>, is: impl Fn(&Track) -> bool) -> f64 {
    tracks.filter(|track| is(track)).count() as f64
}

/// The median; infinities count, NaN counts as the largest.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Table I: convergence of every cell, in as many runs as the paper has and in all.
#[must_use]
pub fn table_1(cells: &[Cell]) -> Vec<Row> {
    let rows = |cell: &Cell| {
        let (few, all) = (cell.runs.len().min(PAPER_RUNS), cell.runs.len());
        let mut rows = convergence(TABLE_1, cell, few, cell.setting.name == "BEST");
        if all > few {
            rows.extend(convergence(TABLE_1, cell, all, false));
        }
        rows
    };
    cells.iter().flat_map(rows).collect()
}

/// Convergence in the other settings.
#[must_use]
pub fn variants(cells: &[Cell]) -> Vec<Row> {
    cells.iter().flat_map(|cell| convergence(VARIANTS, cell, cell.runs.len(), false)).collect()
}

/// Name, unit and value of each error.
type Error = (&'static str, &'static str, fn(&Sample) -> f64);

/// The errors of Figure 2.
pub const NAMES: [Error; 4] = [
    ("yaw", "deg", |sample| sample.heading_rad.to_degrees()),
    ("scale", "", |sample| sample.errors[0]),
    ("x", "m", |sample| sample.errors[1]),
    ("X", "m", |sample| sample.errors[2]),
];

/// Root mean square over the runs of a cell at the end of a second.
#[must_use]
pub fn rmse(cell: &Cell, method: Method, second: usize, value: fn(&Sample) -> f64) -> f64 {
    let values = cell.tracks(method, usize::MAX).filter_map(|track| track.samples.get(second - 1).map(value));
    let (n, squares) = values.fold((0.0, 0.0), |(n, squares), value| (n + 1.0, squares + value * value));
    (squares / n).sqrt()
}

/// Root mean squares and medians of the errors at some seconds.
#[must_use]
pub fn errors(cells: &[Cell]) -> Vec<Row> {
    let mut rows = Vec::new();
    for cell in cells {
        for second in MARKS_S {
            for method in Method::ALL {
                let row = format!("{}, {second} s", label(cell, cell.runs.len()));
                for (name, unit, value) in NAMES {
                    let row = |metric: String| Row::new(ERRORS, row.clone(), method.name()).metric(metric, unit);
                    rows.push(row(format!("RMSE({name})")).value(rmse(cell, method, second, value)));
                    let all = cell.tracks(method, usize::MAX).filter_map(|track| track.samples.get(second - 1));
                    rows.push(row(format!("median({name})")).value(median(all.map(|s| value(s).abs()).collect())));
                }
            }
        }
    }
    rows
}
