//! [`AffineEnclosure`]: a function between two parallel affine functions on a box.

mod domain;
mod fit;
mod form;
mod mean_value;
mod natural;
mod slope;
mod taylor;

use core::ops::Range;

pub use domain::Domain;
use fit::{fit, has_bounded_hessian};
pub use form::Form;
use scalars::Interval;
use setrep::Matrix;

use crate::{BoundError, DynFunction, Jet, Operand, Order, Smoothness, Workspace};

/// An affine enclosure of a function `f` on a box `H` about a point `gamma`: `f(x) - J (x - gamma)` lies in `[e]` for every `x` in
/// `H` and every parameter. Shapes `J: m x n`, `[e]: m` intervals, `gamma: n`, `H: n` intervals.
///
/// Images of sets under `f` and solution sets of `f(x) in Y` are then operations on sets with a real matrix and a box:
/// [`image`](Self::image), [`rows_into`](Self::rows_into), [`intersect`](Self::intersect). Reused from call to
/// call, it allocates nothing in steady state.
///
/// ```
/// use nonlin_bounds::{AffineEnclosure, Domain, Form, Function, Workspace};
/// use scalars::{Interval, Scalar};
///
/// struct Square;
/// impl Function for Square {
///     const VARIABLES: Option<usize> = Some(1);
///     fn outputs(&self) -> usize { 1 }
///     fn eval<S: Scalar>(&self, x: &[S], _p: &[S], y: &mut [S]) { y[0] = x[0].sqr(); }
/// }
/// let hull = [Interval::new(1.0, 3.0).unwrap_or_default()];
/// let mut enclosure = AffineEnclosure::new();
/// enclosure.enclose(Form::Taylor, &Square, &Domain::new(&hull, &[2.0]), &mut Workspace::new())?;
/// // x^2 lies in 4 (x - 2) + [4, 5].
/// assert_eq!(enclosure.jacobian()[(0, 0)], 4.0);
/// assert!(enclosure.offsets()[0].width() < 1.0 + 1e-14);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct AffineEnclosure {
    pub(crate) at: Vec<f64>,
    pub(crate) hull: Vec<Interval>,
    pub(crate) jacobian: Matrix,
    pub(crate) offsets: Vec<Interval>,
}

impl AffineEnclosure {
    /// An enclosure of a function without variables and outputs, to be overwritten.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The expansion point `gamma`.
    #[must_use]
    pub fn at(&self) -> &[f64] {
        &self.at
    }

    /// The box `H` on which the enclosure holds.
    #[must_use]
    pub fn hull(&self) -> &[Interval] {
        &self.hull
    }

    /// The matrix `J`, `m x n`.
    #[must_use]
    pub fn jacobian(&self) -> &Matrix {
        &self.jacobian
    }

    /// The offsets `[e]`: value at the expansion point, remainder and rounding.
    #[must_use]
    pub fn offsets(&self) -> &[Interval] {
        &self.offsets
    }

