//! Bounds, certificates and witnesses against exact rational arithmetic.
#![allow(clippy::unwrap_used, reason = "a failing unwrap is a failing test")]

#[path = "../common/mod.rs"]
mod common;

mod adversary;
mod bounds;
mod emptiness;
mod many_decades;
