//! Prediction: the image of the set under the dynamics.

use nonlin_bounds::Domain;
use scalars::Interval;

use super::options::RczOptions;
use super::scratch::Scratch;
use super::state::{RczState, cut_hull};
use crate::set_filter::of_hull;
use crate::{EstimatorError, System};

/// Moves a state on by one step of the dynamics.
///
/// With `H` the hull, `gamma` its middle and the noises stacked to the states: `f(x, w) in f(gamma) + J (x - gamma, w - gamma_w) + [e]`
/// on `H x W`, `J` the Jacobian at the middle and `[e]` the one-sided second-order remainder (where `f` is not proven smooth
/// enough there, the mean value form, or the range). The new hull is that of the image, cut with the range.
pub(super) fn advance(
    system: &System,
    options: &RczOptions,
    input: &[Interval],
    state: &mut RczState,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let (n, noise) = (system.states(), system.process_noise());
    let Scratch { bounds, enclosure, stacked, own, held, map, .. } = scratch;
    stacked.fill(&state.hull, Some(noise))?;
    let domain = Domain::new(&stacked.sides, &stacked.point).with_parameters(input).with_noises(noise.dim());
    enclosure.enclose_where_possible(system.dynamics().function(), &domain, bounds)?;

    state.set.product_assign_zonotope(noise);
    enclosure.image_in_place(&mut state.set, bounds)?;
    map.assign_column_slice(n, n, &enclosure.jacobian().as_slice()[..n * n])?;
    state.memory.directions.transport(map, &mut bounds.sets)?;
    state.step += 1;
    state.memory.unreduced += 1;

    enclosure.range_into(&mut state.hull)?;
    held.clone_from(&state.hull);
    cut_hull(&mut state.set, &mut state.hull, own, options, &mut bounds.sets)?;
    if state.hull.iter().any(Interval::is_empty) {
        return Err(of_hull(state.step, &state.set, (own, held), &[], &mut bounds.sets));
    }
    Ok(())
}
