//! Bounds, certificates and witnesses against exact rational arithmetic.

#[path = "../common/mod.rs"]
mod common;

mod bounds;
mod emptiness;
