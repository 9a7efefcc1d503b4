//! [`Euler`]: the explicit Euler step.

use scalars::Scalar;

use super::discrete_model;
use crate::{BoundError, Function};

/// `y = x + h f(x, w, p)`: variables `(x, w)`, parameters `(p, h)`.
///
/// The step `h` is the last parameter, so that it may be a number that is no `f64` (an interval) and may change from call to call.
///
/// **Guarantee:** the discrete model itself; nothing is claimed about the differential equation.
///
/// ```
/// use nonlin_bounds::{DynFunction, Euler, function};
/// let model = Euler::new(function!(|[x]: 1| -> 1 { [-x] }))?;
/// let mut y = [0.0];
/// model.value(&[1.0], &[0.25], &mut y)?;
/// assert_eq!(y, [0.75]);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Euler<F> {
    field: F,
}

discrete_model!(Euler);

impl<F: Function> Euler<F> {
    fn step<S: Scalar>(&self, x: &[S], p: &[S], step: S, y: &mut [S]) {
        self.field.eval(x, p, y);
        for (y, &x) in y.iter_mut().zip(x) {
            *y = x + step * *y;
        }
    }
}
