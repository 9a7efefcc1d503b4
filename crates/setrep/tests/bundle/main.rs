//! Zonotope bundles: containment against exact arithmetic, proofs, sizes, conversions.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
#[path = "../cz/member.rs"]
mod member;

mod containment;
mod cuts;
mod reduction;

/// Seed of all batteries; printed with every failing case.
const SEED: u64 = 20_261_125;
