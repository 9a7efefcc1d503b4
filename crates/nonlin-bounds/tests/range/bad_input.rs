//! Functions that are not smooth, poles, wrong sizes, NaN: typed errors, and the target as it was.

use nonlin_bounds::{
    BoundError, DynFunction, Function, Jet, Operand, Order, RangeMethod, Smoothness, Workspace, range,
};
use scalars::{Interval, Scalar};

use super::{METHODS, interval, range_of};

/// A function of one variable that is `C1` at most: the second output has a kink at zero, the third a pole, the fourth starts at zero.
struct Rough(usize);

impl Function for Rough {
    const VARIABLES: Option<usize> = Some(1);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = match self.0 {
            0 => x[0].sqr() - x[0],
            1 => x[0].abs(),
            2 => x[0].recip(),
            _ => x[0].sqrt(),
        };
    }
}

/// A function whose author offers no derivatives beyond an order.
struct Limited(Order);

impl DynFunction for Limited {
    fn variables(&self) -> usize {
        1
    }
    fn parameters(&self) -> usize {
        0
    }
    fn outputs(&self) -> usize {
        1
    }
    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        DynFunction::value(&Rough(0), x, p, y)
    }
    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        if order > self.0 {
            return Err(BoundError::OrderNotAvailable { order: order as usize });
        }
        Rough(0).enclose(order, x, p, jet)
    }
}

#[test]
fn methods_ask_for_the_smoothness_they_need() {
    let x = [interval(-1.0, 2.0)];
    for method in METHODS {
        let result = range_of(&Rough(1), &x, method);
        match method {
            RangeMethod::Natural | RangeMethod::Tight => assert_eq!(result.unwrap(), [interval(0.0, 2.0)]),
            _ => {
                let second = matches!(method, RangeMethod::Slope | RangeMethod::SecondOrder);
                let required = if second { Smoothness::C2 } else { Smoothness::C1 };
                assert_eq!(
                    result,
                    Err(BoundError::NotSmooth { output: 0, required, found: Smoothness::C0 }),
                    "{method:?}"
                );
            }
        }
    }
}

#[test]
fn poles_and_domains() {
    for method in METHODS {
        let result = range_of(&Rough(2), &[interval(-1.0, 1.0)], method);
        match method {
            RangeMethod::Natural | RangeMethod::Tight => {
                assert_eq!(result, Err(BoundError::UnboundedResult { output: 0 }));
            }
            _ => {
                assert!(
                    matches!(result, Err(BoundError::NotSmooth { found: Smoothness::Undefined, .. })),
                    "{method:?}"
                );
            }
        }
        // Partly outside of the domain: the values there are, and no derivatives.
        let result = range_of(&Rough(3), &[interval(-1.0, 4.0)], method);
        match method {
            RangeMethod::Natural | RangeMethod::Tight => {
                let y = result.unwrap()[0];
                assert!(interval(0.0, 2.0).subset_of(&y) && y.width() < 2.0 + 1e-15);
            }
            _ => {
                assert!(
                    matches!(result, Err(BoundError::NotSmooth { found: Smoothness::Undefined, .. })),
                    "{method:?}"
                );
            }
        }
        // Outside of it.
        let result = range_of(&Rough(3), &[interval(-4.0, -1.0)], method);
        assert!(matches!(result, Err(BoundError::NotSmooth { output: 0, .. })), "{method:?} {result:?}");
    }
}

#[test]
fn fewer_derivatives() {
    // x^2 - x on [1, 2]: in [0, 2], naturally in [-1, 3].
    let x = [interval(1.0, 2.0)];
    for (available, tight) in [(Order::Value, 4.0), (Order::Jacobian, 2.0), (Order::Hessian, 2.0)] {
        let f = Limited(available);
        let y = range_of(&f, &x, RangeMethod::Tight).unwrap()[0];
        assert!((y.width() - tight).abs() < 1e-12, "{available:?} {y:?}");
        for (method, needs) in [(RangeMethod::MeanValue, Order::Jacobian), (RangeMethod::Slope, Order::Hessian)] {
            match range_of(&f, &x, method) {
                Ok(_) => assert!(needs <= available),
                Err(error) => {
                    assert!(needs > available);
                    assert_eq!(error, BoundError::OrderNotAvailable { order: needs as usize });
                }
            }
        }
    }
}

#[test]
fn wrong_arguments() {
    let f = Rough(0);
    let mut workspace = Workspace::new();
    for method in METHODS {
        let mut error = |x: &[Interval], p: &[Interval], outputs: usize| {
            let mut y = vec![interval(7.0, 8.0); outputs];
            let error = range(&f, x, p, method, &mut workspace, &mut y).unwrap_err();
            assert!(y.iter().all(|y| *y == interval(7.0, 8.0)), "an error leaves the target alone");
            error
        };
        let one = [interval(0.0, 1.0)];
        let dimension = |operand, expected, found| BoundError::Dimension { operand, expected, found };
        assert_eq!(error(&[], &[], 1), dimension(Operand::Variables, 1, 0));
        assert_eq!(error(&one, &one, 1), dimension(Operand::Parameters, 0, 1));
        assert_eq!(error(&one, &[], 2), dimension(Operand::Outputs, 1, 2));
        let (operand, index) = (Operand::Variables, 0);
        assert_eq!(error(&[Interval::EMPTY], &[], 1), BoundError::EmptyInterval { operand, index });
        // A bound that was not a number.
        assert_eq!(error(&[Interval::point(f64::NAN)], &[], 1), BoundError::NonFinite { operand, index });
        assert_eq!(error(&[interval(0.0, f64::INFINITY)], &[], 1), BoundError::NonFinite { operand, index });
        // The square overflows.
        assert_eq!(error(&[interval(1e200, 1e201)], &[], 1), BoundError::UnboundedResult { output: 0 });
    }
}
