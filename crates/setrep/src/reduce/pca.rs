//! Reduction along principal axes: keep the longest generators, enclose the others in a rotated box.
//!
//! With `B` the columns to enclose and `U` the eigenvectors of `B B'`, `{ B xi }` lies in the box with axes `U` and half-widths
//! `sum_j |U'B|_ij`. The columns are chosen by 2-norm as in [Combastel's](super::combastel) reduction.
//!
//! **Source:** Kopetzki, Schuermann, Althoff 2017 (PCA); enclosure for computed, not quite orthogonal `U`: [`frame`].

use super::{combastel, frame, jacobi, selection};
use crate::{SetError, Workspace, Zonotope};

/// Reduces a set with more than `s >= n` generators to at most `s`; boxes as Combastel where the axes are not accurate enough.
pub(super) fn reduce(set: &mut Zonotope, s: usize, workspace: &mut Workspace) -> Result<(), SetError> {
    combastel::select_shortest(set, s, workspace);
    principal_axes(set, workspace);
    if frame::enclose_selected(set, workspace) {
        return Ok(());
    }
    selection::box_selected(set, workspace)
}

/// Fills frame and coordinates `U'B` of the selected columns.
fn principal_axes(set: &Zonotope, workspace: &mut Workspace) {
    let n = set.dim();
    let Workspace { frame, coordinates, eigen, selected, .. } = workspace;
    // Columns in units of the largest entry, so that no square overflows or vanishes as a whole.
    let largest = selected.iter().flat_map(|&j| set.generators.col(j)).fold(0.0_f64, |m, x| m.max(x.abs()));
    let unit = if largest.is_normal() { 1.0 / largest } else { 1.0 };
    eigen.clear();
    eigen.resize(n * n, 0.0);
    for &j in selected.iter() {
        let g = set.generators.col(j);
        for k in 0..n {
            for i in 0..n {
                eigen[k * n + i] += (g[i] * unit) * (g[k] * unit);
            }
        }
    }
    jacobi::eigenvectors(eigen, n, frame);
    coordinates.clear();
    for &j in selected.iter() {
        let g = set.generators.col(j);
        coordinates.extend(frame.chunks_exact(n).map(|u| u.iter().zip(g).map(|(u, g)| u * g).sum::<f64>()));
    }
}
