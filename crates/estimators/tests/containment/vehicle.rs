//! The vehicle of paper 000: what the first-order filters do hold, and what they do not.

use estimators::{Estimator, Guarantee};
use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;
use scalars::Interval;
use setrep::{Membership, Zonotope};

use crate::support::{Truth, increment, vehicle_inzsmf, vehicle_zsmf};

fn outside(set: &Zonotope, point: &Vector3<f64>) -> bool {
    let point: Vec<Interval> = point.iter().map(|v| Interval::point(*v)).collect();
    set.membership(&point).unwrap() == Membership::ProvenOutside
}

/// Left-invariant error of the vehicle's pose.
fn errors(truth: &Truth, estimate: &SE2<f64>) -> Vector3<f64> {
    estimate.inverse().compose(&truth.pose).log().unwrap()
}

/// Pure heading errors of 90 degrees, uniform noise: the invariant filter never loses the state.
#[test]
fn the_invariant_set_holds_pure_heading_errors() {
    for seed in 0..3 {
        let mut truth = Truth::new(seed);
        let mut filter = vehicle_inzsmf([0.0, 0.0, 0.0], [1.7, 0.05, 0.05]);
        for k in 0..200 {
            let y = truth.measure();
            filter.step(&increment(), y.as_slice()).unwrap();
            truth.advance();
            assert!(!outside(filter.tangent_set(), &errors(&truth, filter.estimate())), "seed {seed} step {k}");
        }
    }
}

/// The same case loses the state in Euclidean coordinates, a position error of 5 m loses it in invariant ones:
/// `FirstOrder` is no figure of speech.
#[test]
fn neither_filter_is_rigorous() {
    let mut lost = [0, 0];
    for seed in 0..3 {
        let mut truth = Truth::new(seed);
        let first = errors(&truth, &SE2::from_pose(0.0, 5.0, -5.0)).map(|e| 1.05 * e.abs() + 0.05);
        let mut euclidean = vehicle_zsmf([0.0, 0.0, 0.0], [1.7, 0.05, 0.05]);
        let mut invariant = vehicle_inzsmf([0.0, 5.0, -5.0], first.into());
        assert!(!outside(invariant.tangent_set(), &errors(&truth, invariant.estimate())));
        assert_eq!((euclidean.guarantee(), invariant.guarantee()), (Guarantee::FirstOrder, Guarantee::FirstOrder));
        let (mut left_euclidean, mut left_invariant) = (false, false);
        for _ in 0..60 {
            let y = truth.measure();
            euclidean.step(&(), y.as_slice()).unwrap();
            invariant.step(&increment(), y.as_slice()).unwrap();
            truth.advance();
            let position = truth.pose.translation();
            let pose = Vector3::new(truth.pose.rotation().angle().unwrap(), position[0], position[1]);
            left_euclidean |= outside(euclidean.enclosure(), &pose);
            left_invariant |= outside(invariant.tangent_set(), &errors(&truth, invariant.estimate()));
        }
        lost[0] += usize::from(left_euclidean);
        lost[1] += usize::from(left_invariant);
    }
    println!("lost in {lost:?} of 3 runs (ZSMF, InZSMF)");
    assert!(lost.iter().all(|l| *l > 0), "{lost:?}");
}
