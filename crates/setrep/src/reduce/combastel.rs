//! Combastel's reduction, the `R_s` of the papers: keep the longest generators, box the others.
//!
//! With the columns sorted by 2-norm, `R_s G = [K diag(sum_j |b_j|)]`, where `K` holds the `s - n` longest columns and `b_j`
//! runs over the rest. The sums are of **absolute values**: `|(B xi)_i| <= sum_j |b_ij|` for `|xi| <= 1`.
//!
//! **Source:** Combastel 2003; paper 000, Property 2.2 (with the absolute value, without which it is no enclosure).

use super::selection::{box_selected, select_smallest};
use crate::{SetError, Workspace, Zonotope};

/// Reduces a set with more than `s >= n` generators to at most `s`.
pub(super) fn reduce(set: &mut Zonotope, s: usize, workspace: &mut Workspace) -> Result<(), SetError> {
    select_shortest(set, s, workspace);
    box_selected(set, workspace)
}

/// Selects all but the `s - n` columns of largest 2-norm.
pub(super) fn select_shortest(set: &Zonotope, s: usize, workspace: &mut Workspace) {
    let n = set.dim();
    let count = set.num_generators() - (s - n);
    let data = set.generators.as_slice();
    let norms = &mut workspace.scales;
    norms.clear();
    match n {
        2 => norms.extend(data.as_chunks::<2>().0.iter().map(|g| squared(g))),
        3 => norms.extend(data.as_chunks::<3>().0.iter().map(|g| squared(g))),
        _ => norms.extend(data.chunks_exact(n).map(squared)),
    }
    let largest = norms.iter().copied().fold(0.0, f64::max);
    if !(1e-250..1e300).contains(&largest) {
        // The squares over- or underflow: any selection is valid, the largest entries are a good one.
        norms.clear();
        norms.extend(data.chunks_exact(n).map(|g| g.iter().fold(0.0, |m: f64, x| m.max(x.abs()))));
    }
    select_smallest(count, workspace);
}

/// `|g|_2^2`.
#[inline]
fn squared(g: &[f64]) -> f64 {
    g.iter().map(|x| x * x).sum()
}
