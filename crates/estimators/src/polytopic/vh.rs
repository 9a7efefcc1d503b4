//! [`Vh`]: the direct polytopic filter of paper 004, on vertices.

use nonlin_bounds::Workspace;
use scalars::Interval;
use setrep::VPolytope;

use self::steps::{advance, advance_hull, cut, few_vertices, is_over_budget, settle};
use super::forms::materialized;
use crate::error::check_size;
use crate::set_filter::Equation;
use crate::{Culprit, EstimatorError, FilterState, Measured, Method, Phase, SetFilter, System};

mod options;
mod steps;

pub use options::{VhCenter, VhOptions};

/// Guaranteed state estimation with polytopes in vertex form (V-H).
///
/// - **Prediction.** Each vertex becomes the box `f(x_0) + [J] (v - x_0)` plus noise, about a point `x_0` by [`VhOptions::center`] and with `[J]` the range of the Jacobian over the hull of the set; the set is
///   the hull of these boxes.
/// - **Update.** With `x` a convex combination of the vertices, each bound of an output bounds the combination of its least values at
///   the vertices. This simplex of weights is cut along its edges, so no facets are needed: what the paper does by a conversion in
///   the space of the outputs, a projection and one more conversion. The invariant joins every update.
/// - **Vertex budget.** A set with more vertices than [`VhOptions::vertices`] is enclosed by [`VPolytope::enclosed_within`]: half-spaces
///   among its own facets and principal directions, as many as can meet in so many points. A set with too many vertices for a step is
///   enclosed in one with a quarter of the budget before; at worst a prediction is the box of [`range()`](nonlin_bounds::range()), and an update leaves the set.
///
/// Rounding goes to the remainder of the set, and from there into its hull as soon as that has an interior
/// ([`VPolytope::absorb_remainder`]). A noise that mixes its components is listed by its vertices if these are few; else its hull is taken.
///
/// **Guarantee:** [`Guarantee::Rigorous`](crate::Guarantee::Rigorous); see [`SetFilter`].
/// **Source:** paper 004, Theorems 1 and 2; with [`VhOptions::paper`] a prediction is the paper's, and an update lies in the paper's.
///
/// ```
/// use estimators::{Estimator, Relation, System, Vh, VhOptions};
/// use nonlin_bounds::function;
/// use setrep::{IntervalVector, VPolytope, Zonotope};
///
/// // A point that turns about the origin, variables (x, y, w1, w2); its distance is measured, variables (x, y, error).
/// let turn = function!(|[x, y, w1, w2]: 4| -> 2 { [
///     x * S::decimal("0.8") - y * S::decimal("0.6") + w1, x * S::decimal("0.6") + y * S::decimal("0.8") + w2] });
/// let distance = function!(|[x, y, error]: 3| -> 1 { [(x.sqr() + y.sqr()).sqrt() + error] });
/// let small = |n: usize| Zonotope::from_box(&vec![0.0; n], &vec![0.01; n]);
/// let system = System::new(Relation::new(turn), small(2)?, Relation::new(distance), small(1)?)?;
///
/// let start = VPolytope::from_intervals(&IntervalVector::from_center(&[3.0, 0.5], &[0.4, 0.4])?)?;
/// let mut filter = Vh::new(system, start, VhOptions::tight())?;
/// for _ in 0..8 {
///     filter.update(&[3.0])?;
///     filter.predict(&[])?;
/// }
/// // The start has 0.64; what is not seen of the angle adds to it in every step.
/// assert!(filter.enclosure().volume()?.hi() < 0.3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Vh = SetFilter<VertexPolytopes>;

/// The [`Method`] of [`Vh`].
#[derive(Debug, Clone, Copy)]
pub struct VertexPolytopes;

/// Buffers of a [`Vh`] filter.
#[derive(Debug, Default, Clone)]
pub struct VhScratch {
    bounds: Workspace,
    noises: Vec<Interval>,
    sides: Vec<Interval>,
    culprits: Vec<Culprit>,
}

/// Set and hull of a [`Vh`] filter.
type State = FilterState<VPolytope>;

impl Method for VertexPolytopes {
    type Set = VPolytope;
    type Memory = ();
    type Options = VhOptions;
    type Scratch = VhScratch;

    fn start(
        system: &System,
        set: VPolytope,
        options: &VhOptions,
        scratch: &mut VhScratch,
    ) -> Result<State, EstimatorError> {
        let corners = u32::try_from(system.states()).ok().and_then(|n| 1_usize.checked_shl(n)).unwrap_or(usize::MAX);
        if options.vertices < corners {
            check_size("vertex budget", corners, options.vertices)?;
        }
        let set = materialized(set)?;
        let mut state = FilterState { set, hull: vec![Interval::ENTIRE; system.states()], step: 0, memory: () };
        settle(&mut state, options, scratch, &mut |_| {})?;
        Ok(state)
    }

    fn predict(
        system: &System,
        options: &VhOptions,
        input: &[Interval],
        state: &mut State,
        scratch: &mut VhScratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        state.step += 1;
        let mut moved = advance(system, options, input, state, scratch);
        if moved.as_ref().is_err_and(is_over_budget) {
            state.set = few_vertices(state, options, scratch)?;
            moved = advance(system, options, input, state, scratch);
        }
        if moved.as_ref().is_err_and(is_over_budget) {
            moved = advance_hull(system, input, state, scratch);
        }
        moved?;
        trace(Phase::Prediction);
        settle(state, options, scratch, trace)
    }

    fn correct(
        system: &System,
        options: &VhOptions,
        measured: Option<Measured<'_>>,
        state: &mut State,
        scratch: &mut VhScratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        scratch.culprits.clear();
        for pass in 1..=options.passes.max(1) {
            let before = state.hull.clone();
            if let Some(measured) = measured {
                cut(&Equation::measurement(system, measured), options, state, scratch)?;
                trace(Phase::Update);
            }
            if let Some(invariant) = Equation::invariant(system) {
                cut(&invariant, options, state, scratch)?;
                trace(Phase::Consistency);
            }
            settle(state, options, scratch, trace)?;
            let shrunk = |(new, old): (&Interval, &Interval)| new.rad() <= (1.0 - options.least_shrink) * old.rad();
            if pass == options.passes || !state.hull.iter().zip(&before).any(shrunk) {
                break;
            }
        }
        Ok(())
    }

    fn reduce(
        _system: &System,
        options: &VhOptions,
        state: &mut State,
        scratch: &mut VhScratch,
    ) -> Result<(), EstimatorError> {
        settle(state, options, scratch, &mut |_| {})
    }
}
