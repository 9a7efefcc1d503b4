//! The mean value extension: Propositions 1 and 3, Corollary 1.
//!
//! With `J` an enclosure of `f_x(H, W)` and `gamma` in `H`: `f(x, w) in f(gamma_x, w) + mid J (x - gamma_x) + P B`. The paper's `P` is that of
//! its Theorem 1, with the zonotope that is left when all constraints are eliminated; the hull gives a smaller one. The noise enters with
//! the states at `gamma`, so that functions affine in it are enclosed exactly in `w` (Remarks 4, 6 and 8). With `mid J` for the free matrix of
//! Proposition 3 an update appends one row an output: `P`, rounding and a box of noises widen its range.

use nonlin_bounds::Form;
use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

use super::options::{CzOptions, Extension};
use super::scratch::{Scratch, forget_noises};
use crate::EstimatorError;
use crate::set_filter::{Equation, is_box, store};
use crate::system::Relation;

/// Image of a set in `hull` under the dynamics: Proposition 1.
pub(super) fn image(
    (dynamics, noise): (&Relation, &Zonotope),
    options: &CzOptions,
    parameters: &[Interval],
    (set, hull): (&mut ConstrainedZonotope, &[Interval]),
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let Scratch { bounds, enclosure, place, .. } = scratch;
    place.choose(options, Extension::MeanValue, (&*set, hull), Some(noise), bounds)?;
    enclosure.enclose_at_best(Form::MeanValue, dynamics.function(), &place.domain(parameters), bounds)?;
    set.product_assign_zonotope(noise);
    Ok(enclosure.image_in_place(set, bounds)?)
}

/// Cuts a set in `hull` with the solutions of an equation: Proposition 3 for measurements, Corollary 1 for invariants.
///
/// A one-sided or missing value is a one-sided row, or none; so is an output without a derivative or a bound on the hull.
pub(super) fn cut(
    equation: &Equation<'_>,
    options: &CzOptions,
    (set, hull): (&mut ConstrainedZonotope, &[Interval]),
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let Scratch { bounds, enclosure, rows, place, product, map, culprits, .. } = scratch;
    place.choose(options, Extension::MeanValue, (&*set, hull), equation.noise, bounds)?;
    let domain = place.domain(equation.parameters);
    enclosure.enclose_at_best(Form::MeanValue, equation.relation.function(), &domain, bounds)?;
    match equation.noise.filter(|noise| !is_box(noise)) {
        None => {
            enclosure.rows_into(hull.len(), equation.values, rows)?;
            rows.intersect(set, bounds)?;
        }
        // Noises that mix the outputs keep their generators: the set is stacked with them, cut, and projected.
        Some(noise) => {
            let product = store(product, set);
            product.product_assign_zonotope(noise);
            enclosure.rows_into(product.dim(), equation.values, rows)?;
            rows.intersect(product, bounds)?;
            forget_noises(hull.len(), product, map, bounds)?;
            core::mem::swap(set, product);
        }
    }
    culprits.extend(rows.outputs().iter().map(|&output| (equation.culprit)(output)));
    Ok(())
}
