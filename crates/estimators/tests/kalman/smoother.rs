//! The smoother against the batch solution, and on a group.

use estimators::Estimator;
use estimators::kalman::wheels::{TfgIekf, TwoFrameError, WheelError, WheelState, WheelStep, Wheels};
use estimators::kalman::{Gaussian, Kf, LinearModel, Motion, Sensor, Track};
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, SMatrix, Vector2, Vector3, Vector6};

use crate::models::covariance;
use crate::support::{Random, cases};

/// On a linear model every smoothed belief is the marginal of the Gaussian of all states given all outputs, computed here at once from
/// its information matrix.
#[test]
fn smoothing_is_the_batch_solution() {
    const STEPS: usize = 12;
    let mut random = Random::new(11);
    for _ in 0..cases(20) {
        // Noise in all directions, so that the batch has an information matrix.
        let (a, b) = (random.matrix() * 0.6, Matrix3::identity() + random.matrix() * 0.2);
        let c: SMatrix<f64, 2, 3> = random.matrix();
        let (q, r) = (covariance(&random.matrix()), covariance(&random.matrix()));
        let (x0, p0): (Vector3<f64>, Matrix3<f64>) = (random.matrix(), covariance(&random.matrix()));
        let model = LinearModel::new(a, b, c).unwrap();
        let mut filter: Kf<3, 2, 3> = Kf::new(model, Gaussian::new(x0, &p0).unwrap(), &q, &r).unwrap();
        let mut track = Track::with_capacity(STEPS);
        let n = 3 * (STEPS + 1);
        let (mut information, mut right) = (DMatrix::<f64>::zeros(n, n), DVector::<f64>::zeros(n));
        let weight = p0.try_inverse().unwrap();
        let mut add = |at: usize, m: Matrix3<f64>, v: Vector3<f64>, row: usize| {
            let mut block = information.fixed_view_mut::<3, 3>(row, at);
            block += m;
            let mut part = right.fixed_rows_mut::<3>(row);
            part += v;
        };
        add(0, weight, weight * x0, 0);
        let (w_q, w_r) = ((b * q * b.transpose()).try_inverse().unwrap(), r.try_inverse().unwrap());
        for k in 0..=STEPS {
            let y: Vector2<f64> = random.matrix();
            add(3 * k, c.transpose() * w_r * c, c.transpose() * w_r * y, 3 * k);
            filter.update(y.as_slice()).unwrap();
            if k < STEPS {
                let u: Vector3<f64> = random.matrix();
                let mut plain = filter.clone();
                filter.predict_into(&u, &mut track).unwrap();
                plain.predict(&u).unwrap();
                assert_eq!(plain.belief(), filter.belief());
                add(3 * k, a.transpose() * w_q * a, -(a.transpose() * w_q * u), 3 * k);
                add(3 * k + 3, -a.transpose() * w_q, Vector3::zeros(), 3 * k);
                add(3 * k, -w_q * a, Vector3::zeros(), 3 * k + 3);
                add(3 * k + 3, w_q, w_q * u, 3 * k + 3);
            }
        }
        let covariances = information.try_inverse().unwrap();
        let means = &covariances * right;
        for (k, belief) in track.smooth(filter.belief()).unwrap().iter().enumerate() {
            let (mean, p) = (means.fixed_rows::<3>(3 * k), covariances.fixed_view::<3, 3>(3 * k, 3 * k));
            assert!((belief.mean() - mean).norm() < 1e-9, "{k}: {} {mean}", belief.mean());
            assert!((belief.covariance() - p).norm() < 1e-9, "{k}: {} {p}", belief.covariance());
        }
        track.clear();
        assert!(track.is_empty() && track.smooth(filter.belief()).unwrap() == [*filter.belief()]);
    }
}

/// A step without any noise leaves singular covariances: constants have one smoothed belief at all steps, the last.
#[test]
fn constants_are_smoothed_to_one_belief() {
    let outputs = Random::new(2).matrix();
    let constant = LinearModel::new(Matrix3::identity(), SMatrix::<f64, 3, 2>::zeros(), outputs).unwrap();
    let known = Matrix3::from_diagonal(&Vector3::new(1.0, 0.0, 4.0));
    let start = Gaussian::new(Vector3::new(1.0, 2.0, 3.0), &known).unwrap();
    let mut filter: Kf<3, 2, 2> = Kf::new(constant, start, &Matrix2::zeros(), &Matrix2::identity()).unwrap();
    let mut track = Track::default();
    for k in 0..5 {
        filter.update(&[0.1 * f64::from(k), 1.0]).unwrap();
        filter.predict_into(&Vector3::zeros(), &mut track).unwrap();
    }
    for belief in track.smooth(filter.belief()).unwrap() {
        assert!((belief.mean() - filter.belief().mean()).norm() < 1e-12);
        assert!((belief.covariance() - filter.belief().covariance()).norm() < 1e-12);
        assert_eq!(belief.mean()[1], 2.0);
    }
}

/// On the two-frame group: the first heading, unknown at first, is known in hindsight; what could not be predicted is not remembered.
#[test]
fn the_first_heading_is_known_in_hindsight() {
    let mut random = Random::new(4);
    let mut truth = WheelState::new(2.0, 0.9, Vector2::new(1.0, -2.0), Vector2::new(0.5, 0.3));
    let guess = WheelState::new(1.0, 1.0, truth.position, Vector2::zeros());
    let start = TwoFrameError::belief(guess, &Vector6::new(1.0, 0.3, 1.0, 1.0, 1.0, 1.0)).unwrap();
    let (q, r) = (Matrix3::identity() * 1e-8, Matrix2::identity() * 1e-4);
    let mut filter = TfgIekf::new(Wheels, start, &q, &r).unwrap();
    let (mut track, mut truths) = (Track::with_capacity(200), Vec::new());
    for k in 0..200 {
        let step = WheelStep::new(if k % 100 < 50 { 0.1 } else { -0.05 }, Vector2::new(0.2, 0.0));
        truths.push(truth);
        let noise = random.matrix::<3, 1>() * 1e-4;
        truth = Motion::<TwoFrameError, 6, 3>::transition(&Wheels, &truth, &step, &noise);
        filter.predict_into(&step, &mut track).unwrap();
        let y = Sensor::<TwoFrameError, 6, 2, 2>::output(&Wheels, &truth, &(random.matrix() * 0.01));
        filter.update(y.as_slice()).unwrap();
    }
    assert!(filter.predict_into(&WheelStep::new(f64::NAN, Vector2::zeros()), &mut track).is_err());
    assert_eq!(track.len(), truths.len());
    let beliefs = track.smooth(filter.belief()).unwrap();
    for (k, (belief, truth)) in beliefs.iter().zip(&truths).enumerate() {
        let mean = belief.mean();
        assert!((truth.heading_rad() - mean.heading_rad()).sin().abs() < 0.01, "{k}");
        assert!((truth.position - mean.position).norm() < 0.05 && (truth.scale - mean.scale).abs() < 0.01, "{k}");
        assert!((truth.lever - mean.lever).norm() < 0.05, "{k}: {mean:?}");
        assert!(belief.nees(truth).unwrap() < 40.0, "{k}: {}", belief.nees(truth).unwrap());
    }
    let spread = TwoFrameError::deviations(&beliefs[0]);
    assert!(spread[0] < 0.01 && TwoFrameError::deviations(&start)[0] > 0.99, "{spread}");
}
