//! The planar model of papers 003 and 004 with its Jacobian as a computer algebra system prints it.

use nonlin_bounds::{BoundError, DynFunction, Jet, Operand, Order, Smoothness};
use scalars::{Interval, Scalar};

/// `f` of paper 003 (15) and 004 (13), without noise: `f_1 = 3 x_1 - x_1^2 / 7 - 4 x_1 x_2 / (4 + x_1)`,
/// `f_2 = -2 x_2 + 3 x_1 x_2 / (4 + x_1)`, with
///
/// `[3 - 2 x_1 / 7 - 4 x_2 / (4 + x_1) + 4 x_1 x_2 / (4 + x_1)^2, -4 x_1 / (4 + x_1)]` and
/// `[3 x_2 / (4 + x_1) - 3 x_1 x_2 / (4 + x_1)^2, 3 x_1 / (4 + x_1) - 2]`
///
/// in natural interval arithmetic: the variables occur several times, so the ranges are wider than the derivatives. The tables of
/// paper 004 fit this form.
#[derive(Debug, Clone, Copy, Default)]
pub struct CasPlanar;

fn value<S: Scalar>(x1: S, x2: S) -> [S; 2] {
    let share = x1 / x1.add_f64(4.0);
    [x1.scale(3.0) - x1.sqr() * S::ratio(1, 7) - share.scale(4.0) * x2, x2.scale(-2.0) + share.scale(3.0) * x2]
}

impl DynFunction for CasPlanar {
    fn variables(&self) -> usize {
        2
    }

    fn parameters(&self) -> usize {
        0
    }

    fn outputs(&self) -> usize {
        2
    }

    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        for (operand, expected, found) in
            [(Operand::Variables, 2, x.len()), (Operand::Parameters, 0, p.len()), (Operand::Outputs, 2, y.len())]
        {
            check(operand, expected, found)?;
        }
        y.copy_from_slice(&value(x[0], x[1]));
        Ok(())
    }

    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        check(Operand::Variables, 2, x.len())?;
        check(Operand::Parameters, 0, p.len())?;
        if order == Order::Hessian {
            return Err(BoundError::OrderNotAvailable { order: 2 });
        }
        if let Some(index) = x.iter().position(Interval::is_empty) {
            return Err(BoundError::EmptyInterval { operand: Operand::Variables, index });
        }
        if let Some(index) = x.iter().position(|side| !side.is_bounded()) {
            return Err(BoundError::NonFinite { operand: Operand::Variables, index });
        }
        jet.reset(order, 2, 2);
        let (x1, x2) = (x[0], x[1]);
        let pole = x1.add_f64(4.0);
        let (values, jacobian, _, smoothness) = jet.parts_mut();
        if pole.contains(0.0) {
            return Ok(());
        }
        values.copy_from_slice(&value(x1, x2));
        smoothness.fill(Smoothness::C2);
        if order == Order::Jacobian {
            let product = x1 * x2;
            let seventh = Interval::ratio(2, 7);
            jacobian[0] = Interval::point(3.0) - x1 * seventh - x2.scale(4.0) / pole + product.scale(4.0) / pole.sqr();
            jacobian[1] = x1.scale(-4.0) / pole;
            jacobian[2] = x2.scale(3.0) / pole - product.scale(3.0) / pole.sqr();
            jacobian[3] = x1.scale(3.0) / pole - Interval::point(2.0);
        }
        Ok(())
    }
}

fn check(operand: Operand, expected: usize, found: usize) -> Result<(), BoundError> {
    if expected == found { Ok(()) } else { Err(BoundError::Dimension { operand, expected, found }) }
}
