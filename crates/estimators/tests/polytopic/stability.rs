//! The test of boundedness: values by hand, certified bounds, and what the printed theorem cannot see.

use estimators::{EstimatorError, WidthBound, stability};
use scalars::Interval;
use setrep::{IntervalMatrix, Matrix};

use crate::support::Random;

fn matrix(rows: &[&[f64]], radius: f64) -> IntervalMatrix {
    let mid = Matrix::from_rows(rows).unwrap();
    let mut rad = Matrix::zeros(mid.rows(), mid.cols());
    rad.as_mut_slice().fill(radius);
    IntervalMatrix::new(mid, rad).unwrap()
}

/// `x+ = a x`, `y = c x`: `L(0) = 2 a`, `L(1) = (r + 2 c a) / c` as printed; `a`, and `r a / c` about the centers.
#[test]
fn scalars_are_as_by_hand() {
    let (a, c, r) = (0.4, 2.0, 0.5);
    let (dynamics, outputs) = (matrix(&[&[a]], 0.0), matrix(&[&[c]], r));
    let printed = stability(&dynamics, &outputs, WidthBound::Printed).unwrap();
    assert!((printed.radius - 0.8).abs() < 1e-9 && printed.is_proven() && printed.updated == [false]);
    let centered = stability(&dynamics, &outputs, WidthBound::Centered).unwrap();
    assert!((centered.radius - r * a / c).abs() < 1e-9 && centered.updated == [true]);
}

/// Only one of two coordinates is measured; the other is stable by itself.
#[test]
fn the_better_bound_is_chosen_coordinate_by_coordinate() {
    let dynamics = matrix(&[&[3.0, 0.5], &[0.0, 0.5]], 0.0);
    let outputs = matrix(&[&[1.0, 0.0]], 0.05);
    let found = stability(&dynamics, &outputs, WidthBound::Centered).unwrap();
    assert_eq!(found.updated, [true, false]);
    // [[0.15, 0.05], [0, 0.5]]: the noise of the second output's slope is 0.05 as well.
    assert!((found.radius - 0.5).abs() < 0.02 && found.is_proven(), "{}", found.radius);
    let blind = stability(&dynamics, &matrix(&[&[0.0, 0.0]], 0.0), WidthBound::Centered).unwrap();
    assert!((blind.radius - 3.0).abs() < 1e-6 && !blind.is_proven() && blind.updated == [false, false]);
}

/// `|P| |C| >= I` where a coordinate may be updated: the printed bound of the update is never the lesser one.
#[test]
fn the_printed_theorem_ignores_measurements() {
    let mut random = Random::new(31);
    for _ in 0..50 {
        let n = 1 + random.below(4);
        let m = 1 + random.below(4);
        let mut draw = |rows: usize, scale: f64| {
            let entries: Vec<Interval> =
                (0..rows * n).map(|_| Interval::point(scale * random.unit()).inflate(0.05)).collect();
            IntervalMatrix::from_intervals(rows, n, &entries).unwrap()
        };
        let (dynamics, outputs) = (draw(n, 0.6), draw(m, 1.0));
        let found = stability(&dynamics, &outputs, WidthBound::Printed).unwrap();
        assert!(found.updated.iter().all(|updated| !updated));
        // Bounds of a spectral radius: the largest row sum above, the diagonal below.
        let ours = stability(&dynamics, &outputs, WidthBound::Centered).unwrap();
        assert!(ours.radius <= found.radius * (1.0 + 1e-9));
        let mag = |i: usize, j: usize| dynamics.get(i, j).unwrap().mag();
        let largest = (0..n).map(|i| (0..n).map(|j| 2.0 * mag(i, j)).sum()).fold(0.0, f64::max);
        let diagonal = (0..n).map(|i| 2.0 * mag(i, i)).fold(0.0, f64::max);
        assert!(found.radius <= largest * (1.0 + 1e-9) && found.radius >= diagonal);
    }
}

#[test]
fn bad_sizes_are_refused() {
    let square = matrix(&[&[1.0, 0.0], &[0.0, 1.0]], 0.0);
    let wide = matrix(&[&[1.0, 0.0, 0.0]], 0.0);
    assert!(matches!(stability(&wide, &square, WidthBound::Centered), Err(EstimatorError::Size { .. })));
    assert!(matches!(stability(&square, &wide, WidthBound::Printed), Err(EstimatorError::Size { .. })));
}
