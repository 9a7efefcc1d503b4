//! Constrained zonotopes: every operation contains the exact result, and the results have the right size.
//!
//! Containment is checked in exact dyadic arithmetic, by an explicit witness where an operation has one, by exact comparison with
//! support values and by proofs of non-membership where it has none.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod allocations;
mod bad_input;
mod conversions;
mod emptiness;
mod hull_and_projection;
mod inclusion;
mod intersection;
mod maps;
mod member;
mod optimization;
mod peers;
mod reduction;
mod reencoding;
mod simplification;
mod strips;

/// Seed of all batteries; printed with every failing case.
const SEED: u64 = 20_261_123;
