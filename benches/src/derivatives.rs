//! Value, Jacobian and Hessians over intervals against the same generic code over `f64`, for the models of paper 003.

use std::hint::black_box;

use nonlin_bounds::{DynFunction, Function, Jet, Order, Second};
use scalars::Interval;

use crate::functions::{Attitude, AttitudeOutput, PlanarMap};
use crate::timing::Bench;

/// One row: ours is the enclosure with all checks, the peer a single pass over `f64` of exactly as many variables.
fn row<const N: usize, const H: usize>(
    name: &'static str,
    function: impl Function + Copy + 'static,
    center: [f64; N],
    radius: f64,
    p: &[f64],
) -> Bench {
    let x = center.map(|c| Interval::point(c).inflate(radius));
    let parameters: Vec<Interval> = p.iter().map(|&p| Interval::point(p)).collect();
    let mut jet = Jet::new();
    let ours = move || {
        // An error would show as an absurd time: nothing was computed.
        let _ = black_box(function.enclose(Order::Hessian, black_box(&x), &parameters, &mut jet));
        black_box(&jet);
    };
    let p: Vec<Second<f64, N, H>> = p.iter().map(|&p| Second::constant(p)).collect();
    let mut y = vec![Second::constant(0.0); Function::outputs(&function)];
    let theirs = move || {
        let center = black_box(&center);
        let x: [Second<f64, N, H>; N] = std::array::from_fn(|i| Second::variable(center[i], i));
        function.eval(&x, &p, &mut y);
        black_box(&y);
    };
    Bench::new(name, "f64", ours, theirs)
}

/// The rows `hessian/*`.
pub fn benches() -> Vec<Bench> {
    let state = [0.1, 0.9, -0.2, 0.3, 0.001, -0.002, 0.0];
    vec![
        row::<2, 3>("hessian/planar-map", PlanarMap, [5.0, 0.5], 0.1, &[]),
        row::<7, 28>("hessian/attitude", Attitude, state, 3e-3, &[0.3, -0.1, 0.05]),
        row::<4, 10>("hessian/attitude-output", AttitudeOutput, [0.1, 0.9, -0.2, 0.3], 0.05, &[]),
    ]
}
