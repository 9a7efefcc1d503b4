//! [`CzFilter`]: the constrained-zonotope filters of paper 003.

mod czfo;
mod czmv;
mod options;
mod policy;
mod scratch;

use nonlin_bounds::BoundError;
pub use options::{Curvature, CzOptions, Extension, Inclusion};
pub use policy::{ReduceAfter, ReductionPolicy};
use scalars::Interval;
use setrep::{ConstrainedZonotope, SetError, Strip};

use crate::set_filter::{Equation, FilterState, Measured, Method, Phase, SetFilter, check_strips, of_hull, of_values};
use crate::{Culprit, EstimatorError, System};
use scratch::Scratch;

/// Guaranteed state estimation with constrained zonotopes as in paper 003: CZMV and CZFO, each with the consistency step (+C), with an
/// enclosure of the feasible states (+F), or with both (+FC), by [`CzOptions`].
///
/// - **Prediction**: the image of the set under the dynamics, by the mean value theorem (Proposition 1) or by Taylor's theorem of first order
///   (Proposition 2).
/// - **Update**: generalised intersection with the states that agree with the measurement (Propositions 3 and 4).
/// - **+F**: intersection with strips that hold every state (Remark 11).
/// - **Consistency**, +C: intersection with the states that fulfil the invariant (Corollaries 1 and 2), whose range may have a width
///   (Remark 13).
/// - **Reduction** by [`ReductionPolicy`]: constraints first, then generators.
///
/// Sets have ranged constraints, so that a measurement adds a row and no slack generators; everything else is the paper's, with its slips
/// mended (generalised intersection with its missing row, symmetric `Q` in Lemma 2) and all rounding enclosed. For tighter sets at a fraction of the
/// time take [`Rcz`](crate::Rcz).
///
/// **Guarantee:** [`Guarantee::Rigorous`](crate::Guarantee::Rigorous).
/// **Source:** paper 003, Algorithm 1; Section 4.4 for the expansion points, Section 5 for names and policies.
///
/// ```
/// use estimators::{CzFilter, CzOptions, Estimator, Relation, System};
/// use nonlin_bounds::{Function, function};
/// use scalars::{Interval, Scalar};
/// use setrep::{Complexity, ConstrainedZonotope, Zonotope};
///
/// // A point that turns on the unit circle by 0.1 rad a step, and a little more or less: variables (x, y, excess).
/// let turn = function!(|[x, y, w]: 3| -> 2 {
///     let (cos, sin) = ((w + S::decimal("0.1")).cos(), (w + S::decimal("0.1")).sin());
///     [cos * x - sin * y, sin * x + cos * y]
/// });
/// // The product of its coordinates is measured, with an error: variables (x, y, error).
/// let product = function!(|[x, y, v]: 3| -> 1 { [x * y + v] });
/// let circle = function!(|[x, y]: 2| -> 1 { [x.sqr() + y.sqr()] });
///
/// let (excess, error) = (Zonotope::from_box(&[0.0], &[0.01])?, Zonotope::from_box(&[0.0], &[0.02])?);
/// let system = System::new(Relation::new(turn), excess, Relation::new(product), error)?
///     .with_invariant(Relation::new(circle), vec![Interval::ONE])?;
/// let start = ConstrainedZonotope::from_box(&[1.0, 0.0], &[0.2, 0.2])?;
/// let limit = Complexity { generators: 8, constraints: 3 };
/// let mut filter = CzFilter::new(system, start, CzOptions::czfo(Some(limit)).with_consistency())?;
/// for k in 0..10 {
///     if k > 0 {
///         filter.predict(&[])?;
///     }
///     let angle = 0.1 * f64::from(k);
///     filter.update(&[angle.cos() * angle.sin()])?;
///     assert!(filter.hull()[0].contains(angle.cos()) && filter.hull()[1].contains(angle.sin()));
/// }
/// assert!(filter.hull()[1].rad() < 0.06);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type CzFilter = SetFilter<ConstrainedMethod>;

/// The [`Method`] of a [`CzFilter`].
#[derive(Debug, Clone, Copy)]
pub struct ConstrainedMethod;

/// The state of a [`CzFilter`] between calls.
type State = FilterState<ConstrainedZonotope>;

impl Method for ConstrainedMethod {
    type Set = ConstrainedZonotope;
    type Memory = ();
    type Options = CzOptions;
    type Scratch = Scratch;

