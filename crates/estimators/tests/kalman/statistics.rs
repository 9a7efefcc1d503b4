//! The covariance of a filter is that of its error.

use estimators::Estimator;
use estimators::kalman::{Flat, Gaussian, Kf, Motion, Sensor};
use nalgebra::{SMatrix, SVector, Vector3};

use crate::models::{covariance, linear};
use crate::support::{Random, cases};

/// Approximately Gaussian: the sum of twelve uniform numbers in `[-1/2, 1/2]`, exact in mean and variance.
fn normal<const N: usize>(random: &mut Random) -> SVector<f64, N> {
    SVector::from_fn(|_, _| (0..12).map(|_| 0.5 * random.unit()).sum())
}

/// NEES and NIS of a linear model with the right noises average to `N` and `M`.
#[test]
fn nees_and_nis_average_to_their_dimensions() {
    let mut random = Random::new(3);
    let (runs, steps) = (cases(400), 20);
    let (mut nees, mut nis) = (0.0, 0.0);
    for _ in 0..runs {
        let model = linear(&mut random);
        let roots: (SMatrix<f64, 2, 2>, SMatrix<f64, 2, 2>) = (random.matrix(), random.matrix());
        let (q, r) = (covariance(&roots.0), covariance(&roots.1));
        let p = covariance(&random.matrix::<3, 3>());
        let draw = |p: &SMatrix<f64, 2, 2>, random: &mut Random| p.cholesky().unwrap().l() * normal::<2>(random);
        let start = Gaussian::<Flat, 3>::new(random.matrix(), &p).unwrap();
        let mut x = start.mean() + p.cholesky().unwrap().l() * normal::<3>(&mut random);
        let mut filter = Kf::new(model, start, &q, &r).unwrap();
        for _ in 0..steps {
            let v = draw(&r, &mut random);
            let y = Sensor::<Flat, 3, 2, 2>::output(&model, &x, &v);
            filter.update(y.as_slice()).unwrap();
            nees += filter.belief().nees(&x).unwrap();
            nis += filter.innovation().unwrap().nis();
            let w = draw(&q, &mut random);
            x = Motion::<Flat, 3, 2>::transition(&model, &x, &Vector3::zeros(), &w);
            filter.predict(&Vector3::zeros()).unwrap();
        }
    }
    let count = (runs * steps) as f64;
    // Innovations are independent; errors of successive steps are not. Four standard deviations, the latter with a wide margin.
    assert!((nis / count - 2.0).abs() < 4.0 * (4.0 / count).sqrt(), "NIS {}", nis / count);
    assert!((nees / count - 3.0).abs() < 4.0 * (6.0 * 5.0 / count).sqrt(), "NEES {}", nees / count);
}
