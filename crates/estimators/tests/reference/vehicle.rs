//! The vehicle of paper 000 with sound order reduction: figures of an independent reference computation (100 runs).

use estimators::Estimator;
use nalgebra::Vector2;

use crate::support::{Truth, increment, vehicle_inzsmf, vehicle_zsmf};

/// Steps of one turn of the circle.
const STEPS: usize = 1571;

const RUNS: u64 = 20;

/// The heading's error, wrapped to `(-pi, pi]`.
fn heading_error(truth: &Truth, estimate: f64) -> f64 {
    let error = truth.pose.rotation().angle().unwrap() - estimate;
    error.sin().atan2(error.cos())
}

/// Mean heading width, mean area and heading error of a run.
type Means = [f64; 3];

/// Averages over the runs, and a comparison with the reference: widths within 0.15 rad and 0.2 m2, errors within 0.03 rad.
fn assert_means(run: impl Fn(u64) -> Means, reference: Means) {
    let mut means = [0.0; 3];
    for seed in 0..RUNS {
        for (mean, value) in means.iter_mut().zip(run(seed)) {
            *mean += value / RUNS as f64;
        }
    }
    println!("AAR(theta) {:.3} rad, AAR(x) {:.3} m2, RMSE(theta) {:.3} rad", means[0], means[1], means[2]);
    for ((mean, reference), tolerance) in means.iter().zip(reference).zip([0.15, 0.2, 0.03]) {
        assert!((mean - reference).abs() < tolerance, "{mean} {reference}");
    }
}

/// Row 3 of Table I (heading off by 90 degrees), `H_0 = I`, order 30 by Combastel: the sets are far wider than the paper's,
/// whose reduction sums without absolute values.
#[test]
fn the_invariant_filter_has_the_reference_widths() {
    let run = |seed| {
        let mut truth = Truth::new(seed);
        let mut filter = vehicle_inzsmf([0.0; 3], [1.0; 3]);
        let (mut width, mut area, mut square) = (0.0, 0.0, 0.0);
        for _ in 0..STEPS {
            let y = truth.measure();
            filter.step(&increment(), y.as_slice()).unwrap();
            truth.advance();
            width += filter.tangent_set().interval_hull()[0].width();
            let hull = filter.world_hull_approx(&Vector2::zeros());
            area += hull[0].width() * hull[1].width();
            square += heading_error(&truth, filter.estimate().rotation().angle().unwrap()).powi(2);
        }
        let n = STEPS as f64;
        [width / n, area / n, (square / n).sqrt()]
    };
    assert_means(run, [12.51, 17.94, 0.278]);
}

#[test]
fn the_euclidean_filter_has_the_reference_widths() {
    let run = |seed| {
        let mut truth = Truth::new(seed);
        let mut filter = vehicle_zsmf([0.0; 3], [1.0; 3]);
        let (mut width, mut area, mut square) = (0.0, 0.0, 0.0);
        for _ in 0..STEPS {
            let y = truth.measure();
            filter.step(&(), y.as_slice()).unwrap();
            truth.advance();
            let hull = filter.enclosure().interval_hull();
            width += hull[0].width();
            area += hull[1].width() * hull[2].width();
            square += heading_error(&truth, filter.estimate()[0]).powi(2);
        }
        let n = STEPS as f64;
        [width / n, area / n, (square / n).sqrt()]
    };
    assert_means(run, [14.13, 17.16, 0.334]);
}

/// Ten turns from row 7's start (heading and position off): the estimate converges and stays.
#[test]
fn the_invariant_filter_converges_and_stays() {
    let mut truth = Truth::new(2);
    let mut filter = vehicle_inzsmf([0.0, 5.0, -5.0], [1.0; 3]);
    for k in 0..10 * STEPS {
        let y = truth.measure();
        filter.step(&increment(), y.as_slice()).unwrap();
        truth.advance();
        if k > STEPS {
            let heading = heading_error(&truth, filter.estimate().rotation().angle().unwrap());
            let position = (truth.pose.translation() - filter.estimate().translation()).norm();
            assert!(heading.abs() < 1.5 && position < 2.0, "step {k}: {heading} rad, {position} m");
            assert!(filter.tangent_set().f_radius() < 10.0);
        }
    }
}
