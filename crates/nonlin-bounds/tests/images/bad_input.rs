//! Bad input: typed errors, and arguments as they were.

use nonlin_bounds::{
    AffineEnclosure, BoundError, Copies, Domain, Expansion, Form, Function, Operand, OutputStrip, QuadraticEnclosure,
    Rows, Smoothness, Workspace, affine_image, affine_solution,
};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, Matrix, SetError};

/// `(|x|, x |x|, 1 / x, sqrt(x), ln(x - 10))`.
struct Rough;

impl Function for Rough {
    const VARIABLES: Option<usize> = Some(1);
    fn outputs(&self) -> usize {
        5
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].abs();
        y[1] = x[0] * x[0].abs();
        y[2] = x[0].recip();
        y[3] = x[0].sqrt();
        y[4] = x[0].add_f64(-10.0).ln();
    }
}

/// `exp(x)^8`, which overflows early.
struct Steep;

impl Function for Steep {
    const VARIABLES: Option<usize> = Some(1);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].exp().powi(8);
    }
}

#[test]
fn rough_functions_are_refused_where_smoothness_is_needed() {
    let mut w = Workspace::new();
    let hull = [Interval::new(-1.0, 1.0).unwrap()];
    let mut enclosure = AffineEnclosure::new();
    let domain = Domain::new(&hull, &[0.5]);
    for (form, required) in [
        (Form::Natural, Smoothness::Defined),
        (Form::MeanValue, Smoothness::C1),
        (Form::Slope, Smoothness::C2),
        (Form::Taylor, Smoothness::C2),
    ] {
        let before = enclosure.clone();
        let error = enclosure.enclose(form, &Rough, &domain, &mut w).unwrap_err();
        let BoundError::NotSmooth { output, required: asked, found } = error else { panic!("{error}") };
        assert!(asked == required && found < required, "{form:?} {output}");
        assert_eq!(output, if form == Form::Natural { 2 } else { 0 });
        assert_eq!(enclosure, before);
    }
    let set = ConstrainedZonotope::from_box(&[0.0], &[1.0]).unwrap();
    let error = QuadraticEnclosure::new(&Rough, &set, &domain, Copies::Shared, &mut w).unwrap_err();
    assert!(matches!(error, BoundError::NotSmooth { output: 0, required: Smoothness::C2, .. }));
}

/// Row by row: a pole and an undefined output say nothing, a kink gives its range, a root where it is defined.
#[test]
fn rough_functions_are_enclosed_where_possible() {
    let mut w = Workspace::new();
    let mut enclosure = AffineEnclosure::new();
    let mut rows = Rows::new();
    let hull = [Interval::new(-1.0, 4.0).unwrap()];
    let values = [Interval::new(2.0, 3.0).unwrap(); 5];
    let error = enclosure.enclose_where_possible(&Rough, &Domain::new(&hull, &[1.5]), &mut w);
    error.unwrap();
    // ln(x - 10) is defined nowhere on the box: no solution.
    assert_eq!(enclosure.rows_into(1, &values, &mut rows), Err(SetError::EmptySet.into()));
    let hull = [Interval::new(-1.0, 20.0).unwrap()];
    enclosure.enclose_where_possible(&Rough, &Domain::new(&hull, &[9.5]), &mut w).unwrap();
    assert_eq!(enclosure.offsets()[0], Interval::new(0.0, 20.0).unwrap());
    assert_eq!(enclosure.jacobian()[(0, 0)], 0.0);
    // |x| and sqrt(x) within their ranges and ln(x - 10) in reach say nothing new in a zero row; 1 / x says nothing at all.
    enclosure.rows_into(1, &values, &mut rows).unwrap();
    assert!(rows.ranges().iter().all(|range| !range.is_empty()));
    assert!(rows.ranges().len() < 5);
    assert_eq!(rows.strips().unwrap().len(), rows.ranges().len());
    // A value out of reach of |x| proves that there is no solution.
    let mut set = ConstrainedZonotope::from_box(&[9.5], &[10.5]).unwrap();
    let out_of_reach = [Interval::point(-1.0), Interval::ENTIRE, Interval::ENTIRE, Interval::ENTIRE, Interval::ENTIRE];
    enclosure.intersect(&mut set, &out_of_reach, &mut w).unwrap();
    assert!(set.is_proven_empty(&mut w.sets).unwrap());
}

#[test]
fn sizes_points_and_boxes_are_checked() {
    let mut w = Workspace::new();
    let mut enclosure = AffineEnclosure::new();
    let unit = Interval::new(0.0, 1.0).unwrap();
    let mut enclose = |hull: &[Interval], at: &[f64], p: &[Interval]| {
        enclosure.enclose(Form::Taylor, &Steep, &Domain::new(hull, at).with_parameters(p), &mut w).unwrap_err()
    };
    assert_eq!(
        enclose(&[unit; 2], &[0.5], &[]),
        BoundError::Dimension { operand: Operand::Hull, expected: 1, found: 2 }
    );
    assert_eq!(
        enclose(&[unit], &[], &[]),
        BoundError::Dimension { operand: Operand::ExpansionPoint, expected: 1, found: 0 }
    );
    assert_eq!(
        enclose(&[unit], &[0.5], &[unit]),
        BoundError::Dimension { operand: Operand::Parameters, expected: 0, found: 1 }
    );
    assert_eq!(
        enclose(&[unit], &[f64::NAN], &[]),
        BoundError::NonFinite { operand: Operand::ExpansionPoint, index: 0 }
    );
    assert_eq!(
        enclose(&[Interval::EMPTY], &[0.5], &[]),
        BoundError::EmptyInterval { operand: Operand::Hull, index: 0 }
    );
    assert_eq!(enclose(&[Interval::ENTIRE], &[0.5], &[]), BoundError::NonFinite { operand: Operand::Hull, index: 0 });
    let steep = [Interval::new(0.0, 100.0).unwrap()];
    assert_eq!(enclose(&steep, &[50.0], &[]), BoundError::UnboundedResult { output: 0 });
}

