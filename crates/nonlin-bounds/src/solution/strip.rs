//! [`OutputStrip`]: what one output says of the states, with the range on the box evaluated apart from the linear part.

use scalars::Interval;
use setrep::SetError;

use crate::function::evaluate;
use crate::{BoundError, DynFunction, Operand, Order, Workspace};

/// A strip `a'x in [d]` that holds every solution of one equation `g_i(x, v, p) in Y_i` in a box `H` of states and noises:
///
/// ```text
/// a = mid of the gradient of g_i by x over H,    [d] = Y_i + a'H_x - g_i(H),
/// ```
///
/// for `a'x = Y_i + a'x - g_i(x, v)`. It needs no smoothness beyond that of the gradient, where that is unbounded `a` is 0. The two terms in
/// `H` are evaluated apart, so for a function near an affine one the strip is twice as wide as the row of
/// [`Form::Natural`](crate::Form::Natural) without noises, and a box is hardly ever cut by it at all; noises count once. It is here for the
/// estimators of the literature; take [`AffineEnclosure::rows_into`](crate::AffineEnclosure::rows_into) for tight rows.
///
/// ```
/// use nonlin_bounds::{OutputStrip, Workspace, function};
/// use scalars::Interval;
///
/// let square = function!(|[x, v]: 2| -> 1 { [x.sqr() + v] });
/// let hull = [Interval::new(1.0, 3.0)?, Interval::new(-0.5, 0.5)?];
/// let mut strip = OutputStrip::new();
/// strip.enclose(&square, 0, &hull, 1, &[], Interval::ONE, &mut Workspace::new())?;
/// assert!((strip.direction()[0] - 4.0).abs() < 1e-14);
/// // 4 x lies in 1 + [4, 12] - [1/2, 19/2].
/// assert!(strip.range().lo() > -4.5 - 1e-13 && strip.range().hi() < 12.5 + 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct OutputStrip {
    direction: Vec<f64>,
    range: Interval,
    predicted: Interval,
}

impl Default for OutputStrip {
    fn default() -> Self {
        Self { direction: Vec::new(), range: Interval::ENTIRE, predicted: Interval::ENTIRE }
    }
}

impl OutputStrip {
    /// No strip, to be overwritten.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The direction `a`.
    #[must_use]
    pub fn direction(&self) -> &[f64] {
        &self.direction
    }

    /// The range `[d]`; unbounded on a side where `Y_i` or the output is.
    #[must_use]
    pub fn range(&self) -> Interval {
        self.range
    }

    /// The range `g_i(H)` of the output; disjoint from `Y_i` only if there is no solution.
    #[must_use]
    pub fn predicted(&self) -> Interval {
        self.predicted
    }

    /// The strip of output `i` of `g` over the box `hull`, of which the first `states` sides are those of `x`.
    ///
    /// **Guarantee:** `a'x` lies in `[d]` for every `x` in the box for which noises in the box have `g_i(x, v, p)` in `value`; rounding
    /// included.
    /// **Source:** Alamo, Bravo, Camacho 2005, as used in paper 003, Section 5; paper 001, (30)-(33) with the whole range for the residual.
    ///
    /// # Errors
    /// Sizes, an empty or unbounded box, an empty `value`, an output that does not exist ([`BoundError::Dimension`]), what `g` reports;
    /// [`SetError::EmptySet`] if the output is defined nowhere on the box. The strip is then unchanged.
    #[allow(clippy::too_many_arguments, reason = "an equation is a function, an output, a box and a value")]
    pub fn enclose(
        &mut self,
        g: &dyn DynFunction,
        i: usize,
        hull: &[Interval],
        states: usize,
        p: &[Interval],
        value: Interval,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let n = g.variables();
        BoundError::check_box(Operand::Hull, n, hull)?;
        BoundError::check_size(Operand::Parameters, g.parameters(), p.len())?;
        BoundError::check_size(Operand::Variables, n.min(states), states)?;
        if i >= g.outputs() {
            return Err(BoundError::Dimension { operand: Operand::Outputs, expected: i + 1, found: g.outputs() });
        }
        if value.is_empty() {
            return Err(BoundError::EmptyInterval { operand: Operand::Outputs, index: i });
        }
        let jet = &mut workspace.over_box;
        match evaluate(g, Order::Jacobian, hull, p, jet) {
            Err(BoundError::OrderNotAvailable { .. }) => evaluate(g, Order::Value, hull, p, jet)?,
            result => result?,
        }
        let predicted = jet.values()[i];
        if predicted.is_empty() {
            return Err(SetError::EmptySet.into());
        }
        self.direction.clear();
        self.direction.resize(states, 0.0);
        // A function without Jacobian leaves the direction zero.
        let gradient = jet.jacobian().get(i * n..i * n + states).unwrap_or_default();
        self.range = value - predicted;
        for ((a, slope), side) in self.direction.iter_mut().zip(gradient).zip(hull) {
            if slope.is_bounded() {
                *a = slope.mid();
                self.range += side.scale(*a);
            }
        }
        self.predicted = predicted;
        Ok(())
    }
}
