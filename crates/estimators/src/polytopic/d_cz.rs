//! [`DCz`]: constrained zonotopes moved by remainder-form decomposition.

use nonlin_bounds::{Workspace, decomposition_image};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Directions, Reencoding, SetError};

use super::decomposed::Cutting;
use crate::{Culprit, EstimatorError, FilterState, Measured, Method, Phase, SetFilter, System};

/// Guaranteed state estimation with constrained zonotopes by decomposition functions (D-CZ).
///
/// - **Prediction.** States and noises side by side; each output lies in a row over the generators and a residual between two corners
///   of the box of generators ([`decomposition_image`]), cut by the tight range of the dynamics.
/// - **Update.** The rows of the measurement, noises as generators, become constraints ([`decomposition_solution`](nonlin_bounds::decomposition_solution)). The invariant joins every
///   update.
/// - **Reduction.** [LP re-encoding](ConstrainedZonotope::reencode) to `n` generators and at most [`DCzOptions::constraints`] constraints, once a
///   prediction or an update has left more, along the directions of the constraints and the diagonals of the coordinates.
///
/// **Guarantee:** [`Guarantee::Rigorous`](crate::Guarantee::Rigorous); see [`SetFilter`].
/// **Source:** Khajenejad, Shoaib, Yong, *Guaranteed State Estimation via Indirect Polytopic Set Computation for Nonlinear Discrete-Time
/// Systems* (2021), reference 16 of paper 004; rows, cuts and reduction are ours.
///
/// ```
/// use estimators::{DCz, DCzOptions, Estimator, Relation, System};
/// use nonlin_bounds::function;
/// use setrep::{ConstrainedZonotope, Zonotope};
///
/// let grow = function!(|[x, y, w]: 3| -> 2 { [x + y.scale(0.5) + w, y - (x * y).scale(0.25)] });
/// let product = function!(|[x, y, error]: 3| -> 1 { [x * y + error] });
/// let small = Zonotope::from_box(&[0.0], &[0.01])?;
/// let system = System::new(Relation::new(grow), small.clone(), Relation::new(product), small)?;
/// let start = ConstrainedZonotope::from_box(&[1.0, 1.0], &[0.3, 0.3])?;
/// let mut filter = DCz::new(system, start, DCzOptions::new(2))?;
/// filter.step(&[], &[1.0])?;
/// assert!(filter.hull()[0].contains(1.5) && filter.hull()[0].width() < 0.7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type DCz = SetFilter<DecomposedConstrained>;

/// The [`Method`] of [`DCz`].
#[derive(Debug, Clone, Copy)]
pub struct DecomposedConstrained;

/// What a [`DCz`] filter may spend. The options affect tightness and time, never validity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DCzOptions {
    /// Most constraints of a set after a call.
    pub constraints: usize,
}

impl DCzOptions {
    /// For `n` states, at most `3 n` constraints: the choices of signs grow with the generators, so sets are kept small.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { constraints: 3 * n }
    }
}

/// Buffers of a [`DCz`] filter.
#[derive(Debug, Default, Clone)]
pub struct DCzScratch {
    bounds: Workspace,
    culprits: Vec<Culprit>,
}

/// Set and hull of a [`DCz`] filter.
type State = FilterState<ConstrainedZonotope>;

impl Method for DecomposedConstrained {
    type Set = ConstrainedZonotope;
    type Memory = ();
    type Options = DCzOptions;
    type Scratch = DCzScratch;

    fn start(
        _system: &System,
        set: ConstrainedZonotope,
        options: &DCzOptions,
        scratch: &mut DCzScratch,
    ) -> Result<State, EstimatorError> {
        let hull = set.interval_hull(&mut scratch.bounds.sets)?.to_vec();
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet.into());
        }
        let mut state = FilterState { set, hull, step: 0, memory: () };
        shrink(&mut state, options, scratch, &mut |_| {})?;
        Ok(state)
    }

    fn predict(
        system: &System,
        options: &DCzOptions,
        input: &[Interval],
        state: &mut State,
        scratch: &mut DCzScratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        state.set.product_assign_zonotope(system.process_noise());
        state.set = decomposition_image(system.dynamics().function(), &state.set, input, &mut scratch.bounds)?;
        state.set.materialize();
        state.step += 1;
        scratch.culprits.clear();
        state.hull.fill(Interval::ENTIRE);
        cutting(state, scratch).cut_hull()?;
        trace(Phase::Prediction);
        shrink(state, options, scratch, trace)
    }

    fn correct(
        system: &System,
        options: &DCzOptions,
        measured: Option<Measured<'_>>,
        state: &mut State,
        scratch: &mut DCzScratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        cutting(state, scratch).correct(system, measured, trace)?;
        shrink(state, options, scratch, trace)
    }

    fn reduce(
        _system: &System,
        options: &DCzOptions,
        state: &mut State,
        scratch: &mut DCzScratch,
    ) -> Result<(), EstimatorError> {
        shrink(state, options, scratch, &mut |_| {})
    }
}

fn cutting<'a>(state: &'a mut State, scratch: &'a mut DCzScratch) -> Cutting<'a> {
    let FilterState { set, hull, step, .. } = state;
    Cutting { step: *step, set, hull, culprits: &mut scratch.culprits, bounds: &mut scratch.bounds }
}

/// Encloses a set with too many constraints or generators in a small one; the hull stays.
fn shrink(
    state: &mut State,
    options: &DCzOptions,
    scratch: &mut DCzScratch,
    trace: &mut dyn FnMut(Phase),
) -> Result<(), EstimatorError> {
    let n = state.hull.len();
    if state.set.num_constraints() <= options.constraints && state.set.num_generators() <= n + options.constraints {
        return Ok(());
    }
    let sets = &mut scratch.bounds.sets;
    let mut directions = Directions::new(n);
    directions.push_constraints(&state.set, sets)?;
    let unit = |k: usize| if state.hull[k].rad() > 0.0 { 1.0 / state.hull[k].rad() } else { 1.0 };
    for j in 0..n {
        for k in 0..j {
            for sign in [1.0, -1.0] {
                let mut diagonal = vec![0.0; n];
                (diagonal[j], diagonal[k]) = (unit(j), sign * unit(k));
                if diagonal.iter().all(|x| x.is_finite()) {
                    directions.push(&diagonal)?;
                }
            }
        }
    }
    state.set.reencode(Reencoding::new(options.constraints), &mut directions, sets)?;
    trace(Phase::Reduction);
    Ok(())
}
