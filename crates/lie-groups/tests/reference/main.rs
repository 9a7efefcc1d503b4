//! The `f64` groups against definitions evaluated in double-double, long products, and the typed errors.

#![allow(clippy::unwrap_used)]

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod coefficients;
mod drift;
mod errors;
