//! Bad input gives a typed error that names what and where, and leaves the set as it was.

use scalars::Interval;
use setrep::{ConstrainedZonotope, IntervalMatrix, Matrix, Part, SetError, Workspace};

fn band() -> ConstrainedZonotope {
    let rows = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let body = setrep::Zonotope::with_remainder(&[1.0, 2.0], &Matrix::identity(2), &[0.5, 0.0]).unwrap();
    ConstrainedZonotope::with_constraints(&body, &rows, &[Interval::new(-0.5, 0.5).unwrap()]).unwrap()
}

#[test]
fn constructors() {
    let (c, g) = ([0.0, 0.0], Matrix::identity(2));
    let rows = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let new = |rows: &Matrix, ranges: &[Interval]| ConstrainedZonotope::new(&c, &g, rows, ranges).map(|_| ());
    assert_eq!(new(&rows, &[]), Err(SetError::Dimension { part: Part::Range, expected: 1, found: 0 }));
    assert_eq!(new(&rows, &[Interval::EMPTY]), Err(SetError::EmptyInterval { part: Part::Range, row: 0 }));
    assert_eq!(
        new(&Matrix::zeros(1, 3), &[Interval::ZERO]),
        Err(SetError::Dimension { part: Part::Constraints, expected: 2, found: 3 })
    );
    let bad = Matrix::from_rows(&[&[1.0, f64::NAN]]).unwrap();
    assert!(matches!(new(&bad, &[Interval::ZERO]), Err(SetError::NonFinite { part: Part::Constraints, col: 1, .. })));
    let huge = Matrix::from_rows(&[&[1e308, 1e308]]).unwrap();
    assert_eq!(new(&huge, &[Interval::ZERO]), Err(SetError::Overflow { row: 0 }));
    let cg = ConstrainedZonotope::from_cg_rep(&c, &g, &rows, &[f64::INFINITY]);
    assert!(matches!(cg, Err(SetError::NonFinite { part: Part::Range, row: 0, .. })));
    assert!(ConstrainedZonotope::from_box(&[], &[]).is_err());
    // An unbounded range is clipped to what the row can reach.
    let half = ConstrainedZonotope::new(&c, &g, &rows, &[Interval::new(0.0, f64::INFINITY).unwrap()]).unwrap();
    assert!(half.ranges()[0].is_bounded() && half.ranges()[0].hi() >= 2.0 && half.ranges()[0].hi() < 2.0 + 1e-14);
}

/// Runs an operation that must fail, and checks that the set has not changed.
fn refused(operation: impl FnOnce(&mut ConstrainedZonotope, &mut Workspace) -> Result<(), SetError>) -> SetError {
    let mut set = band();
    let error = operation(&mut set, &mut Workspace::new()).unwrap_err();
    assert_eq!(set, band(), "after {error}");
    error
}

#[test]
fn operations_leave_the_set_unchanged() {
    let (row, range) = (Matrix::from_rows(&[&[1.0, 1.0]]).unwrap(), [Interval::ZERO]);
    assert!(matches!(refused(|x, w| x.intersect_rows(&row, &[], w)), SetError::Dimension { part: Part::Range, .. }));
    assert!(matches!(refused(|x, w| x.intersect_rows(&Matrix::zeros(1, 3), &range, w)), SetError::Dimension { .. }));
    assert_eq!(
        refused(|x, w| x.intersect_rows(&row, &[Interval::EMPTY], w)),
        SetError::EmptyInterval { part: Part::Range, row: 0 }
    );
    assert!(matches!(refused(|x, w| x.intersect_strip(&[f64::NAN, 1.0], range[0], w)), SetError::NonFinite { .. }));
    assert!(matches!(refused(|x, w| x.intersect_half_space(&[1.0, 0.0], f64::NAN, w)), SetError::NonFinite { .. }));
    // The remainder had become a generator when the overflow was found.
    let huge = Matrix::from_rows(&[&[1.0, 0.0], &[1e308, 1e308]]).unwrap();
    assert_eq!(refused(|x, w| x.intersect_rows(&huge, &[Interval::ZERO; 2], w)), SetError::Overflow { row: 1 });
    let line = ConstrainedZonotope::from_box(&[0.0], &[1.0]).unwrap();
    assert!(matches!(refused(|x, _| x.add_assign(&line)), SetError::Dimension { .. }));
    assert!(matches!(refused(|x, w| x.intersect(&Matrix::identity(2), &line, w)), SetError::Dimension { .. }));
    assert!(matches!(refused(|x, w| x.linear_map_in_place(&Matrix::zeros(1, 3), w)), SetError::Dimension { .. }));
    let map = IntervalMatrix::point(Matrix::identity(2)).unwrap();
    assert!(matches!(refused(|x, w| x.interval_map_in_place(&map, &range, w)), SetError::Dimension { .. }));
    assert!(matches!(refused(|x, _| x.translate(&[1.0])), SetError::Dimension { .. }));
    assert!(matches!(refused(|x, w| x.support(&[1.0], w).map(|_| ())), SetError::Dimension { .. }));
    assert!(matches!(refused(|x, w| x.interval_hull_into(&mut [], w)), SetError::Dimension { .. }));
    assert!(matches!(
        refused(|x, w| x.membership(&[Interval::ENTIRE; 2], w).map(|_| ())),
        SetError::UnboundedInterval { part: Part::Point, row: 0, .. }
    ));
}
