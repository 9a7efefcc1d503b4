//! [`Rk4`]: the classical Runge-Kutta step of order four.

use scalars::Scalar;

use super::discrete_model;
use crate::buffer::with_zeros;
use crate::{BoundError, Function};

/// `y = x + h/6 (k_1 + 2 k_2 + 2 k_3 + k_4)`: variables `(x, w)`, parameters `(p, h)`.
///
/// `k_1 = f(x)`, `k_2 = f(x + h/2 k_1)`, `k_3 = f(x + h/2 k_2)`, `k_4 = f(x + h k_3)`. Derivatives go through the stages by the chain rule.
/// Up to 64 variables need no allocation.
///
/// **Guarantee:** the discrete model itself; nothing is claimed about the differential equation.
/// **Source:** paper 001, section 5.1.
///
/// ```
/// use nonlin_bounds::{DynFunction, Rk4, function};
/// let model = Rk4::new(function!(|[x]: 1| -> 1 { [-x] }))?;
/// let mut y = [0.0];
/// model.value(&[1.0], &[0.1], &mut y)?;
/// assert!((y[0] - (-0.1_f64).exp()).abs() < 1e-7);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Rk4<F> {
    field: F,
}

discrete_model!(Rk4);

impl<F: Function> Rk4<F> {
    fn step<S: Scalar>(&self, x: &[S], p: &[S], step: S, y: &mut [S]) {
        let n = y.len();
        let (half, sixth) = (step.scale(0.5), step * S::ratio(1, 6));
        with_zeros(x.len(), |stage| {
            with_zeros(n, |slope| {
                stage.copy_from_slice(x);
                y.fill(S::zero());
                // The share of each slope in the sum, and the step from x to the stage after it.
                for (share, reach) in [(1.0, half), (2.0, half), (2.0, step)] {
                    self.field.eval(stage, p, slope);
                    for i in 0..n {
                        y[i] += slope[i].scale(share);
                        stage[i] = x[i] + reach * slope[i];
                    }
                }
                self.field.eval(stage, p, slope);
                for i in 0..n {
                    y[i] = x[i] + sixth * (y[i] + slope[i]);
                }
            });
        });
    }
}
