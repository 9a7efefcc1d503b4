//! [`Vh`]: the direct polytopic filter of paper 004, on vertices.

use std::borrow::Cow;

use nonlin_bounds::{
    BoundError, Expansion, PolytopicCut, RangeMethod, Workspace, polytopic_image_with_noise, polytopic_strips, range,
};
use scalars::Interval;
use scalars::rounding::sub_down;
use setrep::{Matrix, SetError, VPolytope, Zonotope};

use super::noise::beside;
use crate::error::check_size;
use crate::set_filter::inconsistent;
use crate::system::Relation;
use crate::{Culprit, EstimatorError, Evidence, FilterState, Measured, Method, Phase, SetFilter, System};

/// New vertices that lie in the hull of the others up to this share of the set's extents are dropped.
const THIN: f64 = 1e-12;

/// Guaranteed state estimation with polytopes in vertex form (V-H).
///
/// - **Prediction.** Each vertex becomes the box `f(x_0) + [J] (v - x_0)` plus noise, `[J]` the range of the Jacobian over the hull of the set; the set is
///   the hull of these boxes.
/// - **Update.** With `x` a convex combination of the vertices, each bound of an output bounds the combination of its least values at
///   the vertices. This simplex of weights is cut along its edges, so no facets are needed: what the paper does by a conversion in
///   the space of the outputs, a projection and one more conversion. The invariant joins every update.
/// - **Vertex budget.** A set with more vertices than [`VhOptions::vertices`] is enclosed by [`VPolytope::enclosed_within`]: half-spaces
///   among its own facets and principal directions, as many as can meet in so many points.
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
/// assert!(filter.enclosure().volume()?.hi() < 0.08);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Vh = SetFilter<VertexPolytopes>;

/// The [`Method`] of [`Vh`].
#[derive(Debug, Clone, Copy)]
pub struct VertexPolytopes;

/// What a [`Vh`] filter may spend. The options affect tightness and time, never validity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct VhOptions {
    /// Most vertices of a set after a call, at least the `2^n` of a box.
    pub vertices: usize,
    /// Most passes of an update, each with the Jacobian over the hull that the last one has left.
    pub passes: usize,
    /// Passes end when no side of the hull has shrunk by this share.
    pub least_shrink: f64,
    /// Cut the prediction with the range of the dynamics by [`RangeMethod::Tight`].
    pub tight_range: bool,
}

impl VhOptions {
    /// As in paper 004: one pass. At most 200 vertices, where the paper has no limit.
    #[must_use]
    pub fn paper() -> Self {
        Self { vertices: 200, passes: 1, least_shrink: 0.02, tight_range: false }
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
        let VhScratch { bounds, noises, sides, .. } = scratch;
        let f = system.dynamics().function();
        let set = beside(&state.set, system.process_noise(), noises)?;
        let mut image = polytopic_image_with_noise(f, &set, noises, Expansion::HullCenter, input, bounds)?;
        if options.tight_range {
            let domain: Vec<Interval> = set.interval_hull().iter().chain(noises.iter()).copied().collect();
            sides.clear();
            sides.resize(f.outputs(), Interval::ENTIRE);
            range(f, &domain, input, RangeMethod::Tight, bounds, sides)?;
            image = within(image, sides).map_err(|error| match error {
                SetError::EmptySet => {
                    inconsistent(state.step, vec![], Evidence::Propagation { hull: state.hull.clone() })
                }
                error => error.into(),
            })?;
        }
        state.set = image;
        state.step += 1;
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
            if let Some(Measured { values, parameters }) = measured {
                let equation = Equation {
                    relation: system.measurement(),
                    noise: Some(system.measurement_noise()),
                    values,
                    parameters,
                    culprit: Culprit::Measurement,
                };
                equation.cut(options, state, scratch)?;
                trace(Phase::Update);
            }
            if let Some(invariant) = system.invariant() {
                let (relation, values) = (invariant.relation(), invariant.range());
                let equation = Equation { relation, noise: None, values, parameters: &[], culprit: Culprit::Invariant };
                equation.cut(options, state, scratch)?;
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

/// A function and the values that it takes.
struct Equation<'a> {
    relation: &'a Relation,
    noise: Option<&'a Zonotope>,
    values: &'a [Interval],
    parameters: &'a [Interval],
    culprit: fn(usize) -> Culprit,
}

impl Equation<'_> {
    /// Cuts a state, which is enclosed in a smaller one before where its vertices are too many to be cut.
    fn cut(&self, options: &VhOptions, state: &mut State, scratch: &mut VhScratch) -> Result<(), EstimatorError> {
        match self.try_cut(state, scratch) {
            Err(EstimatorError::Bound(BoundError::Set(SetError::OverBudget { .. }))) => {
                let few = (options.vertices / 4).max(1 << state.hull.len());
                state.set = state.set.enclosed_within(few, &mut scratch.bounds.sets)?;
                self.try_cut(state, scratch)
            }
            result => result,
        }
    }

    fn try_cut(&self, state: &mut State, scratch: &mut VhScratch) -> Result<(), EstimatorError> {
        let VhScratch { bounds, noises, culprits, .. } = scratch;
        noises.clear();
        let set = match self.noise {
            Some(noise) => beside(&state.set, noise, noises)?,
            None => Cow::Borrowed(&state.set),
        };
        let (g, n) = (self.relation.function(), state.hull.len());
        let cut = polytopic_strips(g, (&set, noises), self.values, Expansion::HullCenter, self.parameters, bounds)?;
        match cut {
            PolytopicCut::Left(solution) if solution.dim() > n => {
                let mut states = Matrix::zeros(n, n + self.noise.map_or(0, Zonotope::dim));
                (0..n).for_each(|k| states[(k, k)] = 1.0);
                state.set = solution.linear_map(&states)?.thinned(THIN);
            }
            PolytopicCut::Left(solution) => state.set = solution,
            PolytopicCut::ProvenEmpty { output, reach } => {
                culprits.extend((0..=output).map(self.culprit));
                let evidence = Evidence::Disjoint { predicted: reach, required: self.values[output] };
                return Err(inconsistent(state.step, core::mem::take(culprits), evidence));
            }
        }
        culprits.extend((0..self.values.len()).map(self.culprit));
        Ok(())
    }
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
