//! Expansion points and ranges of functions over boxes: they contain the values, and are as tight as promised.
#![allow(clippy::unwrap_used, reason = "test helpers")]

#[path = "../common/mod.rs"]
mod common;

mod bad_input;
mod containment;
mod expansion;
mod tightness;

use nonlin_bounds::{BoundError, DynFunction, RangeMethod, Workspace, range};
use scalars::Interval;

const METHODS: [RangeMethod; 6] = [
    RangeMethod::Natural,
    RangeMethod::MeanValue,
    RangeMethod::Slope,
    RangeMethod::SecondOrder,
    RangeMethod::MixedMonotone,
    RangeMethod::Tight,
];

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// The range in fresh memory, without parameters.
fn range_of(f: &dyn DynFunction, x: &[Interval], method: RangeMethod) -> Result<Vec<Interval>, BoundError> {
    let mut y = vec![Interval::EMPTY; f.outputs()];
    range(f, x, &[], method, &mut Workspace::new(), &mut y)?;
    Ok(y)
}
