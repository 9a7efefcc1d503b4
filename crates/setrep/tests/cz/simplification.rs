//! Rescaling, inactive generators, redundant constraints.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Workspace};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::member::{assert_not_refuted, constrained, loosened};

/// Members survive every exact simplification, and the hull stays what it was but for a few roundings of the rows. In case 57279
/// one of these, 1e-16 of a row, moves the hull by 6e-8 of its extent.
#[test]
fn simplifications_keep_the_set() {
    let mut workspace = Workspace::new();
    let (mut rows_dropped, mut columns_dropped) = (0, 0);
    for case in (0..cases(7_500)).chain([57_279]) {
        let mut random = Random::new(SEED + 40, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 8), random.between(0, 5));
        let (set, member) = constrained(&mut random, n, m, rows);
        let mut simple = set.clone();
        match case % 3 {
            0 => simple.rescale(&mut workspace).unwrap(),
            1 => simple.remove_inactive_generators(),
            _ => simple.remove_redundant_constraints(&mut workspace).unwrap(),
        }
        let context = || format!("seed {SEED}+40 case {case}: {set:?} {simple:?} {member:?}");
        assert_not_refuted(&simple, &member.x, &mut random, &mut workspace, &context);
        rows_dropped += rows - simple.num_constraints();
        columns_dropped += m - simple.num_generators();
        let before = loosened(&set, 1e-12).interval_hull(&mut workspace).unwrap();
        let after = simple.interval_hull(&mut workspace).unwrap();
        for (k, (before, after)) in before.iter().zip(after.iter()).enumerate() {
            let extent: f64 = set.generators().columns().map(|g| g[k].abs()).sum::<f64>() + set.center()[k].abs();
            let tolerance = 1e-9 * (extent + set.remainder()[k]);
            let (below, above) = (before.lo() - after.lo(), after.hi() - before.hi());
            assert!(
                below.max(above) <= tolerance,
                "{below:e} {above:e} of {extent:e} {before:?} {after:?}: {}",
                context()
            );
        }
    }
    assert!(rows_dropped > 100 && columns_dropped > 100, "{rows_dropped} rows, {columns_dropped} columns");
}

/// After rescaling, the hull of the set without its constraints is that of the constraints' boxes.
#[test]
fn rescaling_is_tight() {
    let mut workspace = Workspace::new();
    let rows = Matrix::from_rows(&[&[1.0, 0.5, 0.0], &[0.0, 0.0, 1.0]]).unwrap();
    let ranges = [Interval::point(1.25), Interval::new(-0.5, 0.0).unwrap()];
    let mut set = ConstrainedZonotope::new(&[0.0; 3], &Matrix::identity(3), &rows, &ranges).unwrap();
    set.rescale(&mut workspace).unwrap();
    let hull = set.unconstrained().interval_hull();
    for (side, (lo, hi)) in hull.iter().zip([(0.75, 1.0), (0.5, 1.0), (-0.5, 0.0)]) {
        assert!((side.lo() - lo).abs() < 1e-14 && (side.hi() - hi).abs() < 1e-14, "{hull:?}");
    }
    assert_eq!(set.num_constraints(), 1);
    // Slacks of the textbook form become ranges again.
    let mut form = set.textbook_form().unwrap();
    let before = form.num_generators();
    form.remove_inactive_generators();
    assert!(form.num_generators() <= before);
}

/// Bounds of single coordinates that other rows imply are redundant; the binding ones stay.
#[test]
fn implied_rows_are_dropped() {
    let mut workspace = Workspace::new();
    let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let rows = Matrix::from_rows(&[&[1.0, 1.0], &[1.0, 0.75], &[1.0, 1.0], &[0.0, 1.0], &[-1.0, -1.0]]).unwrap();
    let upper = |b: f64| Interval::new(f64::NEG_INFINITY, b).unwrap();
    let ranges = [upper(1.0), upper(1.5), upper(1.25), upper(0.25), upper(1.5)];
    set.intersect_rows(&rows, &ranges, &mut workspace).unwrap();
    let before = set.interval_hull(&mut workspace).unwrap();
    set.remove_redundant_constraints(&mut workspace).unwrap();
    // x_1 + x_2 in [-1.5, 1] is one row now, and x_2 <= 1/4 the other.
    assert_eq!(set.num_constraints(), 2);
    assert_eq!(before, set.interval_hull(&mut workspace).unwrap());
}
