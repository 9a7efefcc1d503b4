//! The laws of a Lie group, run on every group over every scalar by one line each.
//!
//! Over `f64` both sides of a law must agree to a relative 1e-13; over intervals they enclose the same exact number, so they must meet,
//! and the hull of both must be as narrow.

#![allow(clippy::unwrap_used)]

#[path = "../support/mod.rs"]
mod support;

mod battery;
mod probe;

use lie_groups::{Rn, SE2, SO2};
use scalars::Interval;

battery::laws!(so2_f64: SO2<f64>, 1, 2);
battery::laws!(se2_f64: SE2<f64>, 3, 2);
battery::laws!(r1_f64: Rn<f64, 1>, 1, 1);
battery::laws!(r3_f64: Rn<f64, 3>, 3, 3);
battery::laws!(so2_interval: SO2<Interval>, 1, 2);
battery::laws!(se2_interval: SE2<Interval>, 3, 2);
battery::laws!(r1_interval: Rn<Interval, 1>, 1, 1);
battery::laws!(r3_interval: Rn<Interval, 3>, 3, 3);
