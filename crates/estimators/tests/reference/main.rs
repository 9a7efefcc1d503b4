//! The papers' numbers, fixtures, and the answers to bad input.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

#[path = "../support/mod.rs"]
mod support;

mod bad_input;
mod placement;
mod vehicle;
