//! The range on the box against the mean gradient.

use scalars::Interval;

use super::fit::{Parts, midpoints};

/// `J = mid f'(H)` (0 where that is unbounded), `[e] = f(H) - J d`.
pub(super) fn row(parts: &Parts<'_>, i: usize, row: &mut [f64]) -> Interval {
    row.fill(0.0);
    midpoints(parts.gradient_over_box(i).iter(), row);
    offset(parts, i, row)
}

/// `f(H) - J d`, an offset for any row `J`.
pub(super) fn offset(parts: &Parts<'_>, i: usize, row: &[f64]) -> Interval {
    let mut offset = parts.over_box.values()[i];
    for (&entry, step) in row.iter().zip(parts.steps) {
        if entry != 0.0 {
            offset -= step.scale(entry);
        }
    }
    offset
}
