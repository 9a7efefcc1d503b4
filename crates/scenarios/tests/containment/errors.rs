//! Errors of a pose in the coordinates of the filters.

use std::f64::consts::TAU;

use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;
use scalars::Interval;
use scenarios::inzsmf::errors::{euclidean_errors, invariant_errors};
use scenarios::vehicle::{Pose, TruePose};

fn pose(heading_rad: f64, x1: f64, x2: f64) -> Pose {
    Pose { heading_rad, position: [x1, x2] }
}

/// Every branch maps back to the truth: `Xhat exp(eps)` contains it.
#[test]
fn every_branch_of_the_logarithm_is_an_error_of_the_same_pose() {
    let truth = TruePose::new(pose(2.5, -3.0, 7.0));
    let center = TruePose::new(pose(0.4, 1.0, -2.0)).enclosure();
    for (reach, branches) in [(0.0, 1), (2.0, 1), (5.0, 2), (8.5, 3), (15.0, 5)] {
        let errors = invariant_errors(&truth, &center, reach).unwrap();
        assert_eq!(errors.len(), branches, "reach {reach}");
        for error in errors {
            let back = center.compose(&SE2::exp(&Vector3::from(error)));
            let translation = back.translation();
            assert!(translation[0].contains(-3.0) && translation[1].contains(7.0), "{error:?}");
            assert!(translation[0].width() < 1e-10 && error.iter().all(|e| e.width() < 1e-10));
            assert!(back.rotation().unit().re.contains(2.5_f64.cos()));
        }
    }
}

/// The first error is the smallest; the others are full turns away.
#[test]
fn headings_are_known_modulo_full_turns() {
    let truth = TruePose::new(pose(1.0 + 3.0 * TAU, 1.0, 2.0));
    let errors = euclidean_errors(&truth, &pose(0.75, 0.0, 0.0), 7.0);
    assert_eq!(errors.len(), 3);
    for (error, turns) in errors.iter().zip([0.0, 1.0, -1.0]) {
        assert!((error[0].mid() - 0.25 - turns * TAU).abs() < 1e-14);
        assert_eq!((error[1].mid(), error[2].mid()), (1.0, 2.0));
    }
    assert_eq!(euclidean_errors(&truth, &pose(0.75, 0.0, 0.0), 1.0).len(), 1);
}

/// Half a turn has no principal logarithm: an error, not a guess.
#[test]
fn half_a_turn_is_refused() {
    let truth = TruePose::new(pose(std::f64::consts::PI, 0.0, 0.0));
    assert!(invariant_errors(&truth, &SE2::<Interval>::identity(), 0.0).is_err());
}
