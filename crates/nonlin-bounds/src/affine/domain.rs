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
    reach: Option<&'a [Interval]>,
    noises: usize,
}

impl<'a> Domain<'a> {
    /// The box `hull` and the expansion point `at`; no parameters, no noises.
    ///
    /// The middle of the box is the best point for every form but in special cases: it makes the remainders least.
    #[must_use]
    pub fn new(hull: &'a [Interval], at: &'a [f64]) -> Self {
        Self { hull, at, parameters: &[], reach: None, noises: 0 }
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

    /// The same, where remainders of affine enclosures bound `x - gamma` by `reach - gamma` with a box `reach` around `hull`; derivatives are
    /// still taken over `hull`. Only ever looser: for comparison with methods that know a wider box of the set than its hull.
    ///
    /// With the box of the zonotope that is left when all constraints are eliminated, the mean value form has the `P` of the paper.
    ///
    /// **Source:** paper 003, Theorem 1 and Remark 2.
    #[must_use]
    pub fn with_reach(self, reach: &'a [Interval]) -> Self {
        Self { reach: Some(reach), ..self }
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
        if let Some(reach) = self.reach {
            BoundError::check_box(Operand::Hull, n, reach)?;
        }
        match self.at.iter().position(|x| !x.is_finite()) {
            Some(index) => Err(BoundError::NonFinite { operand: Operand::ExpansionPoint, index }),
            None => Ok(()),
        }
    }

    /// Writes `x - gamma` for `x` in the box, or in the wider one that was given.
    pub(crate) fn steps_into(&self, steps: &mut Vec<Interval>) {
        steps.clear();
        steps.extend(self.hull.iter().zip(self.at).map(|(side, &x)| side.add_f64(-x)));
        if let Some(reach) = self.reach {
            for ((step, side), &x) in steps.iter_mut().zip(reach).zip(self.at) {
                *step = step.hull(side.add_f64(-x));
            }
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
