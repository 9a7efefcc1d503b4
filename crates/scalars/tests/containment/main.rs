//! No exact result outside a computed interval.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../support/mod.rs"]
mod support;

mod arithmetic;
mod elementary;
mod literals;
mod rounding;
mod stumpff;
