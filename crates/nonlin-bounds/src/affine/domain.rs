//! [`Domain`]: where a function is enclosed.

use scalars::Interval;

use crate::function::evaluate;
use crate::{BoundError, DynFunction, Operand, Order, Workspace};

/// Where a function `f(x, p)` is enclosed: a box of its variables, an expansion point, the parameters, and which of the variables are
/// noises. Derivatives are taken over the box and, if it lies outside, the point.
#[derive(Debug, Clone, Copy)]
pub struct Domain<'a> {
    pub(crate) hull: &'a [Interval],
    pub(crate) at: &'a [f64],
    pub(crate) parameters: &'a [Interval],
    noises: usize,
}

impl<'a> Domain<'a> {
    /// The box `hull` and the expansion point `at`; no parameters, no noises.
    ///
    /// The middle of the box is the best point for every form but in special cases: it makes the remainders least.
    #[must_use]
    pub fn new(hull: &'a [Interval], at: &'a [f64]) -> Self {
        Self { hull, at, parameters: &[], noises: 0 }
    }

    /// The same with parameters `p`, which may have a width.
    #[must_use]
    pub fn with_parameters(self, parameters: &'a [Interval]) -> Self {
        Self { parameters, ..self }
    }

    /// The same, where the last `noises` variables are noises `w` (or `v`): the mean value form then takes derivatives by them with the
    /// states at the expansion point, so that functions affine in the noises, `phi(x) + Phi(x) w`, are enclosed exactly in `w`.
    ///
    /// `f(x, w) = f(gamma) + f_w(gamma_x, W) (w - gamma_w) + f_x(X, W) (x - gamma_x)`.
    ///
    /// **Source:** paper 003, Propositions 1 and 3 with Remarks 4, 6 and 8.
    #[must_use]
    pub fn with_noises(self, noises: usize) -> Self {
        Self { noises, ..self }
    }

    /// The number of variables that are not noises.
    pub(crate) fn states(&self) -> usize {
        self.hull.len().saturating_sub(self.noises)
    }

    /// `Ok` if box, point and parameters fit the function.
    pub(crate) fn check(&self, f: &dyn DynFunction) -> Result<(), BoundError> {
        let n = f.variables();
        BoundError::check_box(Operand::Hull, n, self.hull)?;
        BoundError::check_size(Operand::ExpansionPoint, n, self.at.len())?;
        BoundError::check_size(Operand::Parameters, f.parameters(), self.parameters.len())?;
        match self.at.iter().position(|x| !x.is_finite()) {
            Some(index) => Err(BoundError::NonFinite { operand: Operand::ExpansionPoint, index }),
            None => Ok(()),
        }
    }

    /// Evaluates `f` over the box and the expansion point to the workspace.
    pub(crate) fn evaluate(
        &self,
        f: &dyn DynFunction,
        order: Order,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let Workspace { point, over_box, .. } = workspace;
        point.clear();
        point.extend(self.hull.iter().zip(self.at).map(|(side, &x)| side.hull(Interval::point(x))));
        evaluate(f, order, point, self.parameters, over_box)
    }
}
