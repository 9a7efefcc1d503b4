//! What a call of a [`Vh`](crate::Vh) filter is made of: images, cuts, and the vertex budget.

use std::borrow::Cow;

use nonlin_bounds::{BoundError, PolytopicCut, RangeMethod, polytopic_image_with_noise, polytopic_strips, range};
use scalars::Interval;
use scalars::rounding::sub_down;
use setrep::{Matrix, SetError, VPolytope};

use super::{State, VhOptions, VhScratch};
use crate::polytopic::noise::beside;
use crate::set_filter::{Equation, inconsistent};
use crate::{EstimatorError, Evidence, Phase, System};

/// New vertices that lie in the hull of the others up to this share of the set's extents are dropped.
const THIN: f64 = 1e-10;

/// Whether a set had too many vertices for a step.
pub(super) fn is_over_budget(error: &EstimatorError) -> bool {
    matches!(
        error,
        EstimatorError::Bound(BoundError::Set(SetError::OverBudget { .. }))
            | EstimatorError::Set(SetError::OverBudget { .. })
    )
}

/// Moves the hull of a state on, as a box.
pub(super) fn advance_hull(
    system: &System,
    input: &[Interval],
    state: &mut State,
    scratch: &mut VhScratch,
) -> Result<(), EstimatorError> {
    let f = system.dynamics().function();
    let noise = system.process_noise().interval_hull();
    let domain: Vec<Interval> = state.hull.iter().chain(noise.iter()).copied().collect();
    let mut sides = vec![Interval::ENTIRE; f.outputs()];
    range(f, &domain, input, RangeMethod::Tight, &mut scratch.bounds, &mut sides)?;
    state.set = VPolytope::from_intervals(&sides)?;
    Ok(())
}

/// Moves the set of a state on.
pub(super) fn advance(
    system: &System,
    options: &VhOptions,
    input: &[Interval],
    state: &mut State,
    scratch: &mut VhScratch,
) -> Result<(), EstimatorError> {
    let VhScratch { bounds, noises, sides, .. } = scratch;
    let f = system.dynamics().function();
    let set = beside(&state.set, system.process_noise(), noises)?;
    let mut image = polytopic_image_with_noise(f, &set, noises, options.center.expansion(), input, bounds)?;
    if options.tight_range {
        let domain: Vec<Interval> = set.interval_hull().iter().chain(noises.iter()).copied().collect();
        sides.clear();
        sides.resize(f.outputs(), Interval::ENTIRE);
        range(f, &domain, input, RangeMethod::Tight, bounds, sides)?;
        image = within(image, sides).map_err(|error| match error {
            SetError::EmptySet => inconsistent(state.step, vec![], Evidence::Propagation { hull: state.hull.clone() }),
            error => error.into(),
        })?;
    }
    state.set = image;
    Ok(())
}

/// A superset of the set whose vertices leave room for the corners that a step puts around each.
pub(super) fn few_vertices(
    state: &State,
    options: &VhOptions,
    scratch: &mut VhScratch,
) -> Result<VPolytope, EstimatorError> {
    let corners = 1_usize.checked_shl(u32::try_from(state.hull.len()).unwrap_or(u32::MAX)).unwrap_or(usize::MAX);
    let few = (options.vertices / 4).max(corners);
    Ok(state.set.enclosed_within(few, &mut scratch.bounds.sets)?)
}

/// Cuts a state; where its vertices are too many for that it is enclosed in a smaller one first, and stays at worst as it is.
pub(super) fn cut(
    equation: &Equation<'_>,
    options: &VhOptions,
    state: &mut State,
    scratch: &mut VhScratch,
) -> Result<(), EstimatorError> {
    let mut result = try_cut(equation, options, state, scratch);
    if result.as_ref().is_err_and(is_over_budget) {
        state.set = few_vertices(state, options, scratch)?;
        result = try_cut(equation, options, state, scratch);
    }
    if result.as_ref().is_err_and(is_over_budget) { Ok(()) } else { result }
}

fn try_cut(
    equation: &Equation<'_>,
    options: &VhOptions,
    state: &mut State,
    scratch: &mut VhScratch,
) -> Result<(), EstimatorError> {
    let VhScratch { bounds, noises, culprits, .. } = scratch;
    noises.clear();
    let set = match equation.noise {
        Some(noise) => beside(&state.set, noise, noises)?,
        None => Cow::Borrowed(&state.set),
    };
    let (g, n, values) = (equation.relation.function(), state.hull.len(), equation.values);
    let center = options.center.expansion();
    match polytopic_strips(g, (&set, noises), values, center, equation.parameters, bounds)? {
        PolytopicCut::Left(solution) if solution.dim() > n => {
            let mut states = Matrix::zeros(n, solution.dim());
            (0..n).for_each(|k| states[(k, k)] = 1.0);
            state.set = solution.linear_map(&states)?.thinned(THIN);
        }
        PolytopicCut::Left(solution) => state.set = solution,
        PolytopicCut::ProvenEmpty { output, reach } => {
            culprits.extend((0..=output).map(equation.culprit));
            let evidence = Evidence::Disjoint { predicted: reach, required: values[output] };
            return Err(inconsistent(state.step, core::mem::take(culprits), evidence));
        }
    }
    culprits.extend(equation.culprits(None));
    Ok(())
}

/// The part of a set in a box.
fn within(mut set: VPolytope, sides: &[Interval]) -> Result<VPolytope, SetError> {
    for (k, side) in sides.iter().enumerate() {
        for (sign, bound) in [(1.0, side.hi()), (-1.0, -side.lo())] {
            let reach = set.remainder()[k];
            let values: Vec<f64> = set.vertices().columns().map(|v| sub_down(sign * v[k], reach)).collect();
            if bound.is_finite() && values.iter().any(|&value| value > bound) {
                set = set.cut_by_values(&values, bound, THIN)?;
            }
        }
    }
    Ok(set)
}

/// Bounds the number of vertices, takes the remainder into the hull, and finds the interval hull.
pub(super) fn settle(
    state: &mut State,
    options: &VhOptions,
    scratch: &mut VhScratch,
    trace: &mut dyn FnMut(Phase),
) -> Result<(), EstimatorError> {
    if state.set.num_vertices() > options.vertices {
        state.set = state.set.enclosed_within(options.vertices, &mut scratch.bounds.sets)?;
        trace(Phase::Reduction);
    }
    state.set = state.set.absorb_remainder();
    state.hull.copy_from_slice(&state.set.interval_hull());
    Ok(())
}
