//! [`ZonotopeFilter`]: the zonotope filters that paper 003 compares with.

mod options;
mod scratch;
mod strips;
mod zf;
mod zfo;
mod zmv;

pub use options::{StripForm, ZonotopeOptions};
use scalars::Interval;
use setrep::{SetError, Zonotope};
pub use zf::{LinearizedZf, Zf, ZfMethod, ZfOptions};

use crate::set_filter::{Equation, FilterState, Measured, Method, Phase, SetFilter, check_strips};
use crate::{Culprit, EstimatorError, Extension, System};
use scratch::Scratch;

/// Guaranteed state estimation with zonotopes: ZMV and ZFO of paper 003, each with an enclosure of the feasible states (+F), with the invariant
/// (+C), or with both, by [`ZonotopeOptions`].
///
/// - **Prediction**: the image of the set under the dynamics about its center, by the mean value theorem (ZMV) or by Taylor's theorem of first
///   order (ZFO).
/// - **Update**: output by output a strip over the hull of the set ([`StripForm`]), clipped to the set, and the candidate of least
///   determinant for the intersection ([`Zonotope::intersect_strip`]).
/// - **+F**: intersections with strips that hold every state (Remark 11).
/// - **+C**: strips of the invariant, as in the update.
/// - **Reduction** once, at the end of an update.
///
/// The strips of the paper hardly ever cut, so that its ZMV and ZFO are little more than predictions, and diverge where the filters with
/// constrained zonotopes do not. With [`with_rows`](ZonotopeOptions::with_rows) they follow what is measured, without linear
/// programs. For the tightest sets take [`Rcz`](crate::Rcz).
///
/// **Guarantee:** [`Guarantee::Rigorous`](crate::Guarantee::Rigorous).
/// **Source:** Alamo, Bravo, Camacho 2005 (mean value prediction, strips); Combastel 2005 (prediction by Taylor's theorem); Bravo, Alamo,
/// Camacho 2006 (intersection); paper 003, Section 5 (names, settings).
///
/// ```
/// use estimators::{Estimator, Relation, System, ZonotopeFilter, ZonotopeOptions};
/// use nonlin_bounds::function;
/// use setrep::Zonotope;
///
/// // A point that turns on a circle by 0.1 rad a step and is drawn to its middle: variables (x, y, pull).
/// let turn = function!(|[x, y, w]: 3| -> 2 {
///     let (cos, sin) = (S::decimal("0.1").cos(), S::decimal("0.1").sin());
///     let shrink = S::decimal("0.9") - w;
///     [shrink * (cos * x - sin * y), shrink * (sin * x + cos * y)]
/// });
/// // One coordinate is measured, with an error that grows with it: variables (x, y, error).
/// let seen = function!(|[x, _y, v]: 3| -> 1 { [x + x.sqr() * v] });
///
/// let (pull, error) = (Zonotope::from_box(&[0.0], &[0.05])?, Zonotope::from_box(&[0.0], &[0.02])?);
/// let system = System::new(Relation::new(turn), pull, Relation::new(seen), error)?;
/// let start = Zonotope::from_box(&[1.0, 0.0], &[0.3, 0.3])?;
/// let mut filter = ZonotopeFilter::new(system, start, ZonotopeOptions::zmv(10).with_rows())?;
/// let (mut x, mut y) = (1.2_f64, 0.1_f64);
/// for _ in 0..10 {
///     filter.update(&[x])?;
///     filter.predict(&[])?;
///     let (cos, sin) = (0.1_f64.cos(), 0.1_f64.sin());
///     (x, y) = (0.9 * (cos * x - sin * y), 0.9 * (sin * x + cos * y));
/// }
/// assert!(filter.hull()[0].contains(x) && filter.hull()[1].contains(y));
/// assert!(filter.hull()[0].rad() < 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type ZonotopeFilter = SetFilter<ZonotopicMethod>;

