//! [`Zf`] and [`LinearizedZf`]: the zonotopic filter of paper 001.

use nonlin_bounds::{BoundError, Domain, Form};
use scalars::Interval;
use setrep::{Reduction, SetError, StripCut, StripRule, Zonotope};

use super::strips::refuted;
use super::{Scratch, State, renew_hull, zmv};
use crate::set_filter::{Equation, FilterState, Measured, Method, Phase, SetFilter, inconsistent};
use crate::{EstimatorError, Evidence, Guarantee, System};

/// Options of a [`Zf`] or [`LinearizedZf`]. They affect tightness and time, never validity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ZfOptions {
    /// How an intersection with a strip is chosen: `Volume` (34)-(37), `Segments` (38)-(40), or `Determinant`.
    pub rule: StripRule,
    /// Bravo's tightening: whether a strip is clipped to where the set reaches before it cuts. The paper does without.
    pub tighten: bool,
    /// How the strips of a [`Zf`] are enclosed: `Natural` evaluates (31) apart from the linear part, so that an output that is nearly
    /// affine hardly cuts at all; `MeanValue` and `Taylor` know better.
    #[cfg_attr(feature = "serde", serde(with = "crate::remote::StoredForm"))]
    pub strips: Form,
    /// Most generators after an update: the order `phi` of the paper; at least as many as states.
    pub generators: usize,
    /// How generators are reduced to so many.
    pub reduction: Reduction,
}

impl ZfOptions {
    /// The tightest of the paper's filter: least volume, tightened strips in the mean value form, Combastel's reduction (Algorithm 2.2).
    #[must_use]
    pub fn new(generators: usize) -> Self {
        Self {
            rule: StripRule::Volume,
            tighten: true,
            strips: Form::MeanValue,
            generators,
            reduction: Reduction::Combastel,
        }
    }

    /// The same with strips of their whole width, as in the paper.
    #[must_use]
    pub fn with_whole_strips(self) -> Self {
        Self { tighten: false, ..self }
    }

    /// The same with another rule for the intersection.
    #[must_use]
    pub fn with_rule(self, rule: StripRule) -> Self {
        Self { rule, ..self }
    }
}

/// Zonotopic filter (ZF): guaranteed state estimation with one zonotope, cut by one strip for every output.
///
/// ```text
/// prediction   f(c, W) + <> { J G },  J = f_x(H, W) over the hull H       (27)-(29)
/// strip i      a'x in y_i + a'x - h_i(x, V),  a = mid of h_i,x over H     (30)-(33)
/// cut          the candidate of least volume, or of least segments        (34)-(40)
/// ```
///
/// Outputs cut one after the other, each over the hull that the last one left; then the order is reduced. For a linear [`System`] the
/// prediction is exact but for rounding: the linear zonotopic filter.
///
/// A strip that misses the set is [`EstimatorError::Inconsistent`], with proof. Strips that are not
/// [tightened](ZfOptions::tighten) give larger sets that survive noises beyond their bounds now and then; tightened ones lose the
/// state for good when it has happened.
///
/// **Guarantee:** [`Guarantee::Rigorous`].
/// **Source:** paper 001, section 4.2; Alamo, Bravo, Camacho 2005; Bravo, Alamo, Camacho 2006.
///
/// ```
/// use estimators::{Estimator, Relation, System, Zf, ZfOptions};
/// use nonlin_bounds::function;
/// use setrep::Zonotope;
///
/// // A reaction 2 A <-> B of which the total pressure is measured.
/// let reaction = function!(|[a, b, w]: 3| -> 2 {
///     let net = S::decimal("0.0027") * a.sqr() - S::decimal("0.0001") * b + w;
///     [a - net.scale(2.0), b + net]
/// });
/// let pressure = function!(|[a, b, v]: 3| -> 1 { [a + b + v] });
/// let (w, v) = (Zonotope::from_box(&[0.0], &[1e-5])?, Zonotope::from_box(&[0.0], &[0.3])?);
/// let system = System::new(Relation::new(reaction), w, Relation::new(pressure), v)?;
/// let mut filter = Zf::new(system, Zonotope::from_box(&[2.5, 1.5], &[0.5, 0.5])?, ZfOptions::new(14))?;
/// let (mut a, mut b) = (3.0, 1.0);
/// for _ in 0..300 {
///     filter.step(&[], &[a + b])?;
///     let net = 0.0027 * a * a - 0.0001 * b;
///     (a, b) = (a - 2.0 * net, b + net);
/// }
/// assert!(filter.hull()[0].contains(a) && filter.hull()[1].contains(b) && filter.hull()[0].rad() < 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Zf = SetFilter<ZfMethod<false>>;

/// The [`Zf`] of the model linearised at the center of the set, again before every output: (41)-(44).
///
/// Derivatives are those at the center, the noises keep their sets; terms of second order in the error are dropped. With
/// [`StripRule::Segments`], whole strips and no reduction, its center is the estimate of an extended Kalman filter whose covariances are
/// `G G'` of the initial set and the noises, one output after the other: the gain is Kalman's, (40) is Joseph's form. The generators then
/// grow by those of both noises every step.
///
/// A tightened strip that misses the set is [`EstimatorError::Inconsistent`]: the linearised model is refuted.
///
/// **Guarantee:** [`Guarantee::FirstOrder`].
/// **Source:** paper 001, section 4.2, (43)-(44); (41)-(42) are missing in print.
pub type LinearizedZf = SetFilter<ZfMethod<true>>;

/// The [`Method`] of a [`Zf`], or of a [`LinearizedZf`].
#[derive(Debug, Clone, Copy)]
pub struct ZfMethod<const LINEARIZED: bool>;

