//! No exact result outside a computed interval.

#[path = "../support/mod.rs"]
mod support;

mod arithmetic;
mod elementary;
mod literals;
mod rounding;
mod stumpff;
