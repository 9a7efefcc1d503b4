//! [`Heun`]: the explicit trapezoidal step.

use scalars::Scalar;

use super::discrete_model;
use crate::buffer::with_zeros;
use crate::{BoundError, Function};

/// `y = x + h/2 (k_1 + k_2)` with `k_1 = f(x)`, `k_2 = f(x + h k_1)`: variables `(x, w)`, parameters `(p, h)`.
///
/// Derivatives go through the stages by the chain rule. Up to 64 variables need no allocation.
///
/// **Guarantee:** the discrete model itself; nothing is claimed about the differential equation.
#[derive(Debug, Clone, Copy)]
pub struct Heun<F> {
    field: F,
}

discrete_model!(Heun);

impl<F: Function> Heun<F> {
    fn step<S: Scalar>(&self, x: &[S], p: &[S], step: S, y: &mut [S]) {
        let n = y.len();
        let half = step.scale(0.5);
        with_zeros(x.len(), |stage| {
            with_zeros(n, |slope| {
                self.field.eval(x, p, slope);
                stage.copy_from_slice(x);
                for i in 0..n {
                    y[i] = x[i] + half * slope[i];
                    stage[i] = x[i] + step * slope[i];
                }
                self.field.eval(stage, p, slope);
                for i in 0..n {
                    y[i] += half * slope[i];
                }
            });
        });
    }
}
