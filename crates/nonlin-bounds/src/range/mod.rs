//! Ranges `{ f(x, p) : x in [x], p in [p] }` of functions over boxes; one method a file.
//!
//! Notation: `c` the midpoint of the box, `z = x - c`, `J` the Jacobian and `H` the Hessian of an output over the box.

mod mean_value;
mod mixed_monotone;
mod natural;
mod parabola;
mod second_order;
mod slope;
mod tight;

use scalars::Interval;
pub(crate) use tight::enclose_as_far_as_possible;

use crate::function::evaluate;
use crate::signs::Signs;
use crate::{BoundError, DynFunction, Jet, Operand, Order, Smoothness, Workspace};

/// How a range is enclosed; the box needs the smoothness that is named.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum RangeMethod {
    /// The body of the function in interval arithmetic; no smoothness needed. Points where the function is not defined have no value.
    Natural,
    /// `f(c) + J z`; `C1`. The excess falls with the square of the width.
    MeanValue,
    /// `f(c) + (J(c) + z'H / 2) z`; `C2`. For quadratics the slope matrix is exact but for rounding: half the excess of the mean value form.
    Slope,
    /// Lagrange's remainder with one-sided squares, each parabola bounded as a whole; `C2`. Exact but for rounding for sums of functions
    /// `a x_j^2 + b x_j` of one variable each.
    SecondOrder,
    /// Two corners of the box for each choice of signs, after the least linear function that makes an output monotone; `C1`. Exact but for
    /// rounding for outputs that are monotone in every variable.
    MixedMonotone,
    /// The intersection of all methods that the function is smooth enough for, output by output, with coordinates of one-signed
    /// derivative pinned.
    #[default]
    Tight,
}

/// Buffers of [`range`].
#[derive(Debug, Default, Clone)]
pub(crate) struct Scratch {
    /// The function over the box.
    over: Jet,
    /// The function at `point`.
    at: Jet,
    point: Vec<Interval>,
    /// `x - point`.
    offsets: Vec<Interval>,
    /// The ranges found.
    bounds: Vec<Interval>,
    signs: Signs,
}

/// Encloses the range of every output over the box `x`, for all parameters in the box `p`; shapes `x: n`, `p: q`, `y: m`.
///
/// Allocates nothing in steady state.
///
/// **Guarantee:** `y_i` contains `f_i(x, p)` for every `x`, `p` of the boxes at which it is defined; rounding included.
/// **Source:** Moore, Kearfott, Cloud, *Introduction to Interval Analysis* (2009), chapter 6; for mixed-monotone ranges Khajenejad and Yong,
/// *Tight Remainder-Form Decomposition Functions* (2021).
///
/// # Errors
/// [`BoundError::Dimension`], [`BoundError::EmptyInterval`], [`BoundError::NonFinite`]; [`BoundError::NotSmooth`] if the method needs more
/// than is proven, or if an output is defined nowhere on the box; [`BoundError::OrderNotAvailable`] if it needs derivatives that the function
/// does not offer; [`BoundError::UnboundedResult`] at a pole. `y` is then unchanged.
///
/// ```
/// use nonlin_bounds::{Function, RangeMethod, Workspace, range};
/// use scalars::{Interval, Scalar};
///
/// struct Product;
/// impl Function for Product {
///     const VARIABLES: Option<usize> = Some(2);
///     fn outputs(&self) -> usize {
///         1
///     }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
///         y[0] = x[0] * x[1] - x[0];
///     }
/// }
/// let x = [Interval::new(0.0, 1.0)?, Interval::new(1.0, 2.0)?];
/// let (mut workspace, mut y) = (Workspace::new(), [Interval::ZERO]);
/// range(&Product, &x, &[], RangeMethod::Natural, &mut workspace, &mut y)?;
/// assert!(y[0].contains(-1.0) && y[0].contains(2.0) && y[0].width() < 3.0 + 1e-14);
/// range(&Product, &x, &[], RangeMethod::Tight, &mut workspace, &mut y)?;
/// assert!(y[0].contains(0.0) && y[0].contains(1.0) && y[0].width() < 1.0 + 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn range(
    f: &dyn DynFunction,
    x: &[Interval],
    p: &[Interval],
    method: RangeMethod,
    workspace: &mut Workspace,
    y: &mut [Interval],
) -> Result<(), BoundError> {
    BoundError::check_box(Operand::Variables, f.variables(), x)?;
    BoundError::check_box(Operand::Parameters, f.parameters(), p)?;
    BoundError::check_size(Operand::Outputs, f.outputs(), y.len())?;
    let scratch = &mut workspace.range;
    scratch.bounds.clear();
    scratch.bounds.resize(y.len(), Interval::ENTIRE);
    match method {
        RangeMethod::Natural => {
            evaluate(f, Order::Value, x, p, &mut scratch.over)?;
            scratch.keep(natural::range);
        }
        RangeMethod::MeanValue => {
            scratch.expand(f, x, p, Order::Jacobian)?;
            scratch.keep(mean_value::range);
        }
        RangeMethod::Slope => {
            scratch.expand(f, x, p, Order::Hessian)?;
            scratch.keep(slope::range);
        }
        RangeMethod::SecondOrder => {
            scratch.expand(f, x, p, Order::Hessian)?;
            scratch.keep(second_order::range);
        }
        RangeMethod::MixedMonotone => {
            evaluate(f, Order::Jacobian, x, p, &mut scratch.over)?;
            BoundError::check_smooth(&scratch.over, Smoothness::C1)?;
            (0..y.len()).try_for_each(|i| mixed_monotone::tighten(f, x, p, i, scratch))?;
        }
        RangeMethod::Tight => tight::tighten(f, x, p, scratch)?,
    }
    if let Some(output) = scratch.bounds.iter().position(|bound| !bound.is_bounded()) {
        let (required, found) = (Smoothness::Defined, Smoothness::Undefined);
        let nowhere = scratch.bounds[output].is_empty();
        return Err(if nowhere {
            BoundError::NotSmooth { output, required, found }
        } else {
            BoundError::UnboundedResult { output }
        });
    }
    y.copy_from_slice(&scratch.bounds);
    Ok(())
}

