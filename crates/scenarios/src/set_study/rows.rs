//! Rows of a study: sizes at single steps, averages, containment, convergence.

use super::{Cell, Measure};
use crate::Row;

/// Table of the containment studies.
pub const CONTAINMENT: &str = "Containment";

/// An empty row of a cell.
#[must_use]
pub fn row_of(table: &str, row: &str, cell: &Cell) -> Row {
    Row::new(table, row, &*cell.method).mode(cell.mode)
}

/// `<measure>@k` for the steps asked for; `measure` is the index of `of` in the study.
#[must_use]
pub fn at_steps(table: &str, row: &str, cell: &Cell, (measure, of): (usize, Measure), steps: &[usize]) -> Vec<Row> {
    let at =
        |&k: &usize| row_of(table, row, cell).metric(format!("{}@{k}", of.name), of.unit).mean_of(&cell.at(measure, k));
    steps.iter().map(at).collect()
}

/// `mean(<measure>)`, the average over all steps.
#[must_use]
pub fn mean(table: &str, row: &str, cell: &Cell, (measure, of): (usize, Measure)) -> Row {
    let averages = cell.averages(measure, 0, usize::MAX);
    row_of(table, row, cell).metric(format!("mean({})", of.name), of.unit).mean_of(&averages)
}

/// `mean(<measure>)@..k`, the average up to step `k`.
#[must_use]
pub fn mean_to(table: &str, row: &str, cell: &Cell, (measure, of): (usize, Measure), to: usize) -> Row {
    let averages = cell.averages(measure, 0, to);
    row_of(table, row, cell).metric(format!("mean({})@..{to}", of.name), of.unit).mean_of(&averages)
}

/// `convergence`: the share of runs whose measure at `step` is at most `limit`, in percent.
#[must_use]
pub fn convergence(table: &str, row: &str, cell: &Cell, measure: usize, step: usize, limit: f64) -> Row {
    let last = cell.at(measure, step);
    let share = last.iter().filter(|&&value| value <= limit).count() as f64 / last.len().max(1) as f64;
    row_of(table, row, cell).metric("convergence", "%").value(100.0 * share)
}

/// Shares of steps at which the truth is not proven lost and at which it is proven inside; runs that ended with a proven contradiction, and
/// with enclosures that are not finite.
#[must_use]
pub fn containment(row: &str, cell: &Cell) -> [Row; 4] {
    let shares: Vec<(f64, f64)> = cell.runs.iter().filter_map(|run| run.containment.shares()).collect();
    let share = |metric: &str, pick: fn(&(f64, f64)) -> f64| {
        row_of(CONTAINMENT, row, cell).metric(metric, "").mean_of(&shares.iter().map(pick).collect::<Vec<_>>())
    };
    let runs = |metric: &str, count: usize| row_of(CONTAINMENT, row, cell).metric(metric, "runs").value(count as f64);
    [
        share("containment", |shares| shares.0),
        share("contained_proven", |shares| shares.1),
        runs("contradictions", cell.contradictions()),
        runs("diverged", cell.diverged()),
    ]
}
