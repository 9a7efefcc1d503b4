//! Steps in steady state allocate nothing.

use estimators::Estimator;
use estimators::kalman::wheels::{TfgIekf, TwoFrameError, WheelError, WheelState, WheelStep, Wheels};
use estimators::kalman::{Ekf, Flat, Gaussian, Kf, SigmaPoints, Track, Ukf};
use lie_groups::SE2;
use nalgebra::{Matrix2, Matrix3, Matrix4, Vector2, Vector3, Vector4, Vector6};

use crate::models::{LeftPlane, Planar, covariance, linear, tracking};
use crate::support::Random;

fn assert_quiet(name: &str, mut step: impl FnMut()) {
    step();
    let counted = allocation_counter::measure(|| (0..100).for_each(|_| step()));
    assert_eq!(counted.count_total, 0, "{name}: {counted:?}");
}

#[test]
fn a_step_allocates_nothing() {
    let mut random = Random::new(1);
    let model = linear(&mut random);
    let start = Gaussian::new(Vector3::zeros(), &Matrix3::identity()).unwrap();
    let q = covariance(&random.matrix());
    let mut kf = Kf::new(model, start, &q, &q).unwrap();
    assert_quiet("kf", || kf.step(&Vector3::zeros(), &[0.1, 0.2]).unwrap());

    let start = Gaussian::new(Vector4::new(50.0, 40.0, 9.0, 12.0), &Matrix4::identity()).unwrap();
    let (q, r) = (Matrix4::identity() * 0.01, Matrix2::identity());
    let mut ekf: Ekf<_, Flat, 4, 2, 4, 2> = Ekf::new(tracking(), start, &q, &r).unwrap();
    assert_quiet("ekf", || {
        ekf.set_belief(start);
        ekf.step(&[], &[64.0, 0.67]).unwrap();
    });
    for points in [SigmaPoints::Symmetric, SigmaPoints::Scaled { alpha: 0.5, beta: 2.0, kappa: 0.0 }] {
        let mut ukf: Ukf<_, Flat, 4, 2, 4, 2> =
            Ukf::new(tracking(), start, &q, &r).unwrap().with_points(points).unwrap();
        assert_quiet("ukf", || {
            ukf.set_belief(start);
            ukf.step(&[], &[64.0, 0.67]).unwrap();
        });
    }
    let start = Gaussian::<LeftPlane, 3>::new(SE2::from_pose(0.0, 0.0, 0.0), &Matrix3::identity()).unwrap();
    let mut ukf: Ukf<_, LeftPlane, 3, 2, 3, 2> =
        Ukf::new(Planar, start, &(Matrix3::identity() * 0.01), &r).unwrap().with_reset(true);
    assert_quiet("ukf on SE(2)", || ukf.step(&Vector3::new(0.1, 0.1, 0.0), &[0.1, 0.2]).unwrap());

    let guess = WheelState::new(0.0, 1.0, Vector2::zeros(), Vector2::zeros());
    let start = TwoFrameError::belief(guess, &Vector6::repeat(0.5)).unwrap();
    let mut tfg = TfgIekf::new(Wheels, start, &(Matrix3::identity() * 1e-4), &r).unwrap().with_reset(true);
    let mut track = Track::with_capacity(101);
    assert_quiet("tfg-iekf, remembered", || {
        tfg.predict_into(&WheelStep::new(0.1, Vector2::new(0.1, 0.0)), &mut track).unwrap();
        tfg.update(&[0.1, 0.2]).unwrap();
    });
}
