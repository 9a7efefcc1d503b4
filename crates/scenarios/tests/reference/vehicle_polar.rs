//! Paper 001, section 5.2.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian};
use estimators::{Estimator, LinearizedZf};
use nalgebra::{Matrix1, Matrix4, Vector1, Vector4};
use nonlin_bounds::{Function, function};
use scalars::Interval;
use scenarios::Context;
use scenarios::contest::{Arena, Noise, study};
use scenarios::truth::{exact_sum, proven_within};
use scenarios::vehicle_polar::filters::{ESTIMATE, GUARANTEED, NOISE_BOUND, PROCESS_BOUND, PUBLISHED, options, system};
use scenarios::vehicle_polar::plant::{Bearing, Drive, Polar};
use scenarios::vehicle_polar::setting::Setting;
use setrep::Zonotope;

/// Shows 2: Table 2 within 6 %; the zonotopic filter, which takes hundreds of times longer, on its first runs: as the unscented filter there.
#[test]
fn table_2() {
    let context = Context::new(1);
    let statistical = &study(&context, 100, &Setting::fitted(Noise::Gaussian), "test", &PUBLISHED[..1]).unwrap()[0];
    let sets = &study(&context, 3, &Setting::fitted(Noise::Gaussian), "test", &PUBLISHED[1..2]).unwrap()[0];
    assert_eq!((statistical.diverged(), sets.diverged()), (0, 0));
    for (i, paper) in [0.87, 0.87, 0.22, 0.22].into_iter().enumerate() {
        let mean = statistical.samples(|run| run.rmse[i]).iter().sum::<f64>() / 100.0;
        println!("ukf x{}: {mean:.4} (paper {paper})", i + 1);
        assert!((mean / paper - 1.0).abs() < 0.06, "x{}: {mean}", i + 1);
        for (set, belief) in sets.runs.iter().zip(&statistical.runs) {
            assert!(
                (set.rmse[i] / belief.rmse[i] - 1.0).abs() < 0.05,
                "x{}: {} {}",
                i + 1,
                set.rmse[i],
                belief.rmse[i]
            );
        }
    }
    // Never lost in these runs; that is no guarantee.
    assert!(sets.runs.iter().all(|run| run.boxed == run.watched));
}

/// The truth contract: positions move exactly, and the noises of speeds and outputs that are enclosed keep three standard deviations.
#[test]
fn a_run_is_an_exact_trajectory() {
    let truth = Setting::fitted(Noise::Truncated).truth(&Context::new(1), 0).unwrap();
    let point = |x: &[f64], noises: usize| -> Vec<Interval> {
        x.iter().copied().map(Interval::point).chain(std::iter::repeat_n(Interval::ZERO, noises)).collect()
    };
    for pair in truth.states.windows(2) {
        let mut image = [Interval::ZERO; 4];
        Drive.eval(&point(&pair[0], 4), &[], &mut image);
        for i in [0, 1] {
            assert_eq!(exact_sum(pair[0][i], 0.5 * pair[0][i + 2]), Some(pair[1][i]));
        }
        assert!([2, 3].iter().all(|&i| proven_within(&(Interval::point(pair[1][i]) - image[i]), 0.3)));
    }
    for (x, y) in truth.states.iter().zip(&truth.outputs) {
        let mut seen = [Interval::ZERO; 2];
        Polar(Bearing::Atan).eval(&point(x, 2), &[], &mut seen);
        let bounds = [0.15_f64, 2.618e-3];
        assert!((0..2).all(|i| proven_within(&(Interval::point(y[i]) - seen[i]), bounds[i].next_up())));
    }
}

/// Shows 2: the center of the zonotopic filter is the estimate of the extended Kalman filter with the same bounds for standard deviations
/// (nine times the variances), one output after the other.
#[test]
fn the_center_is_an_extended_kalman_filter() {
    let range = ByFunction::new(function!(|[x1, x2, _x3, _x4, v]: 5| -> 1 { [(x1.sqr() + x2.sqr()).sqrt() + v] }));
    let bearing = ByFunction::new(function!(|[x1, x2, _x3, _x4, v]: 5| -> 1 { [(x2 / x1).atan() + v] }));
    let belief = Gaussian::new(Vector4::from(ESTIMATE), &Matrix4::from_diagonal_element(9.0)).unwrap();
    let q = Matrix4::from_diagonal(&Vector4::from(PROCESS_BOUND.map(|bound| bound * bound)));
    let mut ekf: Ekf<_, Flat, 4, 1, 4, 1> =
        Ekf::new((ByFunction::new(Drive), range.clone()), belief, &q, &Matrix1::identity()).unwrap();
    let first = Zonotope::from_box(&ESTIMATE, &[3.0; 4]).unwrap();
    let system = system(Bearing::Atan, PROCESS_BOUND, NOISE_BOUND).unwrap();
    let mut zf = LinearizedZf::new(system, first, options()).unwrap();
    let truth = Setting::fitted(Noise::Gaussian).truth(&Context::new(1), 0).unwrap();
    for (k, y) in truth.outputs[..250].iter().enumerate() {
        zf.predict(&[]).unwrap();
        zf.update(y).unwrap();
        ekf.predict(&[]).unwrap();
        let r = NOISE_BOUND.map(|bound| Matrix1::new(bound * bound));
        ekf.update_by(&range, &r[0], &Vector1::new(y[0])).unwrap();
        ekf.update_by(&bearing, &r[1], &Vector1::new(y[1])).unwrap();
        let center = Vector4::from_column_slice(zf.enclosure().center());
        let mean = ekf.belief().mean();
        assert!((center - mean).norm() <= 1e-9 * mean.norm(), "k = {k}: {center} {mean}");
        // Two columns for the process noise (those of zero bound are left out), two for the strips, and at times one for rounding that has
        // grown beyond 1e-9.
        let columns = zf.enclosure().num_generators();
        assert!((4 + 4 * (k + 1)..=4 + 5 * (k + 1)).contains(&columns), "k = {k}: {columns}");
    }
}

/// Shows 5: the filter with a guarantee diverges, and says so; also from a small set around the truth.
#[test]
fn the_guaranteed_filter_diverges() {
    let cells = study(&Context::new(1), 3, &Setting::fitted(Noise::Truncated), "test", &GUARANTEED).unwrap();
    for cell in &cells {
        let steps: Vec<_> = cell.runs.iter().map(|run| run.diverged).collect();
        println!("{} diverged at {steps:?}", cell.method);
        assert!(steps.iter().all(|step| step.is_some_and(|step| step <= 20)), "{steps:?}");
    }
}
