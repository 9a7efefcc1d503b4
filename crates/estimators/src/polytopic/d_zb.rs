//! [`DZb`]: zonotope bundles moved by remainder-form decomposition.

use nonlin_bounds::{Workspace, decomposition_images_of_zonotope};
use scalars::Interval;
use setrep::{BundleComplexity, HPolytope, Reduction, SetError, Zonotope, ZonotopeBundle};

use super::decomposed::Cutting;
use crate::error::check_size;
use crate::set_filter::of_hull;
use crate::{EstimatorError, FilterState, Measured, Method, Phase, SetFilter, System};

/// Guaranteed state estimation with zonotope bundles by decomposition functions (D-ZB).
///
/// - **Prediction.** Every member, noises beside the states, is moved by itself in [`DZbOptions::choices`] ways, one a choice of rows
///   ([`decomposition_images_of_zonotope`]): the result is the bundle of all these images.
/// - **Update.** The bundle as a constrained zonotope is cut with the rows of the measurement ([`decomposition_solution`](nonlin_bounds::decomposition_solution)), and is a bundle again by
///   half-spaces around it ([`HPolytope::around`]): in up to three dimensions its facets if they are few enough, else those that cut off most.
/// - **Reduction.** To [`DZbOptions::members`] members by [`ZonotopeBundle::reduce`], once there are more.
///
/// **Guarantee:** [`Guarantee::Rigorous`](crate::Guarantee::Rigorous); see [`SetFilter`].
/// **Source:** as [`DCz`](crate::DCz); the way back to a bundle is ours.
///
/// ```
/// use estimators::{DZb, DZbOptions, Estimator, Relation, System};
/// use nonlin_bounds::function;
/// use setrep::Zonotope;
///
/// let grow = function!(|[x, y, w]: 3| -> 2 { [x + y.scale(0.5) + w, y - (x * y).scale(0.25)] });
/// let product = function!(|[x, y, error]: 3| -> 1 { [x * y + error] });
/// let small = Zonotope::from_box(&[0.0], &[0.01])?;
/// let system = System::new(Relation::new(grow), small.clone(), Relation::new(product), small)?;
/// let start = Zonotope::from_box(&[1.0, 1.0], &[0.3, 0.3])?;
/// let mut filter = DZb::new(system, start.into(), DZbOptions::new(2))?;
/// filter.step(&[], &[1.0])?;
/// assert!(filter.hull()[0].contains(1.5) && filter.hull()[0].width() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type DZb = SetFilter<DecomposedBundle>;

/// The [`Method`] of [`DZb`].
#[derive(Debug, Clone, Copy)]
pub struct DecomposedBundle;

/// What a [`DZb`] filter may spend. The options affect tightness and time, never validity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DZbOptions {
    /// Most members of a bundle after a call, at least one.
    pub members: usize,
    /// Images of every member in a prediction, at least one.
    pub choices: usize,
}

impl DZbOptions {
    /// For `n` states: `3 n` members, two images of each.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { members: 3 * n, choices: 2 }
    }
}

/// Buffers of a [`DZb`] filter.
#[derive(Debug, Default, Clone)]
pub struct DZbScratch {
    bounds: Workspace,
}

/// Set and hull of a [`DZb`] filter.
type State = FilterState<ZonotopeBundle>;

impl Method for DecomposedBundle {
    type Set = ZonotopeBundle;
    type Memory = ();
    type Options = DZbOptions;
    type Scratch = DZbScratch;

    fn start(
        _system: &System,
        set: ZonotopeBundle,
        options: &DZbOptions,
        scratch: &mut DZbScratch,
    ) -> Result<State, EstimatorError> {
        for (what, count) in [("bundle members", options.members), ("images of a member", options.choices)] {
            if count == 0 {
                check_size(what, 1, 0)?;
            }
        }
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
        options: &DZbOptions,
        input: &[Interval],
        state: &mut State,
        scratch: &mut DZbScratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        let (f, bounds) = (system.dynamics().function(), &mut scratch.bounds);
        let mut members: Vec<Zonotope> = Vec::with_capacity(options.choices * state.set.num_members());
        for member in state.set.members() {
            let stacked = member.cartesian_product(system.process_noise());
            for mut image in decomposition_images_of_zonotope(f, &stacked, input, options.choices, bounds)? {
                image.materialize();
                if !members.contains(&image) {
                    members.push(image);
                }
            }
        }
        state.set = ZonotopeBundle::new(members)?;
        state.step += 1;
        let own = state.set.interval_hull(&mut bounds.sets)?;
        if own.iter().any(Interval::is_empty) {
            let set = state.set.to_constrained_zonotope()?;
            return Err(of_hull(state.step, &set, (&own, &state.hull), &[], &mut bounds.sets));
        }
        state.hull.copy_from_slice(&own);
        trace(Phase::Prediction);
        shrink(state, options, scratch, trace)
    }

    fn correct(
        system: &System,
        options: &DZbOptions,
        measured: Option<Measured<'_>>,
        state: &mut State,
        scratch: &mut DZbScratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        let bounds = &mut scratch.bounds;
        let (mut set, mut culprits) = (state.set.to_constrained_zonotope()?, Vec::new());
        Cutting { step: state.step, set: &mut set, hull: &mut state.hull, culprits: &mut culprits, bounds }
            .correct(system, measured, trace)?;
        let own = set.interval_hull(&mut bounds.sets)?;
        // A member for each half-space beyond those of the hull.
        let half_spaces = 2 * state.hull.len() + options.members.max(1) - 1;
        let around = match HPolytope::around(&set, half_spaces, &mut bounds.sets) {
            Err(SetError::EmptySet) => {
                return Err(of_hull(state.step, &set, (&own, &state.hull), &culprits, &mut bounds.sets));
            }
            around => around?,
        };
        let mid: Vec<f64> = own.iter().map(Interval::mid).collect();
        let radii: Vec<f64> = own.iter().map(Interval::rad).collect();
        state.set = Zonotope::from_box(&mid, &radii)?.into();
        state.set.intersect_h_polytope(&around, &mut bounds.sets)?;
        shrink(state, options, scratch, trace)
    }

    fn reduce(
        _system: &System,
        options: &DZbOptions,
        state: &mut State,
        scratch: &mut DZbScratch,
    ) -> Result<(), EstimatorError> {
        shrink(state, options, scratch, &mut |_| {})
    }
}

/// Encloses a bundle with too many members in a small one; the hull stays.
fn shrink(
    state: &mut State,
    options: &DZbOptions,
    scratch: &mut DZbScratch,
    trace: &mut dyn FnMut(Phase),
) -> Result<(), EstimatorError> {
    let limit = BundleComplexity { members: options.members.max(1), generators: 3 * state.hull.len() };
    let small = |member: &Zonotope| member.num_generators() <= limit.generators;
    if state.set.num_members() > limit.members || !state.set.members().iter().all(small) {
        state.set.reduce(limit, Reduction::Method4, &mut scratch.bounds.sets)?;
        trace(Phase::Reduction);
    }
    Ok(())
}
