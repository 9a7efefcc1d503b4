//! Steps in steady state allocate nothing.

use estimators::{Estimator, Gain, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions};
use scalars::Interval;
use setrep::Reduction;

use crate::support::{Truth, increment, vehicle_inzsmf, vehicle_zsmf};

fn assert_quiet(name: &str, mut step: impl FnMut()) {
    for _ in 0..100 {
        step();
    }
    let counted = allocation_counter::measure(|| {
        for _ in 0..1000 {
            step();
        }
    });
    assert_eq!(counted.count_total, 0, "{name}: {counted:?}");
}

#[test]
fn a_step_allocates_nothing() {
    let mut truth = Truth::new(11);
    let y = truth.measure();
    for method in [Reduction::Combastel, Reduction::Girard] {
        let mut invariant = vehicle_inzsmf([0.0; 3], [1.0; 3]).with_reduction(method, 30).unwrap();
        assert_quiet("inzsmf", || invariant.step(&increment(), y.as_slice()).unwrap());
        let mut euclidean = vehicle_zsmf([0.0; 3], [1.0; 3]).with_reduction(method, 30).unwrap();
        assert_quiet("zsmf", || euclidean.step(&(), y.as_slice()).unwrap());
    }
}

#[test]
fn predictions_and_updates_allocate_nothing() {
    let mut filter = vehicle_inzsmf([0.0; 3], [1.0; 3]).with_transport(true);
    assert_quiet("inzsmf", || {
        filter.update(&[0.1, -0.1]).unwrap();
        filter.predict(&increment()).unwrap();
        filter.predict(&-increment()).unwrap();
    });
}

/// A placed gain is computed once for a constant pair.
#[test]
fn placed_poles_are_kept() {
    let mut filter = vehicle_inzsmf([0.0; 3], [1.0; 3]).with_gain(Gain::real_poles([0.95, 0.98, 0.98]));
    assert_quiet("inzsmf", || filter.step(&increment(), &[0.1, -0.1]).unwrap());
}

/// A vehicle on a circle, measured with noise: rows come, go and carry bounds. A long warm-up lets the memory fill.
#[test]
fn steps_of_the_strips_allocate_nothing() {
    let symmetric = |radius: f64| Interval::new(-radius, radius).unwrap();
    let prior = PlanarBox::se2(Interval::ENTIRE, [symmetric(5.0); 2]);
    let mut filter = InvariantStrips::new(&prior, StripsOptions { spans: 5, ..StripsOptions::pose() }).unwrap();
    let step = PlanarIncrement::exponential([0.004, 0.08, 0.0].map(Interval::point), [symmetric(1e-3); 3]);
    // Looser than five steps are.
    let five = [0.02, 0.4, 0.0].map(Interval::point);
    let five = PlanarIncrement::exponential(five, [symmetric(6e-3); 3]);
    let mut truth = Truth::new(3);
    let ys: Vec<_> = (0..1600)
        .map(|_| {
            truth.advance();
            truth.measure()
        })
        .collect();
    let mut next = ys.iter();
    let mut advance = || {
        let y = next.next().unwrap();
        filter.predict(&step).unwrap();
        filter.bound_span(5, &five).unwrap();
        filter.update(&[PlanarMeasurement::position([y[0], y[1]], [symmetric(1.0); 2])]).unwrap();
    };
    for _ in 0..500 {
        advance();
    }
    assert_quiet("strips", advance);
}
