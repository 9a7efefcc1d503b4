//! What is refused, and that a refusal changes nothing.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian, Kf, LinearModel, SigmaPoints, Ukf};
use estimators::{Estimator, EstimatorError};
use nalgebra::{Matrix1, Matrix2, Matrix4, Vector1, Vector2, Vector4};
use nonlin_bounds::function;

use crate::models::tracking;

#[test]
fn covariances_are_checked() {
    let indefinite = Matrix2::new(1.0, 0.0, 0.0, -1.0);
    let wrong = Gaussian::<Flat, 2>::new(Vector2::zeros(), &indefinite).unwrap_err();
    assert_eq!(wrong, EstimatorError::NotPositive { what: "covariance", index: 1, value: -1.0 });
    assert!(Gaussian::<Flat, 2>::new(Vector2::new(0.0, f64::NAN), &Matrix2::identity()).is_err());
    let model = LinearModel::new(Matrix2::identity(), Matrix2::identity(), Matrix2::identity()).unwrap();
    let start = Gaussian::new(Vector2::zeros(), &Matrix2::identity()).unwrap();
    let wrong = Kf::new(model, start, &indefinite, &Matrix2::identity()).unwrap_err();
    assert!(matches!(wrong, EstimatorError::NotPositive { what: "covariance of the process noise", .. }));
    let mut filter = Kf::new(model, start, &Matrix2::identity(), &Matrix2::identity()).unwrap();
    assert!(filter.set_noises(&Matrix2::identity(), &Matrix2::new(1.0, 1.0, 0.0, 1.0)).is_err());
    assert!(
        LinearModel::new(Matrix2::new(f64::INFINITY, 0.0, 0.0, 0.0), Matrix2::identity(), Matrix2::identity()).is_err()
    );
}

#[test]
fn sizes_are_checked() {
    let (motion, sensor) = tracking();
    let start = Gaussian::new(Vector4::repeat(3.0), &Matrix4::identity()).unwrap();
    let two = Matrix2::identity();
    // The functions change places.
    let wrong = Ekf::<_, Flat, 4, 2, 4, 2>::new((sensor.clone(), motion.clone()), start, &Matrix4::identity(), &two);
    assert!(matches!(
        wrong.unwrap_err(),
        EstimatorError::Size { what: "variables of the motion", expected: 6, found: 8 }
    ));
    let mut filter: Ekf<_, Flat, 4, 2, 4, 2> = Ekf::new((motion, sensor), start, &Matrix4::identity(), &two).unwrap();
    let before = filter.clone();
    assert!(matches!(
        filter.update(&[1.0]).unwrap_err(),
        EstimatorError::Size { what: "output", expected: 2, found: 1 }
    ));
    assert!(matches!(filter.predict(&[0.5]).unwrap_err(), EstimatorError::Size { what: "input", .. }));
    assert!(matches!(
        filter.update(&[1.0, f64::NAN]).unwrap_err(),
        EstimatorError::NotFinite { what: "output", index: 1, .. }
    ));
    // The update is fine, the prediction is not.
    assert!(filter.step(&[0.5], &[4.0, 0.7]).is_err());
    assert_eq!((filter.belief(), filter.innovation()), (before.belief(), None));
    let bounded = ByFunction::new(function!(|[x, _v]: 2, [_p]: 1| -> 1 { [x] }));
    assert!(
        Ekf::<_, Flat, 1, 1, 1, 1>::new(
            (bounded.clone(), bounded),
            Gaussian::new(Vector1::zeros(), &Matrix1::identity()).unwrap(),
            &Matrix1::identity(),
            &Matrix1::identity()
        )
        .is_err()
    );
}

/// A sensor without noise of an exactly known state leaves nothing to weigh; a function that is not defined at the mean gives no belief.
#[test]
fn degenerate_beliefs_are_refused() {
    let one = Matrix1::identity();
    let model = LinearModel::new(one, one, one).unwrap();
    let known = Gaussian::new(Vector1::zeros(), &Matrix1::zeros()).unwrap();
    let mut filter = Kf::new(model, known, &one, &Matrix1::zeros()).unwrap();
    let wrong = filter.update(&[0.0]).unwrap_err();
    assert!(matches!(wrong, EstimatorError::SingularInnovation { outputs: 1, pivot_ratio: 0.0, .. }), "{wrong}");
    filter.step(&Vector1::zeros(), &[0.0]).unwrap_err();
    filter.predict(&Vector1::zeros()).unwrap();
    filter.update(&[1.0]).unwrap();
    assert_eq!(filter.belief().mean()[0], 1.0);

    let (motion, sensor) = tracking();
    let standing = Gaussian::new(Vector4::zeros(), &Matrix4::identity()).unwrap();
    let mut ekf: Ekf<_, Flat, 4, 2, 4, 2> =
        Ekf::new((motion, sensor), standing, &Matrix4::identity(), &Matrix2::identity()).unwrap();
    assert!(matches!(ekf.predict(&[]).unwrap_err(), EstimatorError::NotFinite { .. }));
    assert_eq!(ekf.belief(), &standing);
}

/// A central weight that is negative can ask for a covariance that is none.
#[test]
fn a_lost_covariance_is_an_error() {
    let square = ByFunction::new(function!(|[x, _w]: 2| -> 1 { [x.sqr()] }));
    let sensor = ByFunction::new(function!(|[x, v]: 2| -> 1 { [x + v] }));
    let start = Gaussian::new(Vector1::new(0.0), &Matrix1::identity()).unwrap();
    let filter = || {
        Ukf::<_, Flat, 1, 1, 1, 1>::new(
            (square.clone(), sensor.clone()),
            start,
            &Matrix1::identity(),
            &Matrix1::identity(),
        )
    };
    // Images 0 (weight -3), +-: c^2, c^2 and 0, 0: the covariance comes out below zero.
    let mut lost = filter().unwrap().with_points(SigmaPoints::Scaled { alpha: 1.0, beta: -3.0, kappa: -1.5 }).unwrap();
    let wrong = lost.predict(&[]).unwrap_err();
    assert!(matches!(wrong, EstimatorError::NotPositive { what: "predicted covariance", .. }), "{wrong}");
    assert_eq!(lost.belief(), &start);
    assert!(filter().unwrap().with_points(SigmaPoints::Central { weight: 1.0 }).is_err());
}
