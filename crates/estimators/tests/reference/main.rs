//! The papers' numbers, fixtures, and the answers to bad input.

#[path = "../support/mod.rs"]
mod support;

mod bad_input;
mod placement;
mod vehicle;
