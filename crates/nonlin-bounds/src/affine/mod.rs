//! [`AffineEnclosure`]: a function between two parallel affine functions on a box.

mod domain;
mod mean_value;
mod natural;
mod slope;
mod taylor;

pub use domain::Domain;
use scalars::Interval;
use setrep::Matrix;

use crate::function::evaluate;
use crate::{BoundError, DynFunction, Jet, Operand, Order, Smoothness, Workspace};

/// How a function is enclosed by an affine one. With `gamma` the expansion point, `H` the box, `d = H - gamma`:
///
/// | form | `J` | `[e]` | needs |
/// |---|---|---|---|
/// | `Natural` | `mid f'(H)` | `f(H) - J d` | defined |
/// | `MeanValue` | `mid f'(H)` | `f(gamma) + (f'(H) - J) d` | C1 |
/// | `Slope` | `mid S` | `f(gamma) + (S - J) d`, `S = f'(gamma) + d' f''(H) / 2` | C2 |
/// | `Taylor` | `mid f'(gamma)` | `f(gamma) + (f'(gamma) - J) d + sum_k h_kk d_k^2 / 2 + sum_{j<k} h_jk d_j d_k` | C2 |
///
/// Take `Taylor` where Hessians are at hand: its remainder is of second order in the box and one-sided (`d_k^2 >= 0`), about the middle
/// of the hull a quarter as wide as the mean value form's for `x^2` and never wider than the slope form's. `Slope` gains where the
/// expansion point is far from the middle. `MeanValue` needs no Hessian. `Natural` needs nothing and keeps what it has of dependencies.
///
/// **Source:** Taylor: Lagrange's remainder; mean value: paper 003, Lemma 1; natural: paper 001, (30)-(33).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// The range on the box against the mean gradient.
    Natural,
    /// The mean value theorem.
    MeanValue,
    /// A slope matrix from the Hessians, exact for quadratics.
    Slope,
    /// Taylor's theorem of first order with its remainder.
    Taylor,
}

impl Form {
    /// The derivatives over the box and at the expansion point.
    fn orders(self) -> (Order, Order) {
        match self {
            Self::Natural | Self::MeanValue => (Order::Jacobian, Order::Value),
            Self::Slope | Self::Taylor => (Order::Hessian, Order::Jacobian),
        }
    }

    /// The smoothness that the form needs of an output.
    fn needs(self) -> Smoothness {
        match self {
            Self::Natural => Smoothness::Defined,
            Self::MeanValue => Smoothness::C1,
            Self::Slope | Self::Taylor => Smoothness::C2,
        }
    }
}

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
        domain.check(f)?;
        let (order, at_point) = form.orders();
        domain.evaluate(f, order, workspace)?;
        BoundError::check_smooth(&workspace.over_box, form.needs())?;
        fit(f, domain, at_point, |_, _| form, workspace)?;
        if let Some(output) = workspace.offsets.iter().position(|e| !e.is_bounded()) {
            return Err(BoundError::UnboundedResult { output });
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
        fit(f, domain, at_point, best, workspace)?;
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

/// Whether no entry of the Hessian of an output is unbounded.
fn has_bounded_hessian(jet: &Jet, output: usize) -> bool {
    let size = jet.variables() * (jet.variables() + 1) / 2;
    jet.hessians()[output * size..(output + 1) * size].iter().all(Interval::is_bounded)
}

/// Writes `J` and `[e]` to the workspace, given the evaluation over the box there; `form` says how each output is to be enclosed.
fn fit(
    f: &dyn DynFunction,
    domain: &Domain<'_>,
    at_point: Order,
    form: impl Fn(&Jet, usize) -> Form,
    workspace: &mut Workspace,
) -> Result<(), BoundError> {
    let (n, m, states) = (f.variables(), f.outputs(), domain.states());
    let Workspace {
        over_box, at_point: point_jet, noise_at_point, point, steps, slopes, row, jacobian, offsets, ..
    } = workspace;
    point.clear();
    point.extend(domain.at.iter().map(|&x| Interval::point(x)));
    evaluate(f, at_point, point, domain.parameters, point_jet)?;
    let nested = states < n && (0..m).any(|i| form(over_box, i) == Form::MeanValue);
    if nested {
        for (x, side) in point.iter_mut().zip(domain.hull).skip(states) {
            *x = x.hull(*side);
        }
        evaluate(f, Order::Jacobian, point, domain.parameters, noise_at_point)?;
    }
    domain.steps_into(steps);
    let parts = Parts {
        over_box,
        at_point: point_jet,
        noise_at_point: nested.then_some(&*noise_at_point),
        states,
        steps: steps.as_slice(),
    };
    row.clear();
    row.resize(n, 0.0);
    jacobian.reset(m, n);
    offsets.clear();
    for i in 0..m {
        offsets.push(match form(parts.over_box, i) {
            Form::Natural => natural::row(&parts, i, row),
            Form::MeanValue => mean_value::row(&parts, i, row),
            Form::Slope => slope::row(&parts, i, row, slopes),
            Form::Taylor => taylor::row(&parts, i, row),
        });
        for (k, &entry) in row.iter().enumerate() {
            jacobian[(i, k)] = entry;
        }
    }
    Ok(())
}

/// What the rows of `J` and `[e]` are made of.
struct Parts<'a> {
    /// Derivatives over the box.
    over_box: &'a Jet,
    /// Derivatives at the expansion point.
    at_point: &'a Jet,
    /// Derivatives with the states at the expansion point and the noises in the box, if they are used.
    noise_at_point: Option<&'a Jet>,
    /// Number of variables that are states.
    states: usize,
    /// `d = H - gamma`.
    steps: &'a [Interval],
}

impl Parts<'_> {
    /// Row `i` of the Jacobian over the box; empty if the function offers none.
    fn gradient_over_box(&self, i: usize) -> &[Interval] {
        let n = self.steps.len();
        self.over_box.jacobian().get(i * n..(i + 1) * n).unwrap_or_default()
    }

    /// Row `i` of the Jacobian at the expansion point.
    fn gradient_at_point(&self, i: usize) -> &[Interval] {
        let n = self.steps.len();
        self.at_point.jacobian().get(i * n..(i + 1) * n).unwrap_or_default()
    }

    /// The packed Hessian of output `i` over the box.
    fn hessian(&self, i: usize) -> &[Interval] {
        let size = self.steps.len() * (self.steps.len() + 1) / 2;
        self.over_box.hessians().get(i * size..(i + 1) * size).unwrap_or_default()
    }

    /// `sum_k (S_k - J_k) d_k`: what a row `S` of slopes adds to the offset of output `i` for the row `J`.
    fn spread<'a>(&self, slopes: impl Iterator<Item = &'a Interval>, row: &[f64]) -> Interval {
        let mut sum = Interval::ZERO;
        for ((slope, &middle), &step) in slopes.zip(row).zip(self.steps) {
            let rest = slope.add_f64(-middle);
            if rest != Interval::ZERO {
                sum += rest * step;
            }
        }
        sum
    }
}

/// Midpoints of a row of slopes; 0 for what is unbounded.
fn midpoints<'a>(slopes: impl Iterator<Item = &'a Interval>, row: &mut [f64]) {
    for (entry, slope) in row.iter_mut().zip(slopes) {
        *entry = if slope.is_bounded() { slope.mid() } else { 0.0 };
    }
}
