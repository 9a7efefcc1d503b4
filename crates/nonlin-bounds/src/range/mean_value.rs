//! Mean value form: `f_i(c) + [J_i] ([x] - c)`.
//!
//! On the segment from `c` to `x`, which lies in the box, `f_i(x) - f_i(c)` is the gradient at one of its points times `x - c`.

use scalars::Interval;

use super::Scratch;

/// The mean value form of output `i`.
pub(super) fn range(scratch: &Scratch, i: usize) -> Interval {
    let terms = scratch.gradient(i).iter().zip(&scratch.offsets);
    terms.fold(scratch.at.values()[i], |sum, (slope, z)| sum + *slope * *z)
}
