//! The functions of the figures.

use nonlin_bounds::Function;
use scalars::Scalar;

/// The map of paper 003 (15), `f_1 = 3 x_1 - x_1^2 / 7 - 4 x_1 x_2 / (4 + x_1)`, `f_2 = -2 x_2 + 3 x_1 x_2 / (4 + x_1)`.
///
/// Written with `x_1 / (4 + x_1) = 1 - 4 / (4 + x_1)`, so that derivatives hold each variable nearly once.
#[derive(Debug, Clone, Copy, Default)]
pub struct Planar;

impl Function for Planar {
    const VARIABLES: Option<usize> = Some(2);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let share = x[1] / x[0].add_f64(4.0);
        y[0] = x[0].scale(3.0) - x[0].sqr() * S::ratio(1, 7) - x[1].scale(4.0) + share.scale(16.0);
        y[1] = x[1] - share.scale(12.0);
    }
}

/// The invariant of Figure 4 of paper 003, `h = x_1^2 + x_2^2 - 1`.
#[derive(Debug, Clone, Copy, Default)]
pub struct UnitCircle;

impl Function for UnitCircle {
    const VARIABLES: Option<usize> = Some(2);

    fn outputs(&self) -> usize {
        1
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sqr() + x[1].sqr().add_f64(-1.0);
    }
}

/// `h = x_1 x_2 - 1`: the counterexample to Lemma 2 of paper 003 as printed.
#[derive(Debug, Clone, Copy, Default)]
pub struct UnitProduct;

impl Function for UnitProduct {
    const VARIABLES: Option<usize> = Some(2);

    fn outputs(&self) -> usize {
        1
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = (x[0] * x[1]).add_f64(-1.0);
    }
}
