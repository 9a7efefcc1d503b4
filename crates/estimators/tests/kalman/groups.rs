//! Filters on SE(2).

use estimators::kalman::{Ekf, Gaussian, OnGroup, SigmaPoints, Ukf};
use estimators::{ErrorSide, Estimator, Left, Right};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use crate::models::{LeftPlane, Planar};
use crate::support::Random;

const TURN: Vector3<f64> = Vector3::new(0.3, 1.0, 0.1);

fn spread(size: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(0.3, 0.5, 0.5)) * (size * size)
}

fn ukf<Side: ErrorSide + PartialEq>(
    pose: SE2<f64>,
    p: &Matrix3<f64>,
) -> Ukf<Planar, OnGroup<SE2<f64>, Side, 2>, 3, 2, 3, 2> {
    let start = Gaussian::new(pose, p).unwrap();
    Ukf::new(Planar, start, &(Matrix3::identity() * 1e-3), &(Matrix2::identity() * 0.01)).unwrap()
}

/// Moving the world moves the estimates and changes nothing else: with the left-invariant error and isotropic noise of the position, also
/// where headings lie on both sides of a half turn and an average of angles would be 0.
#[test]
fn the_unscented_filter_does_not_see_where_the_world_is() {
    let mut random = Random::new(5);
    for points in [SigmaPoints::Symmetric, SigmaPoints::Central { weight: 0.3 }] {
        let home = SE2::from_pose(0.1, 0.0, 0.0);
        let move_by = SE2::from_pose(std::f64::consts::PI - 0.1, 30.0, -7.0);
        let p = spread(1.0);
        let mut here = ukf::<Left>(home, &p).with_points(points).unwrap();
        let mut there = ukf::<Left>(move_by.compose(&home), &p).with_points(points).unwrap();
        for _ in 0..30 {
            let y = here.belief().mean().translation() + random.matrix::<2, 1>() * 0.3;
            here.step(&TURN, y.as_slice()).unwrap();
            there.step(&TURN, move_by.act(&y).as_slice()).unwrap();
            let gap = move_by.compose(here.belief().mean()).inverse().compose(there.belief().mean()).log().unwrap();
            assert!(gap.norm() < 1e-9, "{gap}");
            assert!((here.belief().covariance() - there.belief().covariance()).norm() < 1e-9);
        }
    }
}

/// A motion without noise carries the left-invariant error linearly, whatever its size: the mean moves as a state does, with headings of
/// +-1 rad and more around it, where averaged positions would fall short by a tenth; the covariance is turned by the adjoint.
#[test]
fn the_mean_on_the_group_moves_exactly() {
    let p = Matrix3::from_diagonal(&Vector3::new(0.4_f64.powi(2), 0.01, 0.04));
    let pose = SE2::from_pose(3.0, 0.0, 0.0);
    let start = Gaussian::<LeftPlane, 3>::new(pose, &p).unwrap();
    let mut filter: Ukf<_, LeftPlane, 3, 2, 3, 2> =
        Ukf::new(Planar, start, &Matrix3::zeros(), &Matrix2::identity()).unwrap();
    filter.predict(&TURN).unwrap();
    let step = SE2::exp(&TURN);
    assert!(pose.compose(&step).inverse().compose(filter.belief().mean()).log().unwrap().norm() < 1e-12);
    let ad = step.inverse().adjoint();
    assert!((filter.belief().covariance() - ad * p * ad.transpose()).norm() < 1e-12);
}

/// With little uncertainty the unscented filter is the extended one to second order, on either side; and left and right are one filter to
/// first order, with the reset as without.
#[test]
fn with_little_uncertainty_all_filters_agree() {
    fn run<Side: ErrorSide + PartialEq>(size: f64, reset: bool) -> [SE2<f64>; 2] {
        let pose = SE2::from_pose(3.0, 2.0, -1.0);
        let ad = if Side::IS_LEFT { Matrix3::identity() } else { pose.adjoint() };
        let start =
            Gaussian::<OnGroup<SE2<f64>, Side, 2>, 3>::new(pose, &(ad * spread(size) * ad.transpose())).unwrap();
        let (q, r) = (Matrix3::identity() * (1e-3 * size * size), Matrix2::identity() * (size * size));
        let mut ekf: Ekf<_, _, 3, 2, 3, 2> = Ekf::new(Planar, start, &q, &r).unwrap().with_reset(reset);
        let mut ukf: Ukf<_, _, 3, 2, 3, 2> = Ukf::new(Planar, start, &q, &r).unwrap().with_reset(reset);
        for k in 0..5 {
            let offset = Vector2::new(1.0, -0.5) * (size * f64::from(k % 2));
            let y = ekf.belief().mean().translation() + offset;
            ekf.step(&TURN, y.as_slice()).unwrap();
            ukf.step(&TURN, y.as_slice()).unwrap();
        }
        [*ekf.belief().mean(), *ukf.belief().mean()]
    }
    let size = 1e-4;
    let all = [run::<Left>(size, false), run::<Left>(size, true), run::<Right>(size, false), run::<Right>(size, true)];
    for mean in all.iter().flatten() {
        let gap = all[0][0].inverse().compose(mean).log().unwrap().norm();
        assert!(gap < 30.0 * size * size, "{gap}");
    }
    assert_ne!(all[0][0], all[0][1]);
}
