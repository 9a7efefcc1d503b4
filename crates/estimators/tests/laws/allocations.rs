//! Steps in steady state allocate nothing.

use estimators::{
    Estimator, Gain, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, SpatialBox, SpatialIncrement,
    SpatialMeasurement, SpatialStrips, StripsOptions,
};
use lie_groups::{LieGroup, SO3};
use nalgebra::Vector3;
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
    let ys: Vec<_> = (0..3100)
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
    // The first program that calls for more than 16 digits allocates, once for all; here that comes after some 600 steps.
    for _ in 0..2000 {
        advance();
    }
    assert_quiet("strips", advance);
}

/// The same in space, two antennas and a vertical.
#[test]
fn steps_of_the_spatial_strips_allocate_nothing() {
    let ball = |radius: f64| [Interval::new(-radius, radius).unwrap(); 3];
    let options = StripsOptions { memory: 20, support_life: 20, bucket: 5, ..StripsOptions::pose() };
    let prior = SpatialBox::new(SO3::identity(), ball(0.2), &[ball(2.0)]);
    let mut filter = SpatialStrips::new(&prior, options).unwrap();
    let (turn, shift, gravity) = ([0.01, 0.02, 0.05], [0.3, 0.0, 0.0], [0.0, 0.0, -9.81]);
    let step = SpatialIncrement::odometry(turn, shift.map(Interval::point), ball(1e-3), ball(5e-3));
    let (mut attitude, mut position) = (SO3::<f64>::identity(), Vector3::zeros());
    let mut wave = (0..).map(|k| 0.08 * f64::from(k).sin());
    let mut advance = || {
        let mut noise = || Vector3::from_fn(|_, _| wave.next().unwrap());
        let [first, second] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|arm| {
            let place = position + attitude.act(&Vector3::from(arm)) + noise();
            SpatialMeasurement::vector(place.into(), ball(0.1)).with_arm(arm)
        });
        let seen = attitude.inverse().act(&Vector3::from(gravity)) + noise();
        let down = SpatialMeasurement::direction(gravity.map(Interval::point), seen.into(), ball(0.1));
        filter.update(&[first, second, down]).unwrap();
        filter.predict(&step).unwrap();
        position += attitude.act(&Vector3::from(shift));
        attitude = attitude.compose(&SO3::exp(&Vector3::from(turn)));
    };
    let mut window = || allocation_counter::measure(|| (0..40).for_each(|_| advance())).count_total;
    let counts: Vec<u64> = (0..7).map(|_| window()).collect();
    assert_eq!(counts[5..], [0, 0], "{counts:?}");
}