    /// Number `m` of outputs.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.offsets.len()
    }

    /// Number `n` of variables.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.at.len()
    }

    /// Encloses `f` on the box of `domain` in the given form.
    ///
    /// The mean value, slope and Taylor offsets are cut with those that the evaluation over the box gives for the same `J` (from the
    /// range, and for Taylor from the mean value theorem), which are at hand.
    ///
    /// **Guarantee:** `f(x, p) - J (x - gamma)` lies in `[e]` for every `x` in the box and every `p` in the parameters; derivatives,
    /// remainder and rounding included.
    ///
    /// # Errors
    /// Sizes, an empty or unbounded box, [`BoundError::NotSmooth`] for an output that is not proven as smooth on the box as the form
    /// needs, [`BoundError::UnboundedResult`], and what `f` reports. The enclosure is then unchanged.
    pub fn enclose(
        &mut self,
        form: Form,
        f: &dyn DynFunction,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        self.strictly(form, f, 0..f.outputs(), domain, workspace)
    }

    /// Encloses output `i` of `f` alone, as [`enclose`](Self::enclose) does a function with no other: `J: 1 x n`. Nothing is asked of the
    /// others.
    ///
    /// **Guarantee:** as [`enclose`](Self::enclose).
    ///
    /// # Errors
    /// As [`enclose`](Self::enclose); [`BoundError::Dimension`] for an output that does not exist.
    pub fn enclose_output(
        &mut self,
        form: Form,
        f: &dyn DynFunction,
        i: usize,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        check_output(f, i)?;
        self.strictly(form, f, i..i + 1, domain, workspace)
    }

    /// [`enclose`](Self::enclose) for some of the outputs.
    fn strictly(
        &mut self,
        form: Form,
        f: &dyn DynFunction,
        outputs: Range<usize>,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        domain.check(f)?;
        let (order, at_point) = form.orders();
        domain.evaluate(f, order, workspace)?;
        let (required, smoothness) = (form.needs(), workspace.over_box.smoothness());
        if let Some(output) = outputs.clone().find(|&i| smoothness[i] < required) {
            return Err(BoundError::NotSmooth { output, required, found: smoothness[output] });
        }
        fit(f, domain, at_point, outputs.clone(), |_, _| form, workspace)?;
        if let Some(found) = workspace.offsets.iter().position(|e| !e.is_bounded()) {
            return Err(BoundError::UnboundedResult { output: outputs.start + found });
        }
        self.take(domain, workspace);
        Ok(())
    }

    /// Encloses every output in the best form that its smoothness on the box allows: Taylor, mean value, or the range with a zero row
    /// of `J`. An output that is not defined everywhere on the box is enclosed where it is, one without a finite bound by the whole line.
    ///
    /// Meant for solution sets, where an output without a bound is no constraint; an image needs finite bounds.
    ///
    /// **Guarantee:** as [`enclose`](Self::enclose), for every `x` in the box at which the output is defined.
    ///
    /// # Errors
    /// Sizes, an empty or unbounded box, and what `f` reports. The enclosure is then unchanged.
    pub fn enclose_where_possible(
        &mut self,
        f: &dyn DynFunction,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        self.enclose_at_best(Form::Taylor, f, domain, workspace)
    }

    /// As [`enclose_where_possible`](Self::enclose_where_possible), with `form` as the best form: outputs that are not smooth enough for it
    /// fall back to the mean value form, then to the range.
    ///
    /// **Guarantee:** as [`enclose`](Self::enclose), for every `x` in the box at which the output is defined.
    ///
    /// # Errors
    /// As [`enclose_where_possible`](Self::enclose_where_possible).
    pub fn enclose_at_best(
        &mut self,
        form: Form,
        f: &dyn DynFunction,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        self.at_best(form, f, 0..f.outputs(), domain, workspace)
    }

    /// As [`enclose_at_best`](Self::enclose_at_best) for output `i` alone: `J: 1 x n`.
    ///
    /// **Guarantee:** as [`enclose`](Self::enclose), for every `x` in the box at which the output is defined.
    ///
    /// # Errors
    /// As [`enclose_where_possible`](Self::enclose_where_possible); [`BoundError::Dimension`] for an output that does not exist.
    pub fn enclose_output_at_best(
        &mut self,
        form: Form,
        f: &dyn DynFunction,
        i: usize,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        check_output(f, i)?;
        self.at_best(form, f, i..i + 1, domain, workspace)
    }

    /// [`enclose_at_best`](Self::enclose_at_best) for some of the outputs.
    fn at_best(
        &mut self,
        form: Form,
        f: &dyn DynFunction,
        outputs: Range<usize>,
        domain: &Domain<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        domain.check(f)?;
        let (mut order, _) = form.orders();
        while let Err(error) = domain.evaluate(f, order, workspace) {
            order = match (error, order) {
                (BoundError::OrderNotAvailable { .. }, Order::Hessian) => Order::Jacobian,
                (BoundError::OrderNotAvailable { .. }, Order::Jacobian) => Order::Value,
                (error, _) => return Err(error),
            };
        }
        let best = |jet: &Jet, output: usize| match jet.smoothness()[output] {
            Smoothness::C2 if order == Order::Hessian && has_bounded_hessian(jet, output) => form,
            Smoothness::C1 | Smoothness::C2 if order >= Order::Jacobian && form != Form::Natural => Form::MeanValue,
            _ => Form::Natural,
        };
        let at_point = if order == Order::Hessian { Order::Jacobian } else { Order::Value };
        fit(f, domain, at_point, outputs, best, workspace)?;
        self.take(domain, workspace);
        Ok(())
    }

    /// The range that the enclosure gives: `[e] + J (H - gamma)`, one interval an output, into a slice of length `m`.
    ///
    /// # Errors
    /// [`BoundError::Dimension`].
    pub fn range_into(&self, range: &mut [Interval]) -> Result<(), BoundError> {
        BoundError::check_size(Operand::Outputs, self.outputs(), range.len())?;
        range.copy_from_slice(&self.offsets);
        for (k, column) in self.jacobian.columns().enumerate() {
            let step = self.hull[k].add_f64(-self.at[k]);
            for (side, &j) in range.iter_mut().zip(column) {
                *side += step.scale(j);
            }
        }
        Ok(())
    }

    /// Takes what [`fit`] has left in the workspace.
    fn take(&mut self, domain: &Domain<'_>, workspace: &mut Workspace) {
        self.at.clear();
        self.at.extend_from_slice(domain.at);
        self.hull.clear();
        self.hull.extend_from_slice(domain.hull);
        core::mem::swap(&mut self.jacobian, &mut workspace.jacobian);
        core::mem::swap(&mut self.offsets, &mut workspace.offsets);
    }
}

/// `Ok` if there is such an output.
fn check_output(f: &dyn DynFunction, i: usize) -> Result<(), BoundError> {
    let found = f.outputs();
    if i < found { Ok(()) } else { Err(BoundError::Dimension { operand: Operand::Outputs, expected: i + 1, found }) }
}
