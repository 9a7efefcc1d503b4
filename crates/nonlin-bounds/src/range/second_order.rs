//! Second-order form: Lagrange's remainder with one-sided squares.
//!
//! `f_i(x) = f_i(c) + J_i(c) z + z'H z / 2`. Grouped by coordinates this is
//! `f_i(c) + sum_j ( a_j z_j + (H_jj / 2) z_j^2 )` with `a_j = J_ij(c) + sum_{k != j} H_jk z_k / 2`, and the parabola in each `z_j` is bounded
//! as a whole: its square has one sign, and its two terms have one `z_j`.

use scalars::Interval;

use super::{Scratch, parabola::parabola};

/// The second-order form of output `i`.
pub(super) fn range(scratch: &Scratch, i: usize) -> Interval {
    let z = &scratch.offsets;
    let mut sum = scratch.at.values()[i];
    for (j, start) in scratch.gradient_at(i).iter().enumerate() {
        let others = (0..z.len()).filter(|&k| k != j);
        let slope = others.fold(*start, |slope, k| slope + (scratch.second(i, j, k) * z[k]).scale(0.5));
        sum += parabola(slope, scratch.second(i, j, j).scale(0.5), z[j]);
    }
    sum
}
