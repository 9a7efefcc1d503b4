//! Bad input is a typed error.

use nonlin_bounds::{
    BoundError, Expansion, Function, Operand, Smoothness, Workspace, function, polytopic_image, polytopic_solution,
};
use scalars::{Interval, Scalar};
use setrep::{HPolytope, IntervalVector, Matrix, SetError, VPolytope};

/// `m` copies of `x_1^2 + k x_2`, or of a function that is not smooth, or has a pole at zero.
struct Copies {
    kind: usize,
    outputs: usize,
}

impl Function for Copies {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        self.outputs
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (k, y) in y.iter_mut().enumerate() {
            *y = x[1].scale(k as f64)
                + match self.kind {
                    0 => x[0].sqr(),
                    1 => x[0].abs(),
                    _ => x[0].recip(),
                };
        }
    }
}

fn square() -> VPolytope {
    VPolytope::from_intervals(&IntervalVector::from_center(&[0.0; 2], &[1.0; 2]).unwrap()).unwrap()
}

fn image(kind: usize, outputs: usize, set: &VPolytope, at: &[f64]) -> Result<VPolytope, BoundError> {
    polytopic_image(&Copies { kind, outputs }, set, Expansion::Point(at), &[], &mut Workspace::new())
}

#[test]
fn sizes_and_points_are_checked() {
    let line = VPolytope::from_intervals(&[Interval::ONE]).unwrap();
    let wrong = |operand, expected, found| Err(BoundError::Dimension { operand, expected, found });
    assert_eq!(image(0, 1, &line, &[0.0]), wrong(Operand::Variables, 2, 1));
    assert_eq!(image(0, 1, &square(), &[0.0]), wrong(Operand::ExpansionPoint, 2, 1));
    let infinite = image(0, 1, &square(), &[0.0, f64::INFINITY]);
    assert_eq!(infinite, Err(BoundError::NonFinite { operand: Operand::ExpansionPoint, index: 1 }));
    let y = HPolytope::from_intervals(&[Interval::ONE; 2]).unwrap();
    let g = Copies { kind: 0, outputs: 1 };
    let found = polytopic_solution(&g, &square(), &y, Expansion::SetCenter, &[], &mut Workspace::new());
    assert_eq!(found, wrong(Operand::Outputs, 1, 2));
    let p = polytopic_image(&g, &square(), Expansion::HullCenter, &[Interval::ONE], &mut Workspace::new());
    assert_eq!(p, wrong(Operand::Parameters, 0, 1));
}

#[test]
fn functions_that_are_not_smooth_are_refused() {
    let error = image(1, 1, &square(), &[0.0; 2]);
    assert_eq!(error, Err(BoundError::NotSmooth { output: 0, required: Smoothness::C1, found: Smoothness::C0 }));
    let pole = image(2, 2, &square(), &[0.5, 0.0]);
    assert_eq!(pole, Err(BoundError::NotSmooth { output: 0, required: Smoothness::C1, found: Smoothness::Undefined }));
    // Beside the pole.
    let right = VPolytope::new(Matrix::from_columns(&[&[1.0, 0.0], &[2.0, 0.0]]).unwrap()).unwrap();
    assert_eq!(image(2, 1, &right, &[-1.0, 0.0]), Err(BoundError::OutsideHull { index: 0 }));
    assert!(image(2, 1, &right, &[1.5, 0.0]).is_ok());
}

#[test]
fn overflow_and_too_many_corners_are_refused() {
    let far = VPolytope::new(Matrix::from_columns(&[&[1e200, 0.0], &[-1e200, 0.0]]).unwrap()).unwrap();
    assert!(matches!(image(0, 1, &far, &[0.0; 2]), Err(BoundError::UnboundedResult { output: 0 })));
    assert!(matches!(image(0, 16, &square(), &[0.0; 2]), Err(BoundError::Set(SetError::OverBudget { .. }))));
}

#[test]
fn a_contradiction_is_proven() {
    let y = HPolytope::from_intervals(&[Interval::new(7.0, 8.0).unwrap()]).unwrap();
    let g = Copies { kind: 0, outputs: 1 };
    let set = square();
    let found = polytopic_solution(&g, &set, &y, Expansion::HullCenter, &[], &mut Workspace::new());
    assert_eq!(found, Err(SetError::EmptySet.into()));
}

/// A row that has no lower bound at a vertex cuts nothing.
#[test]
fn a_row_without_a_bound_is_no_constraint() {
    let steep = function!(|[x]: 1| -> 1 { [x.scale(1e200)] });
    let set = VPolytope::new(Matrix::from_columns(&[&[-1e200], &[1e200]]).unwrap()).unwrap();
    let y = HPolytope::from_intervals(&[Interval::new(0.0, 1.0).unwrap()]).unwrap();
    let found = polytopic_solution(&steep, &set, &y, Expansion::HullCenter, &[], &mut Workspace::new()).unwrap();
    assert_eq!(found.interval_hull(), set.interval_hull());
}

/// An image without coordinates is no polytope.
#[test]
fn a_function_without_outputs_has_no_polytope() {
    let none = function!(|[_x]: 1| -> 0 { [] });
    let set = VPolytope::from_intervals(&[Interval::ONE]).unwrap();
    let image = polytopic_image(&none, &set, Expansion::HullCenter, &[], &mut Workspace::new());
    assert!(matches!(image, Err(BoundError::Set(SetError::ZeroDimension { .. }))), "{image:?}");
}
