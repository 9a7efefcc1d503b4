//! Shared by the test binaries: exact dyadic arithmetic, exact points of sets, reproducible random sets.
#![allow(dead_code)]

pub mod dyadic;
pub mod exact;
pub mod random;
