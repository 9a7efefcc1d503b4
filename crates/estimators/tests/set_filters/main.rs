//! Set filters on the examples of paper 003: containment, sizes, faults.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

mod constrained;
mod delayed;
mod faults;
mod linear;
mod plants;
mod rcz;
#[path = "../support/mod.rs"]
mod support;
mod zf;
mod zonotopic;
