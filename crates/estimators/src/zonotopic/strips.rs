//! Intersections with strips: what outputs of a measurement or an invariant say of the states, and strips given.

use nonlin_bounds::{BoundError, Domain, Form};
use scalars::Interval;
use setrep::{SetError, StripCut, Zonotope};

use super::{Scratch, State, StripForm, ZonotopeOptions, renew_hull};
use crate::set_filter::{Equation, inconsistent};
use crate::{Culprit, EstimatorError, Evidence};

/// Cuts a state with the strips of an equation, output by output, each over the hull that the last one left. Missing outputs say nothing.
///
/// **Source:** Alamo, Bravo, Camacho 2005 (strips); Bravo, Alamo, Camacho 2006 (intersection).
pub(super) fn cut(
    equation: &Equation<'_>,
    options: &ZonotopeOptions,
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    for (i, &value) in equation.values.iter().enumerate().filter(|(_, value)| **value != Interval::ENTIRE) {
        let culprit = (equation.culprit)(i);
        scratch.stacked.fill(&state.hull, equation.noise)?;
        let strip = match options.strips {
            StripForm::Apart => apart(equation, i, value, state, scratch),
            StripForm::Row => row(equation, i, value, state, scratch),
        };
        let range = match strip {
            // A function that is defined nowhere in the hull has no value there to be measured.
            Err(EstimatorError::Bound(BoundError::Set(SetError::EmptySet))) => {
                let evidence = Evidence::Propagation { hull: state.hull.clone() };
                return Err(inconsistent(state.step, vec![culprit], evidence));
            }
            result => result?,
        };
        let direction = core::mem::take(&mut scratch.direction);
        let result = cut_by(&direction, range, culprit, options, state, scratch);
        scratch.direction = direction;
        result?;
    }
    Ok(())
}

/// The strip of output `i` with its parts evaluated apart: the direction into the scratch, and the range.
fn apart(
    equation: &Equation<'_>,
    i: usize,
    value: Interval,
    state: &State,
    scratch: &mut Scratch,
) -> Result<Interval, EstimatorError> {
    let Scratch { bounds, strip, stacked, direction, .. } = scratch;
    let (n, function) = (state.set.dim(), equation.relation.function());
    strip.enclose(function, i, &stacked.sides, n, equation.parameters, value, bounds)?;
    if strip.predicted().disjoint(&value) {
        return Err(refuted(state.step, Some((equation.culprit)(i)), strip.predicted(), value));
    }
    direction.clear();
    direction.extend_from_slice(strip.direction());
    Ok(strip.range())
}

/// The row of output `i` of an affine enclosure, likewise; of no direction if there is none.
fn row(
    equation: &Equation<'_>,
    i: usize,
    value: Interval,
    state: &State,
    scratch: &mut Scratch,
) -> Result<Interval, EstimatorError> {
    let Scratch { bounds, enclosure, rows, stacked, direction, .. } = scratch;
    let noises = equation.noise.map_or(0, Zonotope::dim);
    let domain = Domain::new(&stacked.sides, &stacked.point).with_parameters(equation.parameters).with_noises(noises);
    enclosure.enclose_output_at_best(Form::Taylor, equation.relation.function(), i, &domain, bounds)?;
    enclosure.rows_into(state.set.dim(), &[value], rows)?;
    direction.clear();
    direction.resize(state.set.dim(), 0.0);
    // One row or none.
    let Some(&range) = rows.ranges().first() else { return Ok(Interval::ENTIRE) };
    direction.copy_from_slice(rows.directions().as_slice());
    Ok(range)
}

/// Cuts a state with one strip.
pub(super) fn cut_by(
    direction: &[f64],
    range: Interval,
    culprit: Culprit,
    options: &ZonotopeOptions,
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    match state.set.intersect_strip(direction, range, options.rule, &mut scratch.bounds.sets)? {
        StripCut::Unchanged => Ok(()),
        StripCut::Cut => renew_hull(options.keep_hull, state, Some(culprit), scratch),
        StripCut::ProvenEmpty { reach } => Err(refuted(state.step, Some(culprit), reach, range)),
    }
}

/// Two enclosures of one quantity without a common point.
pub(super) fn refuted(step: u64, culprit: Option<Culprit>, predicted: Interval, required: Interval) -> EstimatorError {
    inconsistent(step, culprit.into_iter().collect(), Evidence::Disjoint { predicted, required })
}
