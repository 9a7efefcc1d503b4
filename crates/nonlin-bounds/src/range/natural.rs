//! Natural interval extension: `f_i([x], [p])`.

use scalars::Interval;

use super::Scratch;

/// The range that the evaluation over the box found.
pub(super) fn range(scratch: &Scratch, i: usize) -> Interval {
    scratch.over.values()[i]
}
