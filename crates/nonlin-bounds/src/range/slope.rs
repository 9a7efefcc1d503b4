//! Slope form: `f_i(c) + S ([x] - c)` with the slopes `S_j = J_ij(c) + sum_k H_jk z_k / 2`.
//!
//! By Taylor's theorem `f_i(x) - f_i(c) = (J_i(c) + z'H / 2) z` with the Hessian at some point between; for a quadratic function it is
//! the same everywhere, and the interval of each slope is the exact one.

use scalars::Interval;

use super::Scratch;

/// The slope form of output `i`.
pub(super) fn range(scratch: &Scratch, i: usize) -> Interval {
    let z = &scratch.offsets;
    let mut sum = scratch.at.values()[i];
    for (j, start) in scratch.gradient_at(i).iter().enumerate() {
        let slope = (0..z.len()).fold(*start, |slope, k| slope + (scratch.second(i, j, k) * z[k]).scale(0.5));
        sum += slope * z[j];
    }
    sum
}
