//! Functions made of functions: one after the other, and side by side.

use scalars::Scalar;

use crate::buffer::with_zeros;
use crate::{BoundError, Function, Operand};

/// `x -> g(f(x, p), r)`; the parameters are those of `f`, then those of `g`. Made by [`then`].
#[derive(Debug, Clone, Copy)]
pub struct Then<F, G> {
    first: F,
    second: G,
}

/// `x -> (f(x, p), g(x, r))`; the parameters are those of `f`, then those of `g`. Made by [`stack`].
#[derive(Debug, Clone, Copy)]
pub struct Stack<F, G> {
    first: F,
    second: G,
}

/// The composition `x -> g(f(x, p), r)`.
///
/// Derivatives are those of the composed function, by the chain rule over intervals; up to 64 values between the two need no allocation.
///
/// # Errors
/// [`BoundError::Dimension`] unless `g` has as many variables as `f` has outputs.
///
/// ```
/// use nonlin_bounds::{DynFunction, function, then};
/// let polar = function!(|[x, y]: 2| -> 2 { [(x.sqr() + y.sqr()).sqrt(), y.atan2(x)] });
/// let sine = function!(|[_, angle]: 2| -> 1 { [angle.sin()] });
/// let mut y = [0.0];
/// then(polar, sine)?.value(&[3.0, 4.0], &[], &mut y)?;
/// assert!((y[0] - 0.8).abs() < 1e-15);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
pub fn then<F: Function, G: Function>(first: F, second: G) -> Result<Then<F, G>, BoundError> {
    BoundError::check_size(Operand::Variables, second.variables(), first.outputs())?;
    Ok(Then { first, second })
}

/// Two functions of the same variables, the outputs of the second below those of the first.
///
/// # Errors
/// [`BoundError::Dimension`] unless both have the same number of variables.
///
/// ```
/// use nonlin_bounds::{Function, function, stack};
/// let norm = function!(|[x, y]: 2| -> 1 { [x.sqr() + y.sqr()] });
/// let swapped = function!(|[x, y]: 2| -> 2 { [y, x] });
/// assert_eq!(stack(norm, swapped)?.outputs(), 3);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
pub fn stack<F: Function, G: Function>(first: F, second: G) -> Result<Stack<F, G>, BoundError> {
    BoundError::check_size(Operand::Variables, first.variables(), second.variables())?;
    Ok(Stack { first, second })
}

impl<F: Function, G: Function> Function for Then<F, G> {
    const VARIABLES: Option<usize> = F::VARIABLES;
    fn variables(&self) -> usize {
        self.first.variables()
    }
    fn parameters(&self) -> usize {
        self.first.parameters() + self.second.parameters()
    }
    fn outputs(&self) -> usize {
        self.second.outputs()
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        let (p, r) = p.split_at(self.first.parameters());
        with_zeros(self.first.outputs(), |between| {
            self.first.eval(x, p, between);
            self.second.eval(between, r, y);
        });
    }
}

impl<F: Function, G: Function> Function for Stack<F, G> {
    const VARIABLES: Option<usize> = F::VARIABLES;
    fn variables(&self) -> usize {
        self.first.variables()
    }
    fn parameters(&self) -> usize {
        self.first.parameters() + self.second.parameters()
    }
    fn outputs(&self) -> usize {
        self.first.outputs() + self.second.outputs()
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        let (p, r) = p.split_at(self.first.parameters());
        let (upper, lower) = y.split_at_mut(self.first.outputs());
        self.first.eval(x, p, upper);
        self.second.eval(x, r, lower);
    }
}

impl<F: Function> Function for &F {
    const VARIABLES: Option<usize> = F::VARIABLES;
    fn variables(&self) -> usize {
        (**self).variables()
    }
    fn parameters(&self) -> usize {
        (**self).parameters()
    }
    fn outputs(&self) -> usize {
        (**self).outputs()
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        (**self).eval(x, p, y);
    }
}
