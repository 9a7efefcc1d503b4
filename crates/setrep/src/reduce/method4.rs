//! Method 4 (Chisci; Yang and Scott): a parallelotope of `n` generators takes in the others, the cheapest in volume first.
//!
//! Full pivoting picks `n` independent columns `T`; the others are `T R`. Enclosing column `r = R_j` scales the parallelotope by
//! `1 + |r_i|` along its `i`-th axis, so it costs about `prod_i (1 + |r_i|) - (1 + sum_i |r_i|)` in volume (the sum is what the set had
//! anyway). After each step `r` is measured in the scaled axes: with `d_i = 1 + sum |r_i|` over the columns taken in, the cost of
//! column `j` is that of `R_ij / d_i`. The columns that stay are the original ones.
//!
//! **Source:** Chisci, Garulli, Zappa 1996; Scott, Raimondo, Marseglia, Braatz 2016; Yang and Scott 2018, method 4. Enclosure for a
//! computed `R`: [`frame`].

use super::{combastel, frame};
use crate::{SetError, Workspace, Zonotope};

/// Pivots below this (rows scaled to 1-norm 1) count as zero: the generators do not span the space.
const RANK_TOLERANCE: f64 = 1e-12;

/// Reduces a set with more than `s >= n` generators to at most `s`; as Combastel if the frame is too ill-conditioned.
pub(super) fn reduce(set: &mut Zonotope, s: usize, workspace: &mut Workspace) -> Result<(), SetError> {
    if pivot(set, workspace) {
        let absorbed = set.num_generators() - s;
        absorb_cheapest(set, absorbed, workspace);
        if frame::enclose_selected(set, workspace) {
            return Ok(());
        }
    }
    combastel::reduce(set, s, workspace)
}

/// Gauss-Jordan elimination with full pivoting on the generators with rows scaled to 1-norm 1. Leaves `R` (all columns) in
/// `workspace.matrix`, the pivot columns in row order in `workspace.selected` and as the frame; `false` if there is no pivot at all.
///
/// Generators that do not span the space (those of a flat set, or of the lift of a set with measured rows, which are combinations of
/// the others) have rows without a pivot. `R` and the frame are zero there: the parallelotope is one in the span.
fn pivot(set: &Zonotope, workspace: &mut Workspace) -> bool {
    let (n, m) = (set.dim(), set.num_generators());
    let Workspace { matrix: a, selected, row_sums, frame, .. } = workspace;
    row_sums.clear();
    row_sums.resize(n, 0.0);
    crate::bounds::add_abs_row_sums(set.generators.as_slice(), row_sums);
    a.clear();
    a.extend(
        set.generators
            .columns()
            .flat_map(|g| g.iter().zip(row_sums.iter()).map(|(g, sum)| if *sum > 0.0 { g / sum } else { 0.0 })),
    );
    // A row without pivot holds this mark.
    selected.clear();
    selected.resize(n, usize::MAX);
    for _ in 0..n {
        let (mut best, mut row, mut col) = (RANK_TOLERANCE, usize::MAX, 0);
        for j in 0..m {
            for i in 0..n {
                if selected[i] == usize::MAX && a[j * n + i].abs() > best {
                    (best, row, col) = (a[j * n + i].abs(), i, j);
                }
            }
        }
        if row == usize::MAX {
            break;
        }
        selected[row] = col;
        eliminate(a, n, row, col);
    }
    frame.clear();
    for (i, &j) in selected.iter().enumerate() {
        if j == usize::MAX {
            frame.extend((0..n).map(|_| 0.0));
            // What elimination has left in such a row is rounding.
            a.iter_mut().skip(i).step_by(n).for_each(|x| *x = 0.0);
        } else {
            frame.extend_from_slice(set.generators.col(j));
        }
    }
    selected.iter().any(|&j| j != usize::MAX)
}

/// Makes column `col` the unit vector of `row` by row operations.
fn eliminate(a: &mut [f64], n: usize, row: usize, col: usize) {
    let inverse = 1.0 / a[col * n + row];
    for j in (0..a.len() / n).filter(|&j| j != col) {
        let share = a[j * n + row] * inverse;
        for i in 0..n {
            if i != row {
                a[j * n + i] -= share * a[col * n + i];
            }
        }
        a[j * n + row] = share;
    }
    for i in 0..n {
        a[col * n + i] = f64::from(u8::from(i == row));
    }
}

/// Adds the `count` cheapest columns to the selected ones, and fills the coordinates of all selected columns in ascending order.
fn absorb_cheapest(set: &Zonotope, count: usize, workspace: &mut Workspace) {
    let n = set.dim();
    let Workspace { matrix: r, selected, scales, row_sums: inverses, keys, coordinates, .. } = workspace;
    scales.clear();
    scales.resize(n, 1.0);
    inverses.clear();
    inverses.resize(n, 1.0);
    // The columns that are still outside.
    keys.clear();
    keys.extend((0..set.num_generators()).filter(|j| !selected.contains(j)).map(|j| j as u64));
    for _ in 0..count.min(keys.len()) {
        let (mut least, mut choice) = (f64::INFINITY, 0);
        for (position, &j) in keys.iter().enumerate() {
            let cost = growth(&r[j as usize * n..][..n], inverses);
            if cost < least {
                (least, choice) = (cost, position);
            }
        }
        let j = keys.swap_remove(choice) as usize;
        for ((d, inverse), x) in scales.iter_mut().zip(inverses.iter_mut()).zip(&r[j * n..][..n]) {
            *d += x.abs();
            *inverse = 1.0 / *d;
        }
        selected.push(j);
    }
    selected.retain(|&j| j != usize::MAX);
    selected.sort_unstable();
    coordinates.clear();
    coordinates.extend(selected.iter().flat_map(|&j| &r[j * n..][..n]));
}

/// `prod_i (1 + x_i) - (1 + sum_i x_i)` for `x_i = |r_i| / d_i`, without cancellation, given the `1 / d_i`.
fn growth(r: &[f64], inverses: &[f64]) -> f64 {
    let (mut sum, mut higher) = (0.0, 0.0);
    for (r, inverse) in r.iter().zip(inverses) {
        let x = r.abs() * inverse;
        higher += x * (sum + higher);
        sum += x;
    }
    higher
}
