//! The laws of a Lie group, run on every group over every scalar by one line each.
//!
//! Over `f64` both sides of a law must agree to a relative 1e-13 (of the largest product in them); over intervals they enclose the same exact number, so they must meet,
//! and the hull of both must be as narrow.

#![allow(clippy::unwrap_used)]

#[path = "../support/mod.rs"]
mod support;

mod battery;
mod models;
mod probe;

use lie_groups::{
    ImperfectSE2, RPlus, Rn, SE2, SE3, SE22, SE23, SO2, SO3, ScaledSO2, ScaledSO3, Sim2, Sim3, TfgLever2, TfgLever3,
    TfgScaleLever2, TfgScaleLever3,
};
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
    so3_f64: SO3<f64>, "www", 3;
    so3_interval: SO3<Interval>, "www", 3;
    scaled_so3_f64: ScaledSO3<f64>, "wwws", 3;
    scaled_so3_interval: ScaledSO3<Interval>, "wwws", 3;
    se3_f64: SE3<f64>, "wwwxxx", 3;
    se3_interval: SE3<Interval>, "wwwxxx", 3;
    se23_f64: SE23<f64>, "wwwxxxxxx", 3;
    se23_interval: SE23<Interval>, "wwwxxxxxx", 3;
    sim3_f64: Sim3<f64>, "wwwsxxx", 3;
    sim3_interval: Sim3<Interval>, "wwwsxxx", 3;
    tfg_lever3_f64: TfgLever3<f64>, "wwwxxxxxx", 3;
    tfg_lever3_interval: TfgLever3<Interval>, "wwwxxxxxx", 3;
    tfg_scale_lever3_f64: TfgScaleLever3<f64>, "wwwsxxxxxx", 3;
    tfg_scale_lever3_interval: TfgScaleLever3<Interval>, "wwwsxxxxxx", 3;
    imperfect_f64: ImperfectSE2<f64, 3, 6>, "rxxxxx", 2;
    imperfect_interval: ImperfectSE2<Interval, 3, 6>, "rxxxxx", 2;
}
