//! Rows of `J` and `[e]` from the evaluations over the box and at the expansion point.

use core::ops::Range;

use scalars::Interval;

use super::{Domain, Form, mean_value, natural, slope, taylor};
use crate::function::evaluate;
use crate::{BoundError, DynFunction, Jet, Order, Workspace};

/// Whether no entry of the Hessian of an output is unbounded.
pub(super) fn has_bounded_hessian(jet: &Jet, output: usize) -> bool {
    let size = jet.variables() * (jet.variables() + 1) / 2;
    jet.hessians()[output * size..(output + 1) * size].iter().all(Interval::is_bounded)
}

/// Writes `J` and `[e]` of some outputs to the workspace, given the evaluation over the box there; `form` says how each is to be enclosed.
pub(super) fn fit(
    f: &dyn DynFunction,
    domain: &Domain<'_>,
    at_point: Order,
    outputs: Range<usize>,
    form: impl Fn(&Jet, usize) -> Form,
    workspace: &mut Workspace,
) -> Result<(), BoundError> {
    let (n, states) = (f.variables(), domain.states());
    let Workspace {
        over_box, at_point: point_jet, noise_at_point, point, steps, slopes, row, jacobian, offsets, ..
    } = workspace;
    point.clear();
    point.extend(domain.at.iter().map(|&x| Interval::point(x)));
    evaluate(f, at_point, point, domain.parameters, point_jet)?;
    let nested = states < n && outputs.clone().any(|i| form(over_box, i) == Form::MeanValue);
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
    jacobian.reset(outputs.len(), n);
    offsets.clear();
    for (line, i) in outputs.enumerate() {
        offsets.push(match form(parts.over_box, i) {
            Form::Natural => natural::row(&parts, i, row),
            Form::MeanValue => mean_value::row(&parts, i, row),
            Form::Slope => slope::row(&parts, i, row, slopes),
            Form::Taylor => taylor::row(&parts, i, row),
        });
        for (k, &entry) in row.iter().enumerate() {
            jacobian[(line, k)] = entry;
        }
    }
    Ok(())
}

/// What the rows of `J` and `[e]` are made of.
pub(super) struct Parts<'a> {
    /// Derivatives over the box.
    pub(super) over_box: &'a Jet,
    /// Derivatives at the expansion point.
    pub(super) at_point: &'a Jet,
    /// Derivatives with the states at the expansion point and the noises in the box, if they are used.
    pub(super) noise_at_point: Option<&'a Jet>,
    /// Number of variables that are states.
    pub(super) states: usize,
    /// `d = H - gamma`.
    pub(super) steps: &'a [Interval],
}

impl Parts<'_> {
    /// Row `i` of the Jacobian over the box; empty if the function offers none.
    pub(super) fn gradient_over_box(&self, i: usize) -> &[Interval] {
        let n = self.steps.len();
        self.over_box.jacobian().get(i * n..(i + 1) * n).unwrap_or_default()
    }

    /// Row `i` of the Jacobian at the expansion point.
    pub(super) fn gradient_at_point(&self, i: usize) -> &[Interval] {
        let n = self.steps.len();
        self.at_point.jacobian().get(i * n..(i + 1) * n).unwrap_or_default()
    }

    /// The packed Hessian of output `i` over the box.
    pub(super) fn hessian(&self, i: usize) -> &[Interval] {
        let size = self.steps.len() * (self.steps.len() + 1) / 2;
        self.over_box.hessians().get(i * size..(i + 1) * size).unwrap_or_default()
    }

    /// `sum_k (S_k - J_k) d_k`: what a row `S` of slopes adds to the offset of output `i` for the row `J`.
    pub(super) fn spread<'a>(&self, slopes: impl Iterator<Item = &'a Interval>, row: &[f64]) -> Interval {
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
pub(super) fn midpoints<'a>(slopes: impl Iterator<Item = &'a Interval>, row: &mut [f64]) {
    for (entry, slope) in row.iter_mut().zip(slopes) {
        *entry = if slope.is_bounded() { slope.mid() } else { 0.0 };
    }
}
