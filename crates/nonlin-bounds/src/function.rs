//! [`Function`], what a user writes, and [`DynFunction`], what the enclosures take.

use scalars::{Interval, Scalar};

use crate::derivative;
use crate::{BoundError, Jet, Operand};

/// A function `y = f(x, p)`, `R^n x R^q -> R^m`, written once for every number type.
///
/// `x` are the variables: what a set is about, and what derivatives are taken by (states and noises stacked). `p` are the parameters:
/// known numbers, inputs, times, which cost no derivatives; over intervals a parameter may have a width. Dimensions are values, so
/// that a model may be of any size.
///
/// The body must not branch on values. Constants that are not `f64` numbers enter as `S::ratio(1, 7)`, `S::decimal("0.1")`, `S::pi()`.
pub trait Function {
    /// The number of variables where it is a constant of the type. Code is then compiled only for the passes that so many variables take, not for
    /// each width of pass. A function of any size leaves it out and implements [`variables`](Self::variables); the compiler refuses one
    /// that does neither.
    const VARIABLES: Option<usize> = None;
    /// Number `n` of variables.
    fn variables(&self) -> usize {
        const {
            match Self::VARIABLES {
                Some(n) => n,
                // Seen by the compiler only, never at run time.
                None => panic!("a Function needs VARIABLES or variables()"),
            }
        }
    }
    /// Number `q` of parameters.
    fn parameters(&self) -> usize {
        0
    }
    /// Number `m` of outputs.
    fn outputs(&self) -> usize;
    /// Writes `f(x, p)` to `y`; the slices have the lengths `n`, `q` and `m`.
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]);
}

/// Highest derivatives asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Order {
    /// The range only.
    Value,
    /// The range and the Jacobian.
    Jacobian,
    /// The range, the Jacobian and the Hessians.
    Hessian,
}

/// The object-safe twin of [`Function`], implemented for every one of them.
///
/// A user whose code runs over `f64` only, but who can bound its Jacobian, implements it by hand and refuses
/// [`Order::Hessian`] with [`BoundError::OrderNotAvailable`].
pub trait DynFunction {
    /// Number `n` of variables.
    fn variables(&self) -> usize;
    /// Number `q` of parameters.
    fn parameters(&self) -> usize;
    /// Number `m` of outputs.
    fn outputs(&self) -> usize;
    /// `f(x, p)` in floating point: for simulation and for choosing points, not a bound.
    ///
    /// # Errors
    /// [`BoundError::Dimension`].
    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError>;
    /// Encloses value and derivatives up to `order` over the box `x` for all parameters in `p`, and says how smooth each output is
    /// proven to be there. Derivatives of an output that is not smooth enough for them are the whole line, except by variables it does not
    /// depend on.
    ///
    /// **Guarantee:** every entry of the jet contains the exact quantity at every point of the box at which it exists.
    ///
    /// # Errors
    /// [`BoundError::Dimension`], [`BoundError::EmptyInterval`], [`BoundError::NonFinite`] for an unbounded interval,
    /// [`BoundError::OrderNotAvailable`].
    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError>;
}

impl<F: Function> DynFunction for F {
    fn variables(&self) -> usize {
        Function::variables(self)
    }

    fn parameters(&self) -> usize {
        Function::parameters(self)
    }

    fn outputs(&self) -> usize {
        Function::outputs(self)
    }

    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        BoundError::check_size(Operand::Variables, Function::variables(self), x.len())?;
        BoundError::check_size(Operand::Parameters, Function::parameters(self), p.len())?;
        BoundError::check_size(Operand::Outputs, Function::outputs(self), y.len())?;
        self.eval(x, p, y);
        Ok(())
    }

    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        derivative::enclose(self, order, x, p, jet)
    }
}

/// [`f.enclose`](DynFunction::enclose) for whoever implemented `f`: the jet then has the right shape, and what `f` did not write is the
/// whole line, nothing proven.
pub(crate) fn evaluate(
    f: &dyn DynFunction,
    order: Order,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    let (n, m) = (f.variables(), f.outputs());
    jet.reset(order, n, m);
    f.enclose(order, x, p, jet)?;
    // Derivatives of a higher order than asked for do no harm.
    let gradient = if order >= Order::Jacobian { m * n } else { 0 };
    let hessian = if order >= Order::Hessian { m * (n * (n + 1) / 2) } else { 0 };
    BoundError::check_size(Operand::Variables, n, jet.variables())?;
    BoundError::check_size(Operand::Outputs, m, jet.outputs())?;
    BoundError::check_size(Operand::Outputs, gradient, jet.jacobian().len().min(gradient))?;
    BoundError::check_size(Operand::Outputs, hessian, jet.hessians().len().min(hessian))
}
