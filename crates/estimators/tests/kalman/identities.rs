//! Equalities that hold to rounding.

use estimators::Estimator;
use estimators::kalman::{Ekf, Flat, Gaussian, Kf, SigmaPoints, SmoothMotion, SmoothSensor, Ukf};
use nalgebra::{Matrix2, Matrix4, SMatrix, SVector, Vector2, Vector3, Vector4};

use crate::models::{covariance, linear, tracking};
use crate::support::{Random, cases};

const SETS: [SigmaPoints; 4] = [
    SigmaPoints::Symmetric,
    SigmaPoints::Central { weight: 1.0 / 3.0 },
    SigmaPoints::Central { weight: -0.5 },
    SigmaPoints::Scaled { alpha: 0.1, beta: 2.0, kappa: 0.0 },
];

/// Distance relative to the size of the second.
fn apart<const R: usize, const C: usize>(a: &SMatrix<f64, R, C>, b: &SMatrix<f64, R, C>) -> f64 {
    (a - b).norm() / b.norm().max(1e-3)
}

/// The Kalman filter is the dense recursion of the textbook with Joseph's form, and every unscented filter is the Kalman filter.
#[test]
fn on_linear_models_all_filters_are_one() {
    let mut random = Random::new(7);
    for _ in 0..cases(50) {
        let model = linear(&mut random);
        let (a, b) = SmoothMotion::<Flat, 3, 2>::motion_jacobians(&model, &Vector3::zeros(), &Vector3::zeros());
        let (c, _) = SmoothSensor::<Flat, 3, 2, 2>::output_jacobians(&model, &Vector3::zeros());
        let (q, r) = (covariance(&random.matrix()), covariance(&random.matrix()));
        let (mut x, mut p): (Vector3<f64>, SMatrix<f64, 3, 3>) = (random.matrix(), covariance(&random.matrix()));
        let start = Gaussian::new(x, &p).unwrap();
        let mut kf = Kf::new(model, start, &q, &r).unwrap();
        let mut ukfs: Vec<Ukf<_, Flat, 3, 2, 2, 2>> =
            SETS.map(|set| Ukf::new(model, start, &q, &r).unwrap().with_points(set).unwrap()).into();
        for _ in 0..20 {
            let (u, y): (Vector3<f64>, Vector2<f64>) = (random.matrix(), random.matrix());
            let s = c * p * c.transpose() + r;
            let gain = p * c.transpose() * s.try_inverse().unwrap();
            let z = y - c * x;
            let closed = SMatrix::<f64, 3, 3>::identity() - gain * c;
            (x, p) = (x + gain * z, closed * p * closed.transpose() + gain * r * gain.transpose());
            kf.update(y.as_slice()).unwrap();
            let nis = z.dot(&(s.try_inverse().unwrap() * z));
            assert!((kf.innovation().unwrap().nis() - nis).abs() < 1e-11 * (1.0 + nis));
            (x, p) = (a * x + u, a * p * a.transpose() + b * q * b.transpose());
            kf.predict(&u).unwrap();
            assert!(apart(kf.belief().mean(), &x) < 1e-12 && apart(&kf.belief().covariance(), &p) < 1e-12);
            for ukf in &mut ukfs {
                ukf.step(&u, y.as_slice()).unwrap();
                // Scaled sets cancel: a small alpha has weights of 1 / alpha^2 and both signs.
                let set = ukf.points();
                assert!(apart(ukf.belief().mean(), &x) < 1e-10, "{set:?}");
                assert!(apart(&ukf.belief().covariance(), &p) < 1e-10, "{set:?}");
            }
        }
    }
}

/// A long run ends at the fixed point of the Riccati equation.
#[test]
fn the_covariance_converges_to_the_riccati_fixed_point() {
    // Scalar random walk: P = P R / (P + R) + Q, so P = (Q + sqrt(Q^2 + 4 Q R)) / 2 before the update.
    let one = SMatrix::<f64, 1, 1>::identity();
    let model = estimators::kalman::LinearModel::new(one, one, one).unwrap();
    let (q, r) = (0.3, 2.0);
    let start = Gaussian::new(SVector::zeros(), &(one * 100.0)).unwrap();
    let mut filter = Kf::new(model, start, &(one * q), &(one * r)).unwrap();
    for _ in 0..200 {
        filter.step(&SVector::zeros(), &[0.0]).unwrap();
    }
    let expected = 0.5 * (q + (q * q + 4.0 * q * r).sqrt());
    assert!((filter.belief().covariance()[0] - expected).abs() < 1e-14);
}

