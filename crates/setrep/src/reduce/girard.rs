//! Girard's reduction: box the generators that a box encloses best.
//!
//! As [Combastel's](super::combastel), with the columns sorted by `|g|_1 - |g|_inf`: the measure is zero for a column along an axis,
//! whose box is exact, and for a zero column.
//!
//! **Source:** Girard 2005; Yang and Scott 2018, method 2.

use super::selection::{box_selected, select_smallest};
use crate::{SetError, Workspace, Zonotope};

/// Reduces a set with more than `s >= n` generators to at most `s`.
pub(super) fn reduce(set: &mut Zonotope, s: usize, workspace: &mut Workspace) -> Result<(), SetError> {
    let n = set.dim();
    let count = set.num_generators() - (s - n);
    workspace.scales.clear();
    workspace.scales.extend(set.generators.columns().map(|g| {
        let (sum, largest) = g.iter().fold((0.0, 0.0_f64), |(sum, largest), x| (sum + x.abs(), largest.max(x.abs())));
        sum - largest
    }));
    select_smallest(count, workspace);
    box_selected(set, workspace)
}
