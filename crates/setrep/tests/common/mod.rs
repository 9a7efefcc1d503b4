//! Shared by the test binaries: exact dyadic arithmetic, exact points of sets, reproducible random sets.
// Each binary uses its own part.
#![allow(dead_code)]

pub(crate) mod dyadic;
pub(crate) mod exact;
pub(crate) mod random;