/// Dual numbers against central differences, over more variables than one pass takes.
#[test]
fn jacobians_of_functions_are_right() {
    let (motion, _) = tracking();
    let wide = estimators::kalman::ByFunction::new(nonlin_bounds::function!(|x: 11| -> 2 {
        let sum = x.iter().fold(S::zero(), |sum, &x| sum * x.sin() + x);
        [sum.sqr(), x[10] * x[0]]
    }));
    let x = Vector4::new(4.0, -3.0, 2.0, 1.5);
    let (a, b) = SmoothMotion::<Flat, 4, 4>::motion_jacobians(&motion, &x, &[]);
    assert_eq!(b, Matrix4::identity());
    let at =
        |x: &Vector4<f64>| estimators::kalman::Motion::<Flat, 4, 4>::transition(&motion, x, &[], &SVector::zeros());
    for k in 0..4 {
        let step = Vector4::ith(k, 1e-6);
        assert!((a.column(k) - (at(&(x + step)) - at(&(x - step))) / 2e-6).norm() < 1e-8);
    }
    let x = SVector::<f64, 9>::from_fn(|i, _| 0.1 * i as f64 - 0.3);
    let (h, d) = SmoothSensor::<Flat, 9, 2, 2>::output_jacobians(&wide, &x);
    let at = |x: &SVector<f64, 9>, v: &Vector2<f64>| estimators::kalman::Sensor::<Flat, 9, 2, 2>::output(&wide, x, v);
    for k in 0..9 {
        let step = SVector::<f64, 9>::ith(k, 1e-6);
        let slope = (at(&(x + step), &Vector2::zeros()) - at(&(x - step), &Vector2::zeros())) / 2e-6;
        assert!((h.column(k) - slope).norm() < 1e-8, "{k}");
    }
    for k in 0..2 {
        let step = Vector2::ith(k, 1e-6);
        let slope = (at(&x, &step) - at(&x, &-step)) / 2e-6;
        assert!((d.column(k) - slope).norm() < 1e-8, "{k}");
    }
}

/// With little uncertainty the extended and the unscented filter agree to its square.
#[test]
fn extended_and_unscented_filters_agree_to_second_order() {
    let (mean, size) = (Vector4::new(50.0, 40.0, 9.0, 12.0), 1e-3);
    let start = Gaussian::new(mean, &(Matrix4::identity() * size * size)).unwrap();
    let q = Matrix4::from_diagonal(&Vector4::new(0.0, 0.0, size * size, size * size));
    let r = Matrix2::from_diagonal(&Vector2::new(size * size, 1e-10));
    let mut ekf: Ekf<_, Flat, 4, 2, 4, 2> = Ekf::new(tracking(), start, &q, &r).unwrap();
    let mut ukf: Ukf<_, Flat, 4, 2, 4, 2> = Ukf::new(tracking(), start, &q, &r).unwrap();
    for _ in 0..3 {
        let y =
            [ekf.belief().mean().xy().norm() + 1e-3, (ekf.belief().mean()[1] / ekf.belief().mean()[0]).atan() - 1e-5];
        ekf.step(&[], &y).unwrap();
        ukf.step(&[], &y).unwrap();
    }
    assert!((ekf.belief().mean() - ukf.belief().mean()).norm() < 1e-4 * size);
    assert!(apart(&ekf.belief().covariance(), &ukf.belief().covariance()) < 1e-4);
    // But they are not the same filter.
    assert!((ekf.belief().mean() - ukf.belief().mean()).norm() > 0.0);
}

/// A filter that has two sensors does as well with one of them given to the call.
#[test]
fn another_sensor_updates_as_the_own_one_does() {
    let mut random = Random::new(9);
    let model = linear(&mut random);
    let (q, r) = (covariance(&random.matrix()), covariance(&random.matrix()));
    let start = Gaussian::new(random.matrix(), &covariance(&random.matrix())).unwrap();
    let mut own = Kf::new(model, start, &q, &r).unwrap();
    let mut other = own.clone();
    own.update(&[0.3, -0.4]).unwrap();
    let innovation = other.update_by(&model, &r, &Vector2::new(0.3, -0.4)).unwrap();
    assert_eq!((own.belief(), own.innovation()), (other.belief(), Some(&innovation)));
}
