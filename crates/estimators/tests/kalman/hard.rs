//! Where Kalman filters are degenerate: no noise, no outputs, numbers of any size, angles at the wrap, functions that give no numbers.

use std::f64::consts::PI;

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian, Kf, LinearModel, Motion, Sensor, SigmaPoints, Ukf};
use estimators::{Estimator, EstimatorError};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix1, Matrix2, Matrix3, SMatrix, SVector, Vector1, Vector2, Vector3};
use nonlin_bounds::function;

use crate::models::{LeftPlane, Planar};

/// Without noises the belief narrows to a line, then to a point; a further output has nothing left to weigh.
#[test]
fn noises_may_be_zero_until_nothing_is_left() {
    let model = LinearModel::new(
        Matrix2::new(1.0, 0.5, 0.0, 1.0),
        Matrix2::identity(),
        Matrix2::identity().fixed_rows::<1>(0).into_owned(),
    )
    .unwrap();
    let start = Gaussian::new(Vector2::zeros(), &Matrix2::identity()).unwrap();
    let (q, r) = (Matrix2::zeros(), Matrix1::zeros());
    let mut kf = Kf::new(model, start, &q, &r).unwrap();
    let mut ukf: Ukf<_, Flat, 2, 1, 2, 1> = Ukf::new(model, start, &q, &r).unwrap();
    for (k, y) in [1.0, 1.5].into_iter().enumerate() {
        kf.step(&Vector2::zeros(), &[y]).unwrap();
        ukf.step(&Vector2::zeros(), &[y]).unwrap();
        assert!((kf.belief().mean() - ukf.belief().mean()).norm() < 1e-12, "{k}");
    }
    // x(0) = (1, 1) is known exactly.
    assert!((kf.belief().mean() - Vector2::new(2.0, 1.0)).norm() < 1e-12);
    assert!(kf.belief().covariance().norm() < 1e-12);
    let known = Gaussian::new(Vector2::new(2.0, 1.0), &Matrix2::zeros()).unwrap();
    kf.set_belief(known);
    let wrong = kf.update(&[2.0]).unwrap_err();
    assert!(matches!(wrong, EstimatorError::SingularInnovation { outputs: 1, .. }), "{wrong}");
    assert_eq!((kf.belief(), kf.innovation()), (&known, None));
}

#[test]
fn a_filter_may_have_no_outputs() {
    let model = LinearModel::<1, 0, 1>::new(Matrix1::identity(), Matrix1::identity(), SMatrix::zeros()).unwrap();
    let start = Gaussian::new(Vector1::new(3.0), &Matrix1::identity()).unwrap();
    let (q, r) = (Matrix1::identity(), SMatrix::<f64, 0, 0>::zeros());
    let mut kf = Kf::new(model, start, &q, &r).unwrap();
    let mut ukf: Ukf<_, Flat, 1, 0, 1, 0> = Ukf::new(model, start, &q, &r).unwrap();
    for _ in 0..3 {
        kf.step(&Vector1::zeros(), &[]).unwrap();
        ukf.step(&Vector1::zeros(), &[]).unwrap();
    }
    for belief in [kf.belief(), ukf.belief()] {
        assert!((belief.mean()[0] - 3.0).abs() < 1e-13 && (belief.covariance()[0] - 4.0).abs() < 1e-13);
    }
    assert!(kf.innovation().unwrap().nis() == 0.0);
}

/// Another unit changes numbers, not the filter: from 1e-150 to 1e150, covariances from 1e-300 to 1e300.
#[test]
fn units_do_not_matter() {
    let run = |unit: f64, points: Option<SigmaPoints>| -> (Vector2<f64>, Vector2<f64>) {
        let c = Matrix2::identity().fixed_rows::<1>(0).into_owned();
        let model = LinearModel::new(Matrix2::new(1.0, 0.5, 0.0, 0.9), Matrix2::identity(), c).unwrap();
        let squared = unit * unit;
        let start =
            Gaussian::new(Vector2::new(1.0, 2.0) * unit, &(Matrix2::new(4.0, 1.0, 1.0, 2.0) * squared)).unwrap();
        let (q, r) = (Matrix2::identity() * (0.5 * squared), Matrix1::new(0.25 * squared));
        let outputs = [1.5, 2.0, 3.5, 3.0].map(|y| [y * unit]);
        let belief = if let Some(points) = points {
            let mut ukf: Ukf<_, Flat, 2, 1, 2, 1> =
                Ukf::new(model, start, &q, &r).unwrap().with_points(points).unwrap();
            outputs.iter().for_each(|y| ukf.step(&Vector2::zeros(), y).unwrap());
            *ukf.belief()
        } else {
            let mut kf = Kf::new(model, start, &q, &r).unwrap();
            outputs.iter().for_each(|y| kf.step(&Vector2::zeros(), y).unwrap());
            *kf.belief()
        };
        (belief.mean() / unit, belief.standard_deviations() / unit)
    };
    let sets = [SigmaPoints::Symmetric, SigmaPoints::Central { weight: -0.5 }];
    for points in [None].into_iter().chain(sets.map(Some)) {
        let (mean, deviations) = run(1.0, points);
        for unit in [1e-150, 1e-100, 1e100, 1e150] {
            let scaled = run(unit, points);
            let gap = (scaled.0 - mean).norm() + (scaled.1 - deviations).norm();
            assert!(gap < 1e-12, "{unit:e} {points:?}: {gap:e}");
        }
    }
}