#[test]
fn sets_are_unchanged_after_an_error() {
    let mut w = Workspace::new();
    let mut enclosure = AffineEnclosure::new();
    let unit = Interval::new(0.0, 1.0).unwrap();
    enclosure.enclose(Form::Taylor, &Steep, &Domain::new(&[unit], &[0.5]), &mut w).unwrap();
    let start = ConstrainedZonotope::from_box(&[0.5, 0.5], &[0.5, 0.5]).unwrap();
    let mut set = start.clone();
    assert!(matches!(enclosure.image_in_place(&mut set, &mut w), Err(BoundError::Dimension { .. })));
    assert!(matches!(enclosure.intersect(&mut set, &[unit], &mut w), Err(BoundError::Dimension { .. })));
    let start = ConstrainedZonotope::from_box(&[0.5], &[1e308]).unwrap();
    let mut set = start.clone();
    // The image overflows.
    assert!(matches!(enclosure.image_in_place(&mut set, &mut w), Err(BoundError::Set(SetError::Overflow { .. }))));
    assert!(matches!(enclosure.intersect(&mut set, &[unit; 2], &mut w), Err(BoundError::Dimension { .. })));
    assert!(matches!(
        enclosure.intersect(&mut set, &[Interval::EMPTY], &mut w),
        Err(BoundError::EmptyInterval { operand: Operand::Outputs, index: 0 })
    ));
    assert_eq!(set, start);
}

#[test]
fn empty_sets_have_no_image() {
    let mut w = Workspace::new();
    let row = Matrix::from_rows(&[&[1.0]]).unwrap();
    let empty =
        ConstrainedZonotope::new(&[0.0], &Matrix::identity(1), &row, &[Interval::new(2.0, 3.0).unwrap()]).unwrap();
    let image = affine_image(Form::Taylor, &Steep, &empty, Expansion::HullCenter, &[], &mut w);
    assert_eq!(image.unwrap_err(), SetError::EmptySet.into());
    let solution = affine_solution(Form::Taylor, &Steep, &empty, &[Interval::ONE], Expansion::HullCenter, &[], &mut w);
    assert_eq!(solution.unwrap_err(), SetError::EmptySet.into());
}

/// Strips of outputs: what does not fit is refused, a gradient without bounds gives no direction, an output without values no strip.
#[test]
fn strips_of_outputs() {
    let mut w = Workspace::new();
    let mut strip = OutputStrip::new();
    let hull = [Interval::new(-1.0, 1.0).unwrap()];
    strip.enclose(&Rough, 0, &hull, 1, &[], Interval::ONE, &mut w).unwrap();
    assert_eq!(strip.predicted(), Interval::new(0.0, 1.0).unwrap());
    let before = strip.clone();
    let mut refused = |i, hull: &[Interval], states, p: &[Interval], value| {
        let error = strip.enclose(&Rough, i, hull, states, p, value, &mut Workspace::new()).unwrap_err();
        assert_eq!(strip, before);
        error
    };
    assert!(matches!(
        refused(5, &hull, 1, &[], Interval::ONE),
        BoundError::Dimension { operand: Operand::Outputs, .. }
    ));
    assert!(matches!(refused(0, &[], 1, &[], Interval::ONE), BoundError::Dimension { operand: Operand::Hull, .. }));
    assert!(matches!(
        refused(0, &[Interval::ENTIRE], 1, &[], Interval::ONE),
        BoundError::NonFinite { operand: Operand::Hull, .. }
    ));
    assert!(matches!(
        refused(0, &hull, 2, &[], Interval::ONE),
        BoundError::Dimension { operand: Operand::Variables, .. }
    ));
    assert!(matches!(
        refused(0, &hull, 1, &hull, Interval::ONE),
        BoundError::Dimension { operand: Operand::Parameters, .. }
    ));
    assert!(matches!(
        refused(1, &hull, 1, &[], Interval::EMPTY),
        BoundError::EmptyInterval { operand: Operand::Outputs, index: 1 }
    ));
    assert_eq!(refused(4, &hull, 1, &[], Interval::ONE), SetError::EmptySet.into());
    // A pole: no direction, no bound.
    strip.enclose(&Rough, 2, &hull, 1, &[], Interval::ONE, &mut w).unwrap();
    assert_eq!((strip.direction(), strip.range()), (&[0.0][..], Interval::ENTIRE));
}

/// An output without values refutes what was seen of it, and says nothing where nothing was seen.
#[test]
fn rows_of_outputs_without_values() {
    let (mut w, mut enclosure, mut rows) = (Workspace::new(), AffineEnclosure::new(), Rows::new());
    let hull = [Interval::new(1.0, 2.0).unwrap()];
    enclosure.enclose_where_possible(&Rough, &Domain::new(&hull, &[1.5]), &mut w).unwrap();
    let mut values = [Interval::ENTIRE; 5];
    enclosure.rows_into(1, &values, &mut rows).unwrap();
    assert!(rows.ranges().is_empty());
    values[3] = Interval::ONE;
    enclosure.rows_into(1, &values, &mut rows).unwrap();
    assert_eq!(rows.outputs(), [3]);
    values[4] = Interval::ONE;
    assert_eq!(enclosure.rows_into(1, &values, &mut rows), Err(SetError::EmptySet.into()));
    assert_eq!(rows.outputs(), [3]);
}
