//! Polytopic images and solution sets: containment of exact points, sizes against brute force and values by hand, bad input.

// Helpers outside the test functions fail by panic as well.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod bad_input;
mod images;
mod polynomials;
mod sizes;
mod solutions;
