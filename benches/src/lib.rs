//! Timed comparisons with peers and floors. Not part of the tests: a figure here is a ratio measured in one run.
//!
//! `cargo xtask bench` prints the table; `cargo bench -p benches` runs criterion on our side of the same work.

pub mod constrained;
pub mod cz_sets;
pub mod draw;
pub mod filters;
pub mod groups;
pub mod hulls;
pub mod intervals;
pub mod lp_peers;
pub mod sets;
pub mod timing;

use timing::Bench;

/// Every comparison, in the order of the crates.
pub fn all() -> Vec<Bench> {
    let mut benches = intervals::benches();
    benches.extend(groups::benches());
    benches.extend(sets::benches());
    benches.extend(hulls::benches());
    benches.extend(constrained::benches());
    benches.extend(filters::benches());
    benches
}