impl Scratch {
    /// Derivatives up to `order` over the box, which must prove them continuous, and one order less at its midpoint.
    fn expand(&mut self, f: &dyn DynFunction, x: &[Interval], p: &[Interval], order: Order) -> Result<(), BoundError> {
        evaluate(f, order, x, p, &mut self.over)?;
        let (required, below) =
            if order == Order::Hessian { (Smoothness::C2, Order::Jacobian) } else { (Smoothness::C1, Order::Value) };
        BoundError::check_smooth(&self.over, required)?;
        self.expand_about(f, x, p, below, Interval::mid)
    }

    /// The function up to `order` at the point of the box that `choose` takes of every side.
    fn expand_about(
        &mut self,
        f: &dyn DynFunction,
        x: &[Interval],
        p: &[Interval],
        order: Order,
        choose: impl Fn(&Interval) -> f64,
    ) -> Result<(), BoundError> {
        self.point.clear();
        self.point.extend(x.iter().map(|side| Interval::point(choose(side))));
        self.offsets.clear();
        self.offsets.extend(x.iter().zip(&self.point).map(|(side, c)| *side - *c));
        evaluate(f, order, &self.point, p, &mut self.at)
    }

    /// Intersects the range of every output with what a method finds.
    fn keep(&mut self, method: impl Fn(&Self, usize) -> Interval) {
        for i in 0..self.bounds.len() {
            self.bounds[i] = self.bounds[i].intersection(method(self, i));
        }
    }

    /// The gradient of output `i` over the box.
    fn gradient(&self, i: usize) -> &[Interval] {
        let n = self.over.variables();
        &self.over.jacobian()[i * n..(i + 1) * n]
    }

    /// The gradient of output `i` at the point.
    fn gradient_at(&self, i: usize) -> &[Interval] {
        let n = self.at.variables();
        &self.at.jacobian()[i * n..(i + 1) * n]
    }

    /// Second derivative of output `i` by `x_j` and `x_k` over the box.
    fn second(&self, i: usize, j: usize, k: usize) -> Interval {
        let n = self.over.variables();
        let (j, k) = (j.min(k), j.max(k));
        // Entries of row r of the triangle: n - r.
        self.over.hessians()[i * (n * (n + 1) / 2) + (j * (2 * n - j + 1)) / 2 + (k - j)]
    }
}
