//! Correction: the part of the set that measurements and invariants leave.

use nonlin_bounds::BoundError;
use scalars::Interval;
use setrep::{ConstrainedZonotope, SetError};

use super::options::RczOptions;
use super::scratch::Scratch;
use super::state::{RczState, cut_hull};
use crate::set_filter::{Equation, of_hull, of_values, store};
use crate::{Culprit, EstimatorError};

/// Cuts a state with equations, all of them together.
///
/// Up to `options.passes` times: propagate the hull through the tapes; enclose the functions by affine ones with remainders on
/// the hull; cut the **predicted** set with their rows, which replace those of the pass before; take the hull of the result. Rows made
/// over a hull hold for every consistent state, since all of these lie in it, so each pass may use the hull of the last. Passes end when
/// they gain too little: for linear functions, whose rows do not depend on the hull, before the second hull.
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

/// Share of [`RczOptions::least_shrink`] by which some row has to get narrower for another hull.
///
/// A hull may shrink by more than the rows that bound it, where they meet at a sharp angle.
const ROW_SHARE: f64 = 0.25;

fn passes(
    equations: &[Equation<'_>],
    options: &RczOptions,
    base: &ConstrainedZonotope,
    trial: &mut ConstrainedZonotope,
    state: &mut RczState,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    scratch.widths.clear();
    for pass in 1..=options.passes.max(1) {
        let mut before = core::mem::take(&mut scratch.before);
        before.clone_from(&state.hull);
        let mut result = cut(equations, options, base, trial, state, scratch);
        let worth_it = pass == 1 || rows_narrowed(trial, base, ROW_SHARE * options.least_shrink, &scratch.widths);
        if result.is_ok() && worth_it {
            result = shrink(options, base, trial, state, scratch);
        }
        let shrunk = |(new, old): (&Interval, &Interval)| new.rad() <= (1.0 - options.least_shrink) * old.rad();
        let go_on = worth_it && state.hull.iter().zip(&before).any(shrunk);
        scratch.before = before;
        result?;
        if !go_on {
            break;
        }
    }
    state.memory.directions.append(&scratch.directions)?;
    Ok(())
}

/// Whether some new row is narrower by a share than that of the last pass, or there are others.
fn rows_narrowed(trial: &ConstrainedZonotope, base: &ConstrainedZonotope, share: f64, widths: &[f64]) -> bool {
    let rows = &trial.ranges()[base.num_constraints()..];
    let narrower = |(row, width): (&Interval, &f64)| row.width() <= (1.0 - share) * width;
    rows.len() != widths.len() || rows.iter().zip(widths).any(narrower)
}

/// Contracts the hull of the state and cuts `base` with the rows over it, which gives `trial`.
fn cut(
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
            conflict = Some((equation, equation.culprits(Some(found))));
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
            Err(EstimatorError::Bound(BoundError::Set(SetError::EmptySet))) => {
                conflict = Some((equation, equation.culprits(None)));
            }
            Err(error) => return Err(error),
        }
    }
    let Scratch { bounds, culprits, .. } = scratch;
    match conflict {
        Some(conflict) => Err(of_values(state, trial, conflict, culprits, &mut bounds.sets)),
        None => Ok(()),
    }
}

/// Cuts the hull of the state with that of `trial`, and notes how wide its new rows are.
fn shrink(
    options: &RczOptions,
    base: &ConstrainedZonotope,
    trial: &mut ConstrainedZonotope,
    state: &mut RczState,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let Scratch { bounds, own, held, culprits, widths, .. } = scratch;
    widths.clear();
    widths.extend(trial.ranges()[base.num_constraints()..].iter().map(Interval::width));
    held.clone_from(&state.hull);
    cut_hull(trial, &mut state.hull, own, options, &mut bounds.sets)?;
    if state.hull.iter().any(Interval::is_empty) {
        return Err(of_hull(state.step, trial, (own, held), culprits, &mut bounds.sets));
    }
    Ok(())
}
