//! Bad input gives a typed error that names what and where, and leaves the set as it was.

use scalars::Interval;
use setrep::{IntervalMatrix, IntervalVector, Matrix, Part, Reduction, SetError, Workspace, Zonotope};

fn square() -> Zonotope {
    Zonotope::with_remainder(
        &[1.0, 2.0],
        &Matrix::from_rows(&[&[1.0, 0.5, 0.25], &[0.0, 1.0, 0.5]]).unwrap(),
        &[0.125, 0.0],
    )
    .unwrap()
}

#[test]
fn constructors() {
    let g = Matrix::identity(2);
    assert_eq!(Zonotope::new(&[], &Matrix::zeros(0, 0)), Err(SetError::ZeroDimension { part: Part::Center }));
    assert_eq!(Zonotope::new(&[0.0], &g), Err(SetError::Dimension { part: Part::Generators, expected: 1, found: 2 }));
    assert!(matches!(
        Zonotope::new(&[0.0, f64::NAN], &g),
        Err(SetError::NonFinite { part: Part::Center, row: 1, col: 0, .. })
    ));
    let infinite = Matrix::from_rows(&[&[1.0, 2.0], &[f64::INFINITY, 0.0]]).unwrap();
    assert!(matches!(
        Zonotope::new(&[0.0, 0.0], &infinite),
        Err(SetError::NonFinite { part: Part::Generators, row: 1, col: 0, .. })
    ));
    assert_eq!(
        Zonotope::with_remainder(&[0.0, 0.0], &g, &[0.0]),
        Err(SetError::Dimension { part: Part::Remainder, expected: 2, found: 1 })
    );
    assert_eq!(
        Zonotope::with_remainder(&[0.0, 0.0], &g, &[0.0, -1.0]),
        Err(SetError::Negative { part: Part::Remainder, row: 1, col: 0, value: -1.0 })
    );
    assert_eq!(
        Zonotope::from_box(&[0.0, 0.0], &[-0.5, 1.0]),
        Err(SetError::Negative { part: Part::Radius, row: 0, col: 0, value: -0.5 })
    );
    assert!(matches!(Zonotope::from_intervals(&[Interval::ENTIRE]), Err(SetError::UnboundedInterval { row: 0, .. })));
    assert!(matches!(
        Zonotope::from_intervals(&[Interval::ONE, Interval::EMPTY]),
        Err(SetError::UnboundedInterval { row: 1, .. })
    ));
    assert_eq!(Zonotope::from_intervals(&[]), Err(SetError::ZeroDimension { part: Part::Center }));
    assert!(Zonotope::point(&[f64::NEG_INFINITY]).is_err());
    assert!(Matrix::from_rows(&[&[1.0], &[1.0, 2.0]]).is_err());
    assert!(Matrix::from_column_slice(2, 2, &[1.0]).is_err());
    assert!(IntervalVector::from_center(&[0.0], &[-1.0]).is_err());
    assert!(IntervalMatrix::new(Matrix::identity(2), Matrix::zeros(2, 3)).is_err());
    let negative = Matrix::from_rows(&[&[0.0, 0.0], &[-1.0, 0.0]]).unwrap();
    assert!(matches!(
        IntervalMatrix::new(Matrix::identity(2), negative),
        Err(SetError::Negative { row: 1, col: 0, .. })
    ));
    assert!(IntervalMatrix::from_intervals(1, 2, &[Interval::ONE]).is_err());
    assert!(IntervalMatrix::from_intervals(1, 1, &[Interval::ENTIRE]).is_err());
}

/// Runs an operation that must fail, and checks that the set has not changed.
fn refused(operation: impl FnOnce(&mut Zonotope, &mut Workspace) -> Result<(), SetError>) -> SetError {
    let mut set = square();
    let error = operation(&mut set, &mut Workspace::new()).unwrap_err();
    assert_eq!(set, square(), "after {error}");
    error
}

