//! The `f64` groups against definitions evaluated in double-double, long products, and the typed errors.

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod coefficients;
mod drift;
mod errors;
