//! Images and solution sets of zonotopes and constrained zonotopes: containment, the papers' numbers, sizes, allocations, bad input.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod paper;
mod planar;