    fn start(
        _: &System,
        set: ConstrainedZonotope,
        options: &CzOptions,
        scratch: &mut Scratch,
    ) -> Result<State, EstimatorError> {
        let n = set.dim();
        check_strips(n, &options.feasible)?;
        if let Some(limit) = options.reduction.limit.filter(|limit| limit.generators < n) {
            return Err(SetError::TooFewGenerators { max_generators: limit.generators, dim: n }.into());
        }
        let hull = set.interval_hull(&mut scratch.bounds.sets)?.to_vec();
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet.into());
        }
        Ok(State { set, hull, step: 0, memory: () })
    }

    fn predict(
        system: &System,
        options: &CzOptions,
        input: &[Interval],
        state: &mut State,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        if options.reduction.is_exceeded(&state.set) {
            options.reduction.apply(&mut state.set, &mut scratch.bounds.sets)?;
            trace(Phase::Reduction);
        }
        let image = match options.extension {
            Extension::MeanValue => czmv::image,
            Extension::FirstOrder => czfo::image,
        };
        let dynamics = (system.dynamics(), system.process_noise());
        image(dynamics, options, input, (&mut state.set, &state.hull), scratch)?;
        state.step += 1;
        trace(Phase::Prediction);
        scratch.culprits.clear();
        // What the hull held is of the step before.
        state.hull.fill(Interval::ENTIRE);
        if options.reduction.after == ReduceAfter::EveryPart {
            reduce(options, state, scratch, trace)?;
        }
        renew_hull(options, state, scratch)?;
        trace(Phase::Prediction);
        Ok(())
    }

    fn correct(
        system: &System,
        options: &CzOptions,
        measured: Option<Measured<'_>>,
        state: &mut State,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        check_strips(state.set.dim(), &options.feasible)?;
        scratch.culprits.clear();
        scratch.culprits.resize(state.set.num_constraints(), Culprit::Prediction);
        if let Some(measured) = measured {
            cut(&Equation::measurement(system, measured), options, state, scratch)?;
            trace(Phase::Update);
        }
        let invariant = Equation::invariant(system).filter(|_| options.consistency || measured.is_none());
        let refines = invariant.is_some() || !options.feasible.is_empty();
        if refines {
            if measured.is_some() && options.reduction.after == ReduceAfter::EveryPart {
                reduce(options, state, scratch, trace)?;
            }
            cut_by_strips(&options.feasible, state, scratch)?;
            if let Some(invariant) = invariant {
                renew_hull(options, state, scratch)?;
                cut(&invariant, options, state, scratch)?;
            }
            trace(Phase::Consistency);
        }
        reduce(options, state, scratch, trace)?;
        renew_hull(options, state, scratch)?;
        trace(if refines { Phase::Consistency } else { Phase::Update });
        Ok(())
    }

    fn reduce(_: &System, options: &CzOptions, state: &mut State, scratch: &mut Scratch) -> Result<(), EstimatorError> {
        Ok(options.reduction.apply(&mut state.set, &mut scratch.bounds.sets)?)
    }
}

/// Cuts the set with the solutions of an equation, over its hull.
fn cut(
    equation: &Equation<'_>,
    options: &CzOptions,
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let cut = match options.extension {
        Extension::MeanValue => czmv::cut,
        Extension::FirstOrder => czfo::cut,
    };
    match cut(equation, options, (&mut state.set, &state.hull), scratch) {
        // A function that is defined nowhere in the hull has no value there to be measured.
        Err(EstimatorError::Bound(BoundError::Set(SetError::EmptySet))) => {
            let Scratch { bounds, culprits, .. } = scratch;
            Err(of_values(state, &state.set, (equation, equation.culprits(None)), culprits, &mut bounds.sets))
        }
        result => result,
    }
}

/// Intersects the set with strips.
fn cut_by_strips(strips: &[Strip], state: &mut State, scratch: &mut Scratch) -> Result<(), EstimatorError> {
    if strips.is_empty() {
        return Ok(());
    }
    let Scratch { bounds, map, ranges, culprits, .. } = scratch;
    map.reset(strips.len(), state.set.dim());
    ranges.clear();
    for (row, strip) in strips.iter().enumerate() {
        strip.direction().iter().enumerate().for_each(|(k, &a)| map[(row, k)] = a);
        ranges.push(strip.range());
        culprits.push(Culprit::Feasible(row));
    }
    Ok(state.set.intersect_rows(map, ranges, &mut bounds.sets)?)
}

/// Reduces the set if that is due, unless it is empty: a smaller form would no longer say why.
fn reduce(
    options: &CzOptions,
    state: &mut State,
    scratch: &mut Scratch,
    trace: &mut dyn FnMut(Phase),
) -> Result<(), EstimatorError> {
    if options.reduction.is_exceeded(&state.set) && state.set.is_proven_empty(&mut scratch.bounds.sets)? {
        return renew_hull(options, state, scratch);
    }
    options.reduction.apply(&mut state.set, &mut scratch.bounds.sets)?;
    trace(Phase::Reduction);
    Ok(())
}

/// Writes the hull of the set to the state.
fn renew_hull(options: &CzOptions, state: &mut State, scratch: &mut Scratch) -> Result<(), EstimatorError> {
    let Scratch { bounds, own, culprits, .. } = scratch;
    own.clear();
    own.resize(state.hull.len(), Interval::EMPTY);
    state.set.interval_hull_into(own, &mut bounds.sets)?;
    if own.iter().zip(&state.hull).any(|(own, held)| own.disjoint(held)) {
        return Err(of_hull(state.step, &state.set, (own, &state.hull), culprits, &mut bounds.sets));
    }
    for (side, &found) in state.hull.iter_mut().zip(own.iter()) {
        *side = if options.keep_hull { side.intersection(found) } else { found };
    }
    Ok(())
}
