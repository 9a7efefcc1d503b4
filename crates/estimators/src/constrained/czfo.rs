//! The first-order extension: Propositions 2 and 4, Corollary 2.
//!
//! With `z = (x, w)` in `Z = c + G xi` and `gamma` in its hull: `f(z)` lies in `f(gamma) + f'(gamma) (z - gamma) + [e] + K`, where `K` has the
//! products of generators as coordinates and the products of constraints as constraints. See [`QuadraticEnclosure`], which has `L` with a symmetric `Q`:
//! as printed, with an upper triangular one, Lemma 2 does not hold unless `gamma = c`.

use nonlin_bounds::{BoundError, QuadraticEnclosure};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

use super::czmv;
use super::options::{Curvature, CzOptions, Extension};
use super::scratch::{Scratch, forget_noises};
use crate::set_filter::{Equation, is_box, store};
use crate::system::Relation;
use crate::{Culprit, EstimatorError};

/// Image of a set in `hull` under the dynamics: Proposition 2, or Proposition 1 where they are not smooth enough.
pub(super) fn image(
    (dynamics, noise): (&Relation, &Zonotope),
    options: &CzOptions,
    parameters: &[Interval],
    (set, hull): (&mut ConstrainedZonotope, &[Interval]),
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    if !enclose((dynamics, Some(noise)), |_| true, options, parameters, (&*set, hull), scratch)? {
        return czmv::image((dynamics, noise), options, parameters, (set, hull), scratch);
    }
    let Scratch { bounds, quadratic, .. } = scratch;
    if let Some(quadratic) = quadratic {
        set.product_assign_zonotope(noise);
        quadratic.image_in_place(set, bounds)?;
    }
    Ok(())
}

/// Cuts a set in `hull` with the solutions of an equation: Proposition 4 for measurements, Corollary 2 for invariants; as
/// [`czmv::cut`] where the function is not smooth or bounded enough. Outputs without a value need be neither.
pub(super) fn cut(
    equation: &Equation<'_>,
    options: &CzOptions,
    (set, hull): (&mut ConstrainedZonotope, &[Interval]),
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let says = |i: usize| equation.values[i] != Interval::ENTIRE;
    if !(0..equation.values.len()).any(says) {
        return Ok(());
    }
    if !enclose((equation.relation, equation.noise), says, options, equation.parameters, (&*set, hull), scratch)? {
        return czmv::cut(equation, options, (set, hull), scratch);
    }
    let Scratch { bounds, quadratic: Some(quadratic), product, map, culprits, .. } = scratch else { return Ok(()) };
    if options.curvature == Curvature::Hull {
        quadratic.box_curvature(bounds)?;
    }
    let noise = equation.noise.filter(|noise| !is_box(noise));
    let result = match noise {
        None => quadratic.intersect(set, equation.values, bounds),
        Some(noise) => {
            let product = store(product, set);
            product.product_assign_zonotope(noise);
            quadratic.intersect(product, equation.values, bounds)
        }
    };
    match result {
        // A bound on one side of an output without one on the other.
        Err(BoundError::UnboundedResult { .. }) => return czmv::cut(equation, options, (set, hull), scratch),
        result => result?,
    }
    if let (Some(_), Some(product)) = (noise, product) {
        forget_noises(hull.len(), product, map, bounds)?;
        core::mem::swap(set, product);
    }
    // Products of the set's constraints say nothing that the set does not.
    let said = (0..equation.values.len()).filter(|&i| says(i));
    culprits.resize(set.num_constraints() - said.clone().count(), Culprit::Prediction);
    culprits.extend(said.map(equation.culprit));
    Ok(())
}

/// Encloses the outputs of a function that are wanted on a set and noises; `false` if they are not smooth enough there.
fn enclose(
    (relation, noise): (&Relation, Option<&Zonotope>),
    wanted: impl Fn(usize) -> bool,
    options: &CzOptions,
    parameters: &[Interval],
    (set, hull): (&ConstrainedZonotope, &[Interval]),
    scratch: &mut Scratch,
) -> Result<bool, EstimatorError> {
    let Scratch { bounds, quadratic, place, product, .. } = scratch;
    place.choose(options, Extension::FirstOrder, (set, hull), noise, bounds)?;
    let product = store(product, set);
    if let Some(noise) = noise {
        product.product_assign_zonotope(noise);
    }
    let (function, domain) = (relation.function(), place.domain(parameters));
    let quadratic = match quadratic {
        Some(quadratic) => quadratic,
        None => quadratic.insert(QuadraticEnclosure::unknown(function.outputs())?),
    };
    match quadratic.renew_for(wanted, function, product, (&domain, options.copies), bounds) {
        Ok(()) => Ok(true),
        Err(
            BoundError::NotSmooth { .. } | BoundError::UnboundedResult { .. } | BoundError::OrderNotAvailable { .. },
        ) => Ok(false),
        Err(error) => Err(error.into()),
    }
}