impl<const LINEARIZED: bool> Method for ZfMethod<LINEARIZED> {
    type Set = Zonotope;
    type Memory = ();
    type Options = ZfOptions;
    type Scratch = Scratch;

    const GUARANTEE: Guarantee = if LINEARIZED { Guarantee::FirstOrder } else { Guarantee::Rigorous };

    fn start(_: &System, set: Zonotope, options: &ZfOptions, scratch: &mut Scratch) -> Result<State, EstimatorError> {
        check(options, set.dim())?;
        let hull = vec![Interval::ENTIRE; set.dim()];
        let mut state = FilterState { set, hull, step: 0, memory: () };
        state.set.materialize();
        renew_hull(false, &mut state, None, scratch)?;
        Ok(state)
    }

    fn predict(
        system: &System,
        options: &ZfOptions,
        input: &[Interval],
        state: &mut State,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        state.set.materialize_model_size();
        if state.set.num_generators() > options.generators {
            // No update came since the last prediction.
            Self::reduce(system, options, state, scratch)?;
            trace(Phase::Reduction);
        }
        if LINEARIZED {
            collapse(state);
        }
        zmv::image(system, input, state, scratch)?;
        state.set.materialize_model_size();
        state.step += 1;
        renew_hull(false, state, None, scratch)?;
        trace(Phase::Prediction);
        Ok(())
    }

    fn correct(
        system: &System,
        options: &ZfOptions,
        measured: Option<Measured<'_>>,
        state: &mut State,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        check(options, state.set.dim())?;
        state.set.materialize_model_size();
        if let Some(measured) = measured {
            cut::<LINEARIZED>(&Equation::measurement(system, measured), options, state, scratch)?;
            trace(Phase::Update);
        }
        if let Some(invariant) = Equation::invariant(system) {
            cut::<LINEARIZED>(&invariant, options, state, scratch)?;
            trace(Phase::Consistency);
        }
        Self::reduce(system, options, state, scratch)?;
        trace(Phase::Reduction);
        Ok(())
    }

    fn reduce(_: &System, options: &ZfOptions, state: &mut State, scratch: &mut Scratch) -> Result<(), EstimatorError> {
        state.set.materialize_model_size();
        state.set.reduce(options.reduction, options.generators, &mut scratch.bounds.sets)?;
        renew_hull(false, state, None, scratch)
    }
}

fn check(options: &ZfOptions, dim: usize) -> Result<(), EstimatorError> {
    let max_generators = options.generators;
    if max_generators < dim { Err(SetError::TooFewGenerators { max_generators, dim }.into()) } else { Ok(()) }
}

/// Makes the hull the center of the set: the box over which a linearised model takes its derivatives.
fn collapse(state: &mut State) {
    for (side, &center) in state.hull.iter_mut().zip(state.set.center()) {
        *side = Interval::point(center);
    }
}

/// Cuts a state with the strips of an equation, output by output. Missing outputs say nothing, and nothing is asked of them.
fn cut<const LINEARIZED: bool>(
    equation: &Equation<'_>,
    options: &ZfOptions,
    state: &mut State,
    scratch: &mut Scratch,
) -> Result<(), EstimatorError> {
    for (i, value) in equation.values.iter().enumerate().filter(|(_, value)| **value != Interval::ENTIRE) {
        let culprit = (equation.culprit)(i);
        if LINEARIZED {
            collapse(state);
        }
        scratch.about_centers(state, equation.noise)?;
        let Scratch { bounds, enclosure, stacked, rows, .. } = &mut *scratch;
        let noises = equation.noise.map_or(0, Zonotope::dim);
        let domain =
            Domain::new(&stacked.sides, &stacked.point).with_parameters(equation.parameters).with_noises(noises);
        let function = equation.relation.function();
        let enclosed = if LINEARIZED {
            enclosure.enclose_output(Form::MeanValue, function, i, &domain, bounds)
        } else {
            // One that is not smooth enough goes by its range.
            enclosure.enclose_output_at_best(options.strips, function, i, &domain, bounds)
        };
        match enclosed.and_then(|()| enclosure.rows_into(state.set.dim(), std::slice::from_ref(value), rows)) {
            // A function that is defined nowhere in the hull has no value there to be measured.
            Err(BoundError::Set(SetError::EmptySet)) if !LINEARIZED => {
                let mut required = vec![Interval::ENTIRE; equation.values.len()];
                required[i] = *value;
                let (hull, parameters) = (state.hull.clone(), equation.parameters.to_vec());
                let evidence = Evidence::Values { hull, invariant: equation.noise.is_none(), required, parameters };
                return Err(inconsistent(state.step, vec![culprit], evidence));
            }
            result => result?,
        }
        let Some(&range) = rows.ranges().first() else { continue };
        let (direction, sets) = (rows.directions().as_slice(), &mut bounds.sets);
        // The row of an output that is not smooth has no direction: its range is right or wrong as it is.
        let whole = !options.tighten && range.is_bounded() && direction.iter().any(|&a| a != 0.0);
        if whole && !LINEARIZED {
            let reach = state.set.reach(direction, sets)?;
            if reach.disjoint(&range) {
                return Err(refuted(state.step, Some(culprit), reach, range));
            }
        }
        let answer = if whole {
            state.set.intersect_whole_strip(direction, range, options.rule, sets)?
        } else {
            state.set.intersect_strip(direction, range, options.rule, sets)?
        };
        match answer {
            StripCut::ProvenEmpty { reach } => return Err(refuted(state.step, Some(culprit), reach, range)),
            StripCut::Unchanged if !LINEARIZED => {}
            StripCut::Unchanged | StripCut::Cut => renew_hull(false, state, Some(culprit), scratch)?,
        }
    }
    Ok(())
}
