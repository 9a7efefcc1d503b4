//! The intersection of all methods that apply.

use scalars::Interval;

use super::{Scratch, mean_value, mixed_monotone, natural, second_order, slope};
use crate::function::evaluate;
use crate::{BoundError, DynFunction, Jet, Order, Smoothness};

/// Bounds every output by all methods for which derivatives are available and proven continuous.
///
/// Beyond the single methods the gradient over the box is intersected with `J(c) + H z`, and where some coordinates have a derivative of one
/// sign, the second-order form is taken over the two faces of the box on which the output has its extremes.
pub(super) fn tighten(
    f: &dyn DynFunction,
    x: &[Interval],
    p: &[Interval],
    scratch: &mut Scratch,
) -> Result<(), BoundError> {
    let order = enclose_as_far_as_possible(f, x, p, &mut scratch.over)?;
    scratch.keep(natural::range);
    let is_c1 = |scratch: &Scratch, i: usize| scratch.over.smoothness()[i] >= Smoothness::C1;
    let is_c2 = |scratch: &Scratch, i: usize| order == Order::Hessian && scratch.over.smoothness()[i] >= Smoothness::C2;
    if order == Order::Value || !(0..scratch.bounds.len()).any(|i| is_c1(scratch, i)) {
        return Ok(());
    }
    let below = if order == Order::Hessian { Order::Jacobian } else { Order::Value };
    scratch.expand_about(f, x, p, below, Interval::mid)?;
    for i in 0..scratch.bounds.len() {
        if is_c2(scratch, i) {
            sharpen_gradient(i, scratch);
            let bound = slope::range(scratch, i).intersection(second_order::range(scratch, i));
            scratch.bounds[i] = scratch.bounds[i].intersection(bound);
        }
        if is_c1(scratch, i) {
            scratch.bounds[i] = scratch.bounds[i].intersection(mean_value::range(scratch, i));
        }
    }
    for i in 0..scratch.bounds.len() {
        if is_c1(scratch, i) {
            mixed_monotone::tighten(f, x, p, i, scratch)?;
        }
        if is_c2(scratch, i) {
            bound_over_faces(f, x, p, i, scratch)?;
        }
    }
    Ok(())
}

/// Encloses the function over the box with the highest derivatives that it offers.
pub(crate) fn enclose_as_far_as_possible(
    f: &dyn DynFunction,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<Order, BoundError> {
    for order in [Order::Hessian, Order::Jacobian] {
        match evaluate(f, order, x, p, jet) {
            Err(BoundError::OrderNotAvailable { .. }) => {}
            Err(error) => return Err(error),
            Ok(()) => return Ok(order),
        }
    }
    evaluate(f, Order::Value, x, p, jet)?;
    Ok(Order::Value)
}

/// Intersects the gradient of output `i` over the box with its own mean value form `J(c) + H z`.
fn sharpen_gradient(i: usize, scratch: &mut Scratch) {
    let n = scratch.offsets.len();
    for j in 0..n {
        let start = scratch.gradient_at(i)[j];
        let expanded = (0..n).fold(start, |sum, k| sum + scratch.second(i, j, k) * scratch.offsets[k]);
        let entry = &mut scratch.over.parts_mut().1[i * n + j];
        *entry = entry.intersection(expanded);
    }
}

/// The second-order form about the midpoints of the two faces on which output `i` is least and largest, if some but not all of its derivatives
/// have one sign.
fn bound_over_faces(
    f: &dyn DynFunction,
    x: &[Interval],
    p: &[Interval],
    i: usize,
    scratch: &mut Scratch,
) -> Result<(), BoundError> {
    let n = x.len();
    let one_signed = |slope: &Interval| slope.lo() >= 0.0 || slope.hi() <= 0.0;
    let pinned = scratch.gradient(i).iter().filter(|slope| one_signed(slope)).count();
    if pinned == 0 || pinned == n {
        return Ok(());
    }
    let mut face = |least: bool| {
        scratch.point.clear();
        scratch.offsets.clear();
        for (j, side) in x.iter().enumerate() {
            let slope = scratch.over.jacobian()[i * n + j];
            let at = match (one_signed(&slope), (slope.lo() >= 0.0) == least) {
                (false, _) => side.mid(),
                (true, true) => side.lo(),
                (true, false) => side.hi(),
            };
            scratch.point.push(Interval::point(at));
            scratch.offsets.push(if one_signed(&slope) { Interval::ZERO } else { *side - Interval::point(at) });
        }
        evaluate(f, Order::Jacobian, &scratch.point, p, &mut scratch.at)?;
        Ok::<_, BoundError>(second_order::range(scratch, i))
    };
    let bound = face(true)?.hull(face(false)?);
    scratch.bounds[i] = scratch.bounds[i].intersection(bound);
    Ok(())
}
