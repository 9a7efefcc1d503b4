//! [`Structured`]: a function whose Hessians take as few passes as its structure allows.

use std::sync::Arc;

use scalars::Interval;

use crate::derivative::{Plan, enclose_by_plan};
use crate::{BoundError, DynFunction, Function, Jet, Order, Tape};

/// A function with a plan for its Hessians: variables that meet in no second derivative share a pass, and those in which every output is
/// affine (additive noises) need first derivatives only. The structure is that of the function's [`Tape`]; the derivatives are those of
/// the function itself.
///
/// Hessians of `n` variables take `O(n^2)` passes in general; for a chain in which every variable is curved by itself `n / 8`.
///
/// **Guarantee:** as [`DynFunction::enclose`]: an entry without structural reason to be other than zero is zero.
///
/// ```
/// use nonlin_bounds::{DynFunction, Jet, Order, Structured, function};
/// use scalars::Interval;
///
/// let f = Structured::new(function!(|[x, y, w]: 3| -> 1 { [x.sqr() + y.sin() + w] }));
/// let (mut jet, at) = (Jet::new(), [Interval::ONE; 3]);
/// f.enclose(Order::Hessian, &at, &[], &mut jet)?;
/// assert_eq!((jet.hessians()[0].mid(), jet.hessians()[1]), (2.0, Interval::ZERO));
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Structured<F> {
    function: F,
    tape: Arc<Tape>,
    plan: Option<Plan>,
}

impl<F: Function> Structured<F> {
    /// Records a function and plans its passes.
    #[must_use]
    pub fn new(function: F) -> Self {
        let tape = Tape::record(&function);
        let plan = Plan::of(&tape.curvature());
        Self { function, tape: Arc::new(tape), plan }
    }

    /// The tape.
    #[must_use]
    pub fn tape(&self) -> &Arc<Tape> {
        &self.tape
    }
}

impl<F: Function> DynFunction for Structured<F> {
    fn variables(&self) -> usize {
        Function::variables(&self.function)
    }

    fn parameters(&self) -> usize {
        Function::parameters(&self.function)
    }

    fn outputs(&self) -> usize {
        Function::outputs(&self.function)
    }

    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        DynFunction::value(&self.function, x, p, y)
    }

    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        match &self.plan {
            Some(plan) if order == Order::Hessian => enclose_by_plan(&self.function, plan, x, p, jet),
            _ => DynFunction::enclose(&self.function, order, x, p, jet),
        }
    }
}
