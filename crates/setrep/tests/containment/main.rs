//! Every operation contains the exact result: random sets and members, checked in exact dyadic arithmetic by an explicit witness.
//!
//! Each battery also counts how often the same check fails once the rounding terms are stripped from the result, and requires
//! that it does: a battery that passes without them proves nothing.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod affine;
mod bounds;
mod interval_map;
mod linear_map;
mod membership;
mod minkowski_sum;
mod reduction;
mod strips;
mod volume;

/// Seed of all batteries; printed with every failing case.
const SEED: u64 = 20_261_122;
