//! [`Vh`]: the direct polytopic filter of paper 004, on vertices.

use std::borrow::Cow;

use nonlin_bounds::{
    BoundError, Expansion, PolytopicCut, RangeMethod, Workspace, polytopic_image_with_noise, polytopic_strips, range,
};
use scalars::Interval;
use scalars::rounding::sub_down;
use setrep::{Matrix, SetError, VPolytope};

use super::forms::materialized;
use super::noise::beside;
use crate::error::check_size;
use crate::set_filter::{Equation, inconsistent};
use crate::{Culprit, EstimatorError, Evidence, FilterState, Measured, Method, Phase, SetFilter, System};

/// New vertices that lie in the hull of the others up to this share of the set's extents are dropped.
const THIN: f64 = 1e-10;

/// Guaranteed state estimation with polytopes in vertex form (V-H).
///
/// - **Prediction.** Each vertex becomes the box `f(x_0) + [J] (v - x_0)` plus noise, about a point `x_0` by [`VhOptions::center`] and with `[J]` the range of the Jacobian over the hull of the set; the set is
///   the hull of these boxes.
/// - **Update.** With `x` a convex combination of the vertices, each bound of an output bounds the combination of its least values at
///   the vertices. This simplex of weights is cut along its edges, so no facets are needed: what the paper does by a conversion in
///   the space of the outputs, a projection and one more conversion. The invariant joins every update.
/// - **Vertex budget.** A set with more vertices than [`VhOptions::vertices`] is enclosed by [`VPolytope::enclosed_within`]: half-spaces
///   among its own facets and principal directions, as many as can meet in so many points. A set with too many vertices for a step is
///   enclosed in one with a quarter of the budget before; at worst a prediction is the box of [`range()`], and an update leaves the set.
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

/// What a [`Vh`] filter may spend. The options affect tightness and time, never validity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VhOptions {
    /// Most vertices of a set after a call, at least the `2^n` of a box.
    pub vertices: usize,
    /// Most passes of an update, each with the Jacobian over the hull that the last one has left.
    pub passes: usize,
    /// Passes end when no side of the hull has shrunk by this share.
    pub least_shrink: f64,
    /// Cut the prediction with the range of the dynamics by [`RangeMethod::Tight`].
    pub tight_range: bool,
    /// The points about which functions are expanded.
    pub center: VhCenter,
}

/// The point of a set about which a [`Vh`] filter expands functions; any point is valid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum VhCenter {
    /// The mean of the vertices, which lies inside of the set as paper 004 asks.
    #[default]
    VertexMean,
    /// The middle of the interval hull, which makes `|v - x_0|` least coordinate by coordinate; [`WidthBound::Centered`](crate::WidthBound::Centered)
    /// is for it.
    HullCenter,
}

impl VhCenter {
    fn expansion(self) -> Expansion<'static> {
        match self {
            Self::VertexMean => Expansion::SetCenter,
            Self::HullCenter => Expansion::HullCenter,
        }
    }
}

impl VhOptions {
    /// As in paper 004: one pass. At most 64 vertices, where the paper has no limit.
    #[must_use]
    pub fn paper() -> Self {
        Self { vertices: 64, passes: 1, least_shrink: 0.02, tight_range: false, center: VhCenter::VertexMean }
    }

    /// Up to three passes, and the tight range.
    #[must_use]
    pub fn tight() -> Self {
        Self { passes: 3, tight_range: true, ..Self::paper() }
    }
}

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

/// Whether a set had too many vertices for a step.
fn is_over_budget(error: &EstimatorError) -> bool {
    matches!(
        error,
        EstimatorError::Bound(BoundError::Set(SetError::OverBudget { .. }))
            | EstimatorError::Set(SetError::OverBudget { .. })
    )
}

/// Moves the hull of a state on, as a box.
fn advance_hull(
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
fn advance(
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
fn few_vertices(state: &State, options: &VhOptions, scratch: &mut VhScratch) -> Result<VPolytope, EstimatorError> {
    let corners = 1_usize.checked_shl(u32::try_from(state.hull.len()).unwrap_or(u32::MAX)).unwrap_or(usize::MAX);
    let few = (options.vertices / 4).max(corners);
    Ok(state.set.enclosed_within(few, &mut scratch.bounds.sets)?)
}

/// Cuts a state; where its vertices are too many for that it is enclosed in a smaller one first, and stays at worst as it is.
fn cut(
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
fn settle(
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
