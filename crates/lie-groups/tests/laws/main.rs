//! The laws of a Lie group, run on every group over every scalar by one line each.
//!
//! Over `f64` both sides of a law must agree to a relative 1e-13; over intervals they enclose the same exact number, so they must meet,
//! and the hull of both must be as narrow.

#![allow(clippy::unwrap_used)]

#[path = "../support/mod.rs"]
mod support;

mod battery;
mod probe;

use lie_groups::{RPlus, Rn, SE2, SE22, SO2, ScaledSO2, Sim2, TfgLever2, TfgScaleLever2};
use scalars::Interval;

battery::laws! {
    so2_f64: SO2<f64>, "r", 2;
    so2_interval: SO2<Interval>, "r", 2;
    r_plus_f64: RPlus<f64>, "s", 1;
    r_plus_interval: RPlus<Interval>, "s", 1;
    scaled_so2_f64: ScaledSO2<f64>, "rs", 2;
    scaled_so2_interval: ScaledSO2<Interval>, "rs", 2;
    r1_f64: Rn<f64, 1>, "x", 1;
    r1_interval: Rn<Interval, 1>, "x", 1;
    r3_f64: Rn<f64, 3>, "xxx", 3;
    r3_interval: Rn<Interval, 3>, "xxx", 3;
    se2_f64: SE2<f64>, "rxx", 2;
    se2_interval: SE2<Interval>, "rxx", 2;
    se22_f64: SE22<f64>, "rxxxx", 2;
    se22_interval: SE22<Interval>, "rxxxx", 2;
    sim2_f64: Sim2<f64>, "rsxx", 2;
    sim2_interval: Sim2<Interval>, "rsxx", 2;
    tfg_lever2_f64: TfgLever2<f64>, "rxxxx", 2;
    tfg_lever2_interval: TfgLever2<Interval>, "rxxxx", 2;
    tfg_scale_lever2_f64: TfgScaleLever2<f64>, "rsxxxx", 2;
    tfg_scale_lever2_interval: TfgScaleLever2<Interval>, "rsxxxx", 2;
}
