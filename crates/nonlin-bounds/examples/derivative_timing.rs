//! Nanoseconds of value, Jacobian and Hessians over a box, beside one pass of the same code over `f64`.

use std::hint::black_box;
use std::time::Instant;

use nonlin_bounds::{DynFunction, Function, Jet, Order, Second};
use scalars::Interval;

#[path = "../tests/common/functions.rs"]
#[allow(dead_code, reason = "the example uses some of them")]
mod functions;

/// Least mean time of a call over many short windows.
fn nanoseconds(mut work: impl FnMut()) -> f64 {
    let window = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        for _ in 0..200 {
            work();
        }
        start.elapsed().as_nanos() as f64 / 200.0
    };
    (0..300).map(|_| window(&mut work)).fold(f64::INFINITY, f64::min)
}

fn row<const N: usize, const H: usize>(name: &str, f: impl Function, center: [f64; N], radius: f64, p: &[f64]) {
    let x = center.map(|c| Interval::point(c).inflate(radius));
    let parameters: Vec<Interval> = p.iter().map(|&p| Interval::point(p)).collect();
    let mut jet = Jet::new();
    let mut enclose = |order| {
        nanoseconds(|| {
            // Inputs are valid: nothing to report.
            let _ = f.enclose(order, black_box(&x), &parameters, &mut jet);
            black_box(&jet);
        })
    };
    let times = [Order::Value, Order::Jacobian, Order::Hessian].map(&mut enclose);
    let p: Vec<Second<f64, N, H>> = p.iter().map(|&p| Second::constant(p)).collect();
    let mut y = vec![Second::constant(0.0); Function::outputs(&f)];
    let plain = nanoseconds(|| {
        let center = black_box(&center);
        let x: [Second<f64, N, H>; N] = std::array::from_fn(|i| Second::variable(center[i], i));
        f.eval(&x, &p, &mut y);
        black_box(&y);
    });
    println!("{name:<18}{:>9.0}{:>10.0}{:>10.0}{plain:>10.0}{:>8.1}", times[0], times[1], times[2], times[2] / plain);
}

fn main() {
    println!("{:<18}{:>9}{:>10}{:>10}{:>10}{:>8}", "ns", "value", "Jacobian", "Hessian", "f64", "ratio");
    row::<2, 3>("planar map", functions::PlanarMap, [5.0, 0.5], 0.1, &[]);
    let state = [0.1, 0.9, -0.2, 0.3, 0.001, -0.002, 0.0];
    row::<7, 28>("attitude", functions::Attitude, state, 3e-3, &[0.3, -0.1, 0.05]);
    row::<4, 10>("attitude output", functions::AttitudeOutput, [0.1, 0.9, -0.2, 0.3], 0.05, &[]);
}
