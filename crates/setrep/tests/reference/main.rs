//! Known values, size of the reductions, bad input, allocations, storage.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod allocations;
mod bad_input;
mod candidate_volumes;
mod known_sets;
mod membership;
mod reduction_size;
#[cfg(feature = "serde")]
mod storage;
mod strips;
