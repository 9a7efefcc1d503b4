//! Choosing columns by a key, and putting the chosen ones into a box.

use crate::bounds::sum_bound;
use crate::{SetError, Workspace, Zonotope};

/// Selects the `count` columns of least key (`workspace.scales`, nonnegative) into `workspace.selected`, in ascending order.
///
/// Key and column travel in one integer: the bits of a nonnegative float are ordered as the float is, and its lowest bits, which
/// make no difference that matters to a heuristic, hold the column.
pub(super) fn select_smallest(count: usize, workspace: &mut Workspace) {
    let (values, keys, selected) = (&workspace.scales, &mut workspace.keys, &mut workspace.selected);
    let mask = (values.len().next_power_of_two() - 1) as u64;
    keys.clear();
    keys.extend(values.iter().enumerate().map(|(j, value)| (value.max(0.0).to_bits() & !mask) | j as u64));
    if count < keys.len() {
        keys.select_nth_unstable(count);
        keys.truncate(count);
    }
    selected.clear();
    selected.extend(keys.iter().map(|key| (key & mask) as usize));
    selected.sort_unstable();
}

/// Replaces the selected columns by the box `diag(sum_j |g_j|)` around them, without its zero columns.
pub(super) fn box_selected(set: &mut Zonotope, workspace: &mut Workspace) -> Result<(), SetError> {
    let n = set.dim();
    let sums = &mut workspace.row_sums;
    sums.clear();
    sums.resize(n, 0.0);
    for &j in &workspace.selected {
        for (sum, x) in sums.iter_mut().zip(set.generators.col(j)) {
            *sum += x.abs();
        }
    }
    for (row, sum) in sums.iter_mut().enumerate() {
        *sum = sum_bound(*sum, workspace.selected.len());
        if !sum.is_finite() {
            return Err(SetError::Overflow { row });
        }
    }
    remove_selected(set, &workspace.selected);
    for (i, &sum) in sums.iter().enumerate() {
        if sum > 0.0 {
            set.generators.push_axis(i, sum);
        }
    }
    Ok(())
}

/// Removes the selected (ascending) columns: kept columns from the end fill the holes.
pub(super) fn remove_selected(set: &mut Zonotope, selected: &[usize]) {
    let kept = set.num_generators() - selected.len();
    let holes = selected.partition_point(|&j| j < kept);
    let mut behind = selected[holes..].iter().copied().peekable();
    let mut last = kept;
    for &hole in &selected[..holes] {
        while behind.next_if_eq(&last).is_some() {
            last += 1;
        }
        set.generators.copy_col(last, hole);
        last += 1;
    }
    set.generators.truncate_cols(kept);
}
