//! Images and solution sets of zonotopes and constrained zonotopes: containment, the papers' numbers, sizes, allocations, bad input.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
#[path = "../polytopic/polynomials.rs"]
#[allow(dead_code)]
mod polynomials;
#[path = "../../../setrep/tests/common/mod.rs"]
mod sets;

mod allocations;
mod bad_input;
mod dc;
mod decomposition;
mod exact;
mod generated;
mod hand_written;
mod members;
mod models;
mod noises;
mod paper;
mod planar;
mod quadratic;
mod tightness;

/// Seed of all batteries; printed with every failing case.
const SEED: u64 = 20_261_122;
