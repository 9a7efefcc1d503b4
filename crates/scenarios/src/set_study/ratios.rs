//! `ARR`, the average radius ratio of two filters (paper 003, Section 5.2).

use super::Cell;
use super::rows::row_of;
use crate::Row;

/// The radius of one filter over that of another, averaged over the steps, run by run; the radius is measure 0 of both.
///
/// Not finite where the first one diverged; runs in which the second one did are left out.
#[must_use]
pub fn average_ratios(of: &Cell, over: &Cell) -> Vec<f64> {
    average_ratios_to(usize::MAX, of, over)
}

/// [`average_ratios`] over the steps up to `last`.
#[must_use]
pub fn average_ratios_to(last: usize, of: &Cell, over: &Cell) -> Vec<f64> {
    let some = |values: &'_ [f64]| -> usize { values.len().min(last.saturating_add(1)) };
    let runs = of.runs.iter().zip(&over.runs).map(|(of, over)| {
        let (of, over) = (&of.values[0], &over.values[0]);
        (&of[..some(of)], &over[..some(over)])
    });
    runs.filter(|(_, over)| over.iter().all(|value| value.is_finite()))
        .map(|(of, over)| of.iter().zip(over).map(|(a, b)| a / b).sum::<f64>() / of.len() as f64)
        .collect()
}

/// The `ARR` of `of` (the paper's column) over `over` (the paper's row, in capitals).
#[must_use]
pub fn row(table: &str, of: &Cell, over: &Cell) -> Row {
    row_of(table, &over.method.to_uppercase(), of).metric("ARR", "").mean_of(&average_ratios(of, over))
}
