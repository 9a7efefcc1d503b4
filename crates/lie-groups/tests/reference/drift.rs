//! Long products stay on the unit circle, over `f64`.

use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;
use scalars::Interval;

use crate::support::random::{Random, SEED};

fn deviation(pose: &SE2<f64>) -> f64 {
    let unit = pose.rotation().unit();
    // re^2 + im^2 - 1 without rounding of the squares.
    let (re2, im2) = (unit.re * unit.re, unit.im * unit.im);
    let rest = unit.re.mul_add(unit.re, -re2) + unit.im.mul_add(unit.im, -im2);
    0.5 * ((re2 - 1.0) + im2 + rest).abs()
}

#[test]
fn a_million_products_stay_on_the_circle() {
    let mut random = Random::new("drift");
    let steps: Vec<SE2<f64>> = (0..1000)
        .map(|_| {
            SE2::exp(&Vector3::new(random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)))
        })
        .collect();
    let mut pose = SE2::identity();
    let mut worst = 0.0_f64;
    for k in 0..1_000_000 {
        pose = pose.compose(&steps[k % steps.len()]);
        worst = worst.max(deviation(&pose));
    }
    println!("seed {SEED:#x}: worst | |z| - 1 | over 10^6 products {worst:.1e}");
    assert!(worst < 4e-16, "{worst:e}");
}

/// The same step a million times: the angle is `10^6` times the step's, up to the rounding of each product.
#[test]
fn a_million_equal_steps_add_up() {
    let step_angle = 2.0_f64.powi(-10);
    let step = SE2::exp(&Vector3::new(step_angle, 1.0, 0.0));
    let mut pose = SE2::identity();
    for _ in 0..1_000_000 {
        pose = pose.compose(&step);
    }
    let total = Interval::point(1e6 * step_angle);
    let (sin, cos) = total.sin_cos();
    let unit = pose.rotation().unit();
    let error = (unit.re - cos.mid()).abs().max((unit.im - sin.mid()).abs());
    println!("angle error after 10^6 equal steps {error:.1e}");
    assert!(error < 1e-10, "{error:e}");
}

/// An element built from any direction is on the circle at once.
#[test]
fn directions_are_scaled() {
    for (cos, sin) in [(3.0, 4.0), (1e-320, -1e-320), (1e308, 1e308), (-0.0, 2.0)] {
        let rotation = lie_groups::SO2::from_cos_sin(cos, sin).unwrap();
        assert!(deviation(&SE2::new(rotation, &nalgebra::Vector2::zeros())) < 3e-16, "{cos} {sin}");
        assert!((rotation.angle().unwrap() - f64::atan2(sin, cos)).abs() < 4e-16);
    }
}
