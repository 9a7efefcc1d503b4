//! Timed comparisons with peers and floors. Not part of the tests: a figure here is a ratio measured in one run.
//!
//! `cargo xtask bench` prints the table; `cargo xtask bench growth` draws how the costs of hulls and filter steps grow; `cargo bench -p benches` runs criterion on our side of the same work.

pub mod constrained;
pub mod contract;
pub mod cz_sets;
pub mod derivatives;
pub mod draw;
pub mod filters;
pub mod groups;
pub mod growth;
pub mod hulls;
pub mod intervals;
pub mod invariant_strips;
pub mod lp_peers;
pub mod polytopes;
pub mod set_filters;
pub mod sets;
pub mod step_growth;
pub mod strips;
pub mod timing;

/// The functions that are timed: those of the tests.
#[path = "../../crates/nonlin-bounds/tests/common/functions.rs"]
#[allow(dead_code, reason = "the benches use some of them")]
mod functions;

use timing::Bench;

/// Every comparison, in the order of the crates.
pub fn all() -> Vec<Bench> {
    let mut benches = intervals::benches();
    benches.extend(groups::benches());
    benches.extend(sets::benches());
    benches.extend(strips::benches());
    benches.extend(derivatives::benches());
    benches.extend(hulls::benches());
    benches.extend(constrained::benches());
    benches.extend(contract::benches());
    benches.extend(filters::benches());
    benches.extend(invariant_strips::benches());
    benches.extend(set_filters::benches());
    benches.extend(polytopes::benches());
    benches
}
