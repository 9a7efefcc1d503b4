//! Enclosing generators in a parallelotope along a given frame.

use scalars::rounding::add_up;

use super::selection::remove_selected;
use crate::bounds::{add_abs_row_sums, add_lengths, product_sum_bound, sum_bound};
use crate::{Workspace, Zonotope};

/// A frame is rejected if what it leaves to the box remainder exceeds this share of the set's extent in a row.
const MAX_RESIDUAL: f64 = 1e-9;

/// Replaces the selected columns `B: n x k` by the parallelotope `F diag(d)` of the frame `F: n x n` (`workspace.frame`), given approximate
/// coordinates `D ~ F^-1 B` (`workspace.coordinates`, `n x k`). Returns `false`, the set unchanged, if the frame is no good.
///
/// `B xi = F D xi + (B - F D) xi` holds for **any** floats `F`, `D`. With `d_k = sum_j |D_kj|` the first term lies in
/// `{ F diag(d) zeta : |zeta| <= 1 }`, the second in the box of the row sums of `|B - F D|`. So the result encloses the set however badly
/// the coordinates were computed; the row sums and the rounding of `F diag(d)` go to the box remainder.
pub(super) fn enclose_selected(set: &mut Zonotope, workspace: &mut Workspace) -> bool {
    let (n, count) = (set.dim(), workspace.selected.len());
    let Workspace { frame, coordinates, scales, row_sums, remainder, selected, .. } = workspace;
    scales.clear();
    scales.resize(n, 0.0);
    add_abs_row_sums(coordinates, scales);
    for d in scales.iter_mut() {
        *d = sum_bound(*d, count + 4);
    }
    row_sums.clear();
    row_sums.resize(n, 0.0);
    add_abs_row_sums(set.generators.as_slice(), row_sums);
    remainder.clear();
    for i in 0..n {
        let (mut residual, mut magnitude) = (0.0, 0.0);
        for (&j, column) in selected.iter().zip(coordinates.chunks_exact(n)) {
            let b = set.generators.col(j)[i];
            residual += (0..n).fold(b, |rest, k| rest - frame[k * n + i] * column[k]).abs();
            magnitude += b.abs();
        }
        magnitude += (0..n).map(|k| frame[k * n + i].abs() * scales[k]).sum::<f64>();
        let bound = if magnitude == 0.0 && is_zero_row(set, selected, frame, scales, i) {
            0.0
        } else {
            // One residual is off by gamma_{n+1} times its terms, F diag(d) by u, the sums by their length.
            let rounding = f64::EPSILON * (n + 2) as f64 * magnitude;
            let terms = (count + 1) * (n + 1);
            add_up(sum_bound(residual, count), product_sum_bound(rounding, terms, 2 * (count + n) + 4))
        };
        // NaN fails the comparison.
        let good = bound <= MAX_RESIDUAL * row_sums[i] && (set.remainder[i] + bound).is_finite();
        if !good {
            return false;
        }
        remainder.push(add_lengths(set.remainder[i], bound));
    }
    // Every entry of F diag(d) is below its row's magnitude, which passed the test against a finite row sum.
    set.remainder.copy_from_slice(remainder);
    remove_selected(set, selected);
    for (column, &d) in frame.chunks_exact_mut(n).zip(scales.iter()) {
        if d > 0.0 {
            column.iter_mut().for_each(|x| *x *= d);
            set.generators.append_columns(column);
        }
    }
    true
}

/// Whether row `i` of the selected columns and of `F diag(d)` is zero because every factor is.
fn is_zero_row(set: &Zonotope, selected: &[usize], frame: &[f64], scales: &[f64], i: usize) -> bool {
    let n = scales.len();
    selected.iter().all(|&j| set.generators.col(j)[i] == 0.0)
        && (0..n).all(|k| frame[k * n + i] == 0.0 || scales[k] == 0.0)
}