#[test]
fn operations_leave_the_set_unchanged() {
    let wide = Matrix::zeros(2, 3);
    assert_eq!(
        refused(|x, w| x.linear_map_in_place(&wide, w)),
        SetError::Dimension { part: Part::Map, expected: 2, found: 3 }
    );
    assert_eq!(
        refused(|x, w| x.linear_map_in_place(&Matrix::zeros(0, 2), w)),
        SetError::ZeroDimension { part: Part::Map }
    );
    for bad in [f64::NAN, f64::INFINITY] {
        let map = Matrix::from_rows(&[&[1.0, 1.0], &[bad, 0.0]]).unwrap();
        let error = refused(|x, w| x.linear_map_in_place(&map, w));
        assert!(matches!(error, SetError::NonFinite { part: Part::Map, row: 1, col: 0, .. }), "{error}");
    }
    let huge = Matrix::from_rows(&[&[1.0, 1.0], &[1e308, 1e308]]).unwrap();
    assert_eq!(refused(|x, w| x.linear_map_in_place(&huge, w)), SetError::Overflow { row: 1 });
    let huge =
        IntervalMatrix::new(Matrix::identity(2), Matrix::from_rows(&[&[0.0, 1e308], &[0.0, 0.0]]).unwrap()).unwrap();
    assert_eq!(refused(|x, w| x.interval_map_in_place(&huge, w)), SetError::Overflow { row: 0 });
    let flat = IntervalMatrix::point(Matrix::zeros(2, 1)).unwrap();
    assert!(matches!(refused(|x, w| x.interval_map_in_place(&flat, w)), SetError::Dimension { .. }));

    let line = Zonotope::point(&[1.0]).unwrap();
    assert!(matches!(refused(|x, _| x.add_assign(&line)), SetError::Dimension { expected: 2, found: 1, .. }));
    assert!(matches!(refused(|x, _| x.append_generators(&Matrix::identity(3))), SetError::Dimension { .. }));
    let nan = Matrix::from_rows(&[&[0.0, 1.0], &[0.0, f64::NAN]]).unwrap();
    assert!(matches!(refused(|x, _| x.append_generators(&nan)), SetError::NonFinite { row: 1, col: 1, .. }));

    assert!(matches!(refused(|x, _| x.translate(&[1.0])), SetError::Dimension { .. }));
    assert!(matches!(refused(|x, _| x.translate(&[1.0, f64::INFINITY])), SetError::NonFinite { row: 1, .. }));
    assert!(matches!(refused(|x, _| x.scale(f64::NAN)), SetError::NonFinite { part: Part::Factor, .. }));
    assert_eq!(refused(|x, _| x.scale(1e308)), SetError::Overflow { row: 0 });
    for method in [Reduction::Combastel, Reduction::Girard, Reduction::Pca, Reduction::Method4] {
        assert_eq!(refused(|x, w| x.reduce(method, 1, w)), SetError::TooFewGenerators { max_generators: 1, dim: 2 });
    }
    assert!(matches!(square().support(&[1.0]), Err(SetError::Dimension { .. })));
    assert!(matches!(
        square().support(&[1.0, f64::NAN]),
        Err(SetError::NonFinite { part: Part::Direction, row: 1, .. })
    ));
    assert!(square().interval_hull_into(&mut []).is_err());
}

/// Near the largest number, sums and centers overflow to an error, hulls and supports to an infinite bound.
#[test]
fn overflow() {
    let huge = Zonotope::new(&[f64::MAX], &Matrix::from_rows(&[&[f64::MAX, f64::MAX, 1.0]]).unwrap()).unwrap();
    let mut sum = huge.clone();
    assert_eq!(sum.add_assign(&huge), Err(SetError::Overflow { row: 0 }));
    assert_eq!(sum, huge);
    assert_eq!(sum.reduce(Reduction::Combastel, 1, &mut Workspace::new()), Err(SetError::Overflow { row: 0 }));
    assert_eq!(sum, huge);
    assert_eq!(huge.interval_hull()[0], Interval::ENTIRE);
    assert_eq!(huge.support(&[1.0]).unwrap(), f64::INFINITY);
    assert_eq!(huge.support(&[-1.0]).unwrap(), f64::INFINITY);
    assert_eq!(huge.f_radius(), f64::INFINITY);
}

#[test]
fn messages_name_what_and_where() {
    let error = Zonotope::with_remainder(&[0.0, 0.0], &Matrix::identity(2), &[0.0, -1.0]).unwrap_err();
    assert_eq!(error.to_string(), "box remainder: entry (1, 0) is -1, below zero");
}

/// A matrix of no entries can claim any shape; products over no dimension are refused before memory is asked for.
#[test]
fn products_over_no_dimension_are_refused() {
    let wide = IntervalMatrix::point(Matrix::from_column_slice(0, 1 << 62, &[]).unwrap());
    let tall = IntervalMatrix::point(Matrix::zeros(3, 0));
    let error = tall.and_then(|tall| tall.mul(&wide.unwrap())).unwrap_err();
    assert_eq!(error, SetError::ZeroDimension { part: Part::Map });
}
