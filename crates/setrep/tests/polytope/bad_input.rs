//! Bad input is a typed error that names what and where.

use scalars::Interval;
use setrep::{HPolytope, IntervalVector, Matrix, Part, SetError, VPolytope};

#[test]
fn constructors_check() {
    let nan = Matrix::from_rows(&[&[1.0, f64::NAN]]).unwrap();
    assert!(matches!(
        HPolytope::new(nan.clone(), &[1.0]),
        Err(SetError::NonFinite { part: Part::Normals, row: 0, col: 1, .. })
    ));
    assert!(matches!(VPolytope::new(nan), Err(SetError::NonFinite { part: Part::Vertices, row: 0, col: 1, .. })));
    let infinite = HPolytope::new(Matrix::identity(2), &[1.0, f64::INFINITY]);
    assert!(matches!(infinite, Err(SetError::NonFinite { part: Part::Offsets, row: 1, .. })));
    assert_eq!(
        HPolytope::new(Matrix::identity(2), &[1.0]),
        Err(SetError::Dimension { part: Part::Offsets, expected: 2, found: 1 })
    );
    assert_eq!(HPolytope::new(Matrix::zeros(3, 0), &[1.0; 3]), Err(SetError::ZeroDimension { part: Part::Normals }));
    assert_eq!(VPolytope::new(Matrix::zeros(0, 3)), Err(SetError::ZeroDimension { part: Part::Vertices }));
    assert_eq!(VPolytope::new(Matrix::zeros(3, 0)), Err(SetError::EmptySet));
    let negative = VPolytope::with_remainder(Matrix::identity(2), &[0.0, -1.0]);
    assert!(matches!(negative, Err(SetError::Negative { part: Part::Remainder, row: 1, .. })));
    let wide = vec![Interval::new(0.0, 1.0).unwrap(); 20];
    assert!(matches!(VPolytope::from_intervals(&wide), Err(SetError::OverBudget { .. })));
    assert!(matches!(VPolytope::from_intervals(&[Interval::ENTIRE]), Err(SetError::UnboundedInterval { row: 0, .. })));
    assert!(matches!(HPolytope::from_intervals(&[Interval::EMPTY]), Err(SetError::UnboundedInterval { row: 0, .. })));
}

#[test]
fn operations_check() {
    let (h, v) =
        (HPolytope::from_intervals(&[Interval::ONE; 2]).unwrap(), VPolytope::new(Matrix::identity(3)).unwrap());
    assert!(matches!(v.support(&[1.0]), Err(SetError::Dimension { part: Part::Direction, expected: 3, found: 1 })));
    assert!(matches!(v.support(&[1.0, f64::NAN, 0.0]), Err(SetError::NonFinite { part: Part::Direction, row: 1, .. })));
    assert!(matches!(v.linear_map(&Matrix::identity(2)), Err(SetError::Dimension { part: Part::Map, .. })));
    assert_eq!(v.minkowski_sum_2d(&v), Err(SetError::NotPlanar { dim: 3 }));
    assert_eq!(v.outline_2d(), Err(SetError::NotPlanar { dim: 3 }));
    let other = HPolytope::from_intervals(&[Interval::ONE; 3]).unwrap();
    assert!(matches!(h.intersection(&other), Err(SetError::Dimension { .. })));
    assert!(matches!(h.membership(&IntervalVector::point(&[0.0])), Err(SetError::Dimension { part: Part::Point, .. })));
    assert!(matches!(v.membership(&[Interval::ENTIRE; 3]), Err(SetError::UnboundedInterval { part: Part::Point, .. })));
    let huge = VPolytope::new(Matrix::from_columns(&[&[1e308, 1e308], &[-1e308, 1e308]]).unwrap()).unwrap();
    assert!(matches!(
        huge.linear_map(&Matrix::from_rows(&[&[1e10, 0.0]]).unwrap()),
        Err(SetError::Overflow { row: 0 })
    ));
    assert!(matches!(huge.minkowski_sum_2d(&huge), Err(SetError::Overflow { .. })));
}

#[test]
fn unbounded_and_empty_sets_say_so() {
    let whole = HPolytope::new(Matrix::zeros(0, 2), &[]).unwrap();
    assert_eq!(whole.to_v_polytope(), Err(SetError::Unbounded));
    let half = HPolytope::new(Matrix::from_rows(&[&[1.0, 0.0]]).unwrap(), &[1.0]).unwrap();
    assert_eq!(half.to_v_polytope(), Err(SetError::Unbounded));
    assert_eq!(half.volume(), Err(SetError::Unbounded));
    let strip = HPolytope::new(Matrix::from_rows(&[&[1.0, 1.0], &[-1.0, -1.0]]).unwrap(), &[1.0, 1.0]).unwrap();
    assert_eq!(strip.remove_redundant(), Err(SetError::Unbounded));
    let quadrant = HPolytope::new(Matrix::identity(2), &[0.0, 0.0]).unwrap();
    assert_eq!(quadrant.interior_point(), Err(SetError::Unbounded));
    let empty_strip = HPolytope::new(Matrix::from_rows(&[&[1.0, 1.0], &[-1.0, -1.0]]).unwrap(), &[1.0, -2.0]).unwrap();
    assert_eq!(empty_strip.to_v_polytope(), Err(SetError::EmptySet));
    let never = HPolytope::new(Matrix::zeros(1, 2), &[-1.0]).unwrap();
    assert_eq!(never.to_v_polytope(), Err(SetError::EmptySet));
    let always = HPolytope::new(Matrix::zeros(1, 2), &[0.0]).unwrap();
    assert_eq!(always.to_v_polytope(), Err(SetError::Unbounded));
    let far = HPolytope::new(Matrix::from_rows(&[&[1e-200], &[-1e-200]]).unwrap(), &[1e200, 1e200]).unwrap();
    assert_eq!(far.to_v_polytope(), Err(SetError::Overflow { row: 0 }));
}
