//! Timed comparisons with peers and floors. Not part of the tests: a figure here is a ratio measured in one run.
//!
//! `cargo xtask bench` prints the table; `cargo bench -p benches` runs the criterion benches of the same work.

pub mod timing;
