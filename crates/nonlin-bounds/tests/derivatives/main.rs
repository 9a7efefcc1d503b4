//! Derivatives over boxes: against other implementations, exact rationals, and on functions that are not smooth.

#[path = "../common/mod.rs"]
mod common;

mod examples;
