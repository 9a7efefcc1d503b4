//! Set filters on the examples of paper 003: containment, sizes, faults.

mod plants;
mod rcz;
#[path = "../support/mod.rs"]
mod support;
