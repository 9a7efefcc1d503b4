//! Derivatives over boxes: against other implementations, exact rationals, and on functions that are not smooth.
#![allow(clippy::unwrap_used, reason = "test helpers")]

#[path = "../common/mod.rs"]
mod common;

mod blocks;
mod exact;
mod examples;
mod peer;
mod smooth;
mod structured;
