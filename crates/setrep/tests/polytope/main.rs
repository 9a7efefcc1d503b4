//! Polytopes against exact rational arithmetic: combinatorics, enclosures, volumes, degenerate and bad input.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
mod oracle;
mod samples;

mod bad_input;
mod boxed_rows;
mod containment;
mod conversions;
mod degenerate;
mod enclosing;
mod fewer;
mod fixtures;
mod known_polytopes;
mod membership;
mod programs;
