//! Correction: the part of the set that measurements and invariants leave.

use nonlin_bounds::BoundError;
use scalars::Interval;
use setrep::{ConstrainedZonotope, SetError};

use super::options::RczOptions;
use super::scratch::Scratch;
use super::state::{RczState, cut_hull};
use crate::set_filter::{Equation, of_hull, of_propagation, store};
use crate::{Culprit, EstimatorError};

/// Cuts a state with equations, all of them together.
///
/// Up to `options.passes` times: propagate the hull through the tapes; enclose the functions by affine ones with remainders on
/// the hull; cut the **predicted** set with their rows, which replace those of the pass before; take the hull of the result. Rows made
/// over a hull hold for every consistent state, since all of these lie in it, so each pass may use the hull of the last.
pub(super) fn correct(
    equations: &[Equation<'_>],
    options: &RczOptions,
    state: &mut RczState,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let mut slots = (core::mem::take(&mut scratch.base), core::mem::take(&mut scratch.trial));
    let base = store(&mut slots.0, &state.set);
    base.materialize();
    let trial = store(&mut slots.1, base);
    let result = passes(equations, options, base, trial, state, scratch);
    if result.is_ok() {
        core::mem::swap(&mut state.set, trial);
    }
    (scratch.base, scratch.trial) = slots;
    result
}

fn passes(
    equations: &[Equation<'_>],
    options: &RczOptions,
    base: &ConstrainedZonotope,
    trial: &mut ConstrainedZonotope,
    state: &mut RczState,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    for pass in 1..=options.passes.max(1) {
        let mut before = core::mem::take(&mut scratch.before);
        before.clone_from(&state.hull);
        let result = one_pass(equations, options, base, trial, state, scratch);
        let shrunk = |(new, old): (&Interval, &Interval)| new.rad() <= (1.0 - options.least_shrink) * old.rad();
        let go_on = state.hull.iter().zip(&before).any(shrunk);
        scratch.before = before;
        result?;
        if !go_on || pass == options.passes {
            break;
        }
    }
    state.memory.directions.append(&scratch.directions)?;
    Ok(())
}

/// One pass over the hull of the state, which becomes that of `trial`.
fn one_pass(
    equations: &[Equation<'_>],
    options: &RczOptions,
    base: &ConstrainedZonotope,
    trial: &mut ConstrainedZonotope,
    state: &mut RczState,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let mut conflict = None;
    for equation in equations {
        if let Some(found) = equation.contract(options.contraction, &mut state.hull, scratch)? {
            conflict = Some(equation.culprits(Some(found)));
            break;
        }
    }
    trial.clone_from(base);
    scratch.culprits.clear();
    scratch.culprits.resize(base.num_constraints(), Culprit::Prediction);
    scratch.directions.reset(base.dim());
    for equation in equations {
        match equation.cut(&state.hull, trial, scratch) {
            Ok(()) => {}
            // What is already refuted need not be enclosed.
            Err(_) if conflict.is_some() => {}
            // A function that is defined nowhere in the box has no value there to be measured.
            Err(EstimatorError::Bound(BoundError::Set(SetError::EmptySet))) => conflict = Some(equation.culprits(None)),
            Err(error) => return Err(error),
        }
    }
    let Scratch { bounds, own, culprits, .. } = scratch;
    if let Some(conflict) = conflict {
        return Err(of_propagation(state, trial, conflict, culprits, &mut bounds.sets));
    }
    let held = &mut scratch.held;
    held.clone_from(&state.hull);
    cut_hull(trial, &mut state.hull, own, options, &mut bounds.sets)?;
    if state.hull.iter().any(Interval::is_empty) {
        return Err(of_hull(state.step, trial, (own, held), culprits, &mut bounds.sets));
    }
    Ok(())
}