/// What is no number is refused and changes nothing, wherever it comes from.
#[test]
fn what_is_no_number_is_refused() {
    let root = function!(|[x, w]: 2| -> 1 { [x.sqrt() + w] });
    let seen = function!(|[x, v]: 2| -> 1 { [x.ln() + v] });
    let start = Gaussian::<Flat, 1>::new(Vector1::new(0.5), &Matrix1::identity()).unwrap();
    let one = Matrix1::identity();
    let mut ukf: Ukf<_, Flat, 1, 1, 1, 1> =
        Ukf::new((ByFunction::new(root), ByFunction::new(seen)), start, &one, &one).unwrap();
    for y in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(ukf.update(&[y]), Err(EstimatorError::NotFinite { what: "output", index: 0, .. })));
        assert!(ukf.step(&[], &[y]).is_err());
        assert!(ukf.update_by(&ByFunction::new(seen), &one, &Vector1::new(y)).is_err());
    }
    // Sigma points below 0: root and logarithm of what is negative.
    assert!(matches!(ukf.predict(&[]), Err(EstimatorError::NotFinite { .. })));
    assert!(matches!(ukf.update(&[1.0]), Err(EstimatorError::NotFinite { .. })));
    assert_eq!((ukf.belief(), ukf.innovation()), (&start, None));
    let mut ekf: Ekf<_, Flat, 1, 1, 1, 1> =
        Ekf::new((ByFunction::new(root), ByFunction::new(seen)), start, &one, &one).unwrap();
    ekf.set_belief(Gaussian::new(Vector1::new(0.0), &one).unwrap());
    // Infinite derivatives.
    assert!(ekf.predict(&[]).is_err() && ekf.update(&[1.0]).is_err());
}

/// A compass on the plane: the heading itself is measured, as an angle in `(-pi, pi]`.
#[derive(Debug, Clone, Copy)]
struct Compass;

impl Motion<LeftPlane, 3, 3> for Compass {
    type Input = Vector3<f64>;
    fn transition(&self, x: &SE2<f64>, u: &Vector3<f64>, w: &Vector3<f64>) -> SE2<f64> {
        Motion::<LeftPlane, 3, 3>::transition(&Planar, x, u, w)
    }
}

impl Sensor<LeftPlane, 3, 1, 1> for Compass {
    fn output(&self, x: &SE2<f64>, v: &SVector<f64, 1>) -> SVector<f64, 1> {
        let unit = x.rotation().unit();
        Vector1::new(unit.im.atan2(unit.re) + v[0])
    }
    fn residual(&self, y: &SVector<f64, 1>, predicted: &SVector<f64, 1>) -> SVector<f64, 1> {
        let difference = y - predicted;
        difference.map(|angle| angle - 2.0 * PI * (angle / (2.0 * PI)).round())
    }
}

/// Headings on both sides of a half turn, in the belief and in the output: the filter goes on as it does elsewhere.
#[test]
fn angles_wrap() {
    let run = |heading: f64| -> (SE2<f64>, Matrix3<f64>) {
        let start =
            Gaussian::<LeftPlane, 3>::new(SE2::from_pose(heading, 0.0, 0.0), &(Matrix3::identity() * 0.09)).unwrap();
        let mut ukf: Ukf<_, LeftPlane, 3, 1, 3, 1> =
            Ukf::new(Compass, start, &(Matrix3::identity() * 1e-4), &Matrix1::new(0.01)).unwrap();
        for k in 1..=40 {
            let truth = heading + 0.2 + 0.01 * f64::from(k - 1);
            ukf.update(&[truth.sin().atan2(truth.cos())]).unwrap();
            ukf.predict(&Vector3::new(0.01, 0.0, 0.0)).unwrap();
        }
        (*ukf.belief().mean(), ukf.belief().covariance())
    };
    let (home, expected) = run(0.0);
    let (there, found) = run(PI - 0.3);
    let turned = SE2::from_pose(PI - 0.3, 0.0, 0.0).compose(&home);
    assert!(turned.inverse().compose(&there).log().unwrap().norm() < 1e-9);
    assert!((expected - found).norm() < 1e-9);
    // The heading is 0.2 rad off at first.
    assert!((home.rotation().unit().im.asin() - 0.6).abs() < 0.02);
}