/// The [`Method`] of a [`ZonotopeFilter`].
#[derive(Debug, Clone, Copy)]
pub struct ZonotopicMethod;

/// The state of a [`ZonotopeFilter`] between calls.
type State = FilterState<Zonotope>;

impl Method for ZonotopicMethod {
    type Set = Zonotope;
    type Memory = ();
    type Options = ZonotopeOptions;
    type Scratch = Scratch;

    fn start(
        _: &System,
        set: Zonotope,
        options: &ZonotopeOptions,
        scratch: &mut Scratch,
    ) -> Result<State, EstimatorError> {
        let n = set.dim();
        check_strips(n, &options.feasible)?;
        if options.generators < n {
            return Err(SetError::TooFewGenerators { max_generators: options.generators, dim: n }.into());
        }
        let hull = vec![Interval::ENTIRE; n];
        let mut state = State { set, hull, step: 0, memory: () };
        renew_hull(false, &mut state, None, scratch)?;
        Ok(state)
    }

    fn predict(
        system: &System,
        options: &ZonotopeOptions,
        input: &[Interval],
        state: &mut State,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        state.set.materialize_model_size();
        if state.set.num_generators() > options.generators {
            // No update came since the last prediction.
            reduce(options, state, scratch)?;
            trace(Phase::Reduction);
        }
        match options.extension {
            Extension::MeanValue => zmv::image(system, input, state, scratch)?,
            Extension::FirstOrder => zfo::image(system, input, state, scratch)?,
        }
        state.step += 1;
        renew_hull(false, state, None, scratch)?;
        trace(Phase::Prediction);
        Ok(())
    }

    fn correct(
        system: &System,
        options: &ZonotopeOptions,
        measured: Option<Measured<'_>>,
        state: &mut State,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        check_strips(state.set.dim(), &options.feasible)?;
        if let Some(measured) = measured {
            strips::cut(&Equation::measurement(system, measured), options, state, scratch)?;
            trace(Phase::Update);
        }
        let invariant = Equation::invariant(system).filter(|_| options.consistency || measured.is_none());
        if invariant.is_some() || !options.feasible.is_empty() {
            for (i, strip) in options.feasible.iter().enumerate() {
                strips::cut_by(strip.direction(), strip.range(), Culprit::Feasible(i), options, state, scratch)?;
            }
            if let Some(invariant) = invariant {
                strips::cut(&invariant, options, state, scratch)?;
            }
            trace(Phase::Consistency);
        }
        reduce(options, state, scratch)?;
        trace(Phase::Reduction);
        Ok(())
    }

    fn reduce(
        _: &System,
        options: &ZonotopeOptions,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> Result<(), EstimatorError> {
        reduce(options, state, scratch)
    }
}

/// Encloses the set in one of at most `options.generators` generators.
fn reduce(options: &ZonotopeOptions, state: &mut State, scratch: &mut Scratch) -> Result<(), EstimatorError> {
    state.set.materialize_model_size();
    state.set.reduce(options.reduction, options.generators, &mut scratch.bounds.sets)?;
    renew_hull(options.keep_hull, state, None, scratch)
}

/// Writes the hull of the set to the state, cut with the one held if that is to be kept; `culprit` is what changed the set.
fn renew_hull(
    keep: bool,
    state: &mut State,
    culprit: Option<Culprit>,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    let own = &mut scratch.own;
    own.clear();
    own.resize(state.hull.len(), Interval::EMPTY);
    state.set.interval_hull_into(own)?;
    if let Some(row) = own.iter().position(|side| !side.is_bounded()) {
        return Err(SetError::Overflow { row }.into());
    }
    for (side, &found) in state.hull.iter_mut().zip(own.iter()) {
        if keep && side.disjoint(&found) {
            return Err(strips::refuted(state.step, culprit, *side, found));
        }
        *side = if keep { side.intersection(found) } else { found };
    }
    Ok(())
}
