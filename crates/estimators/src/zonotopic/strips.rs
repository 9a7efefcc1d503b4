//! Intersections with strips: what outputs of a measurement or an invariant say of the states, and strips given.

use nonlin_bounds::BoundError;
use scalars::Interval;
use setrep::{SetError, StripCut};

use super::{Scratch, State, ZonotopeOptions, renew_hull};
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
    let (n, function) = (state.set.dim(), equation.relation.function());
    for (i, &value) in equation.values.iter().enumerate().filter(|(_, value)| **value != Interval::ENTIRE) {
        let culprit = (equation.culprit)(i);
        scratch.stacked.fill(&state.hull, equation.noise)?;
        let Scratch { bounds, strip, stacked, .. } = &mut *scratch;
        match strip.enclose(function, i, &stacked.sides, n, equation.parameters, value, bounds) {
            // A function that is defined nowhere in the hull has no value there to be measured.
            Err(BoundError::Set(SetError::EmptySet)) => {
                let evidence = Evidence::Propagation { hull: state.hull.clone() };
                return Err(inconsistent(state.step, vec![culprit], evidence));
            }
            result => result?,
        }
        if strip.predicted().disjoint(&value) {
            return Err(refuted(state.step, Some(culprit), strip.predicted(), value));
        }
        let strip = core::mem::take(strip);
        let result = cut_by(strip.direction(), strip.range(), culprit, options, state, scratch);
        scratch.strip = strip;
        result?;
    }
    Ok(())
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
pub(super) fn refuted(
    step: u64,
    culprit: Option<Culprit>,
    predicted: Interval,
    required: Interval,
) -> EstimatorError {
    inconsistent(step, culprit.into_iter().collect(), Evidence::Disjoint { predicted, required })
}
