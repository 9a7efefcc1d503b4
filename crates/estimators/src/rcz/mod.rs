//! [`Rcz`]: the default guaranteed filter, on ranged constrained zonotopes.

mod contradiction;
mod correct;
mod equation;
mod options;
mod predict;
mod scratch;
mod state;

pub use options::{RczOptions, Tier};
use scalars::Interval;
use setrep::ConstrainedZonotope;
pub use state::RczState;

use crate::error::{check_finite, check_size};
use crate::{Culprit, Estimator, EstimatorError, Guarantee, System};
use equation::Equation;
use scratch::Scratch;

/// Guaranteed state estimation with ranged constrained zonotopes: tight, and a few dozen small linear programs a step.
///
/// - **Prediction.** The dynamics are enclosed by an affine function about the middle of the hull with the one-sided remainder of second
///   order; the set is mapped, the noise keeps its shape.
/// - **Update.** Up to three passes of: propagation of the hull through measurement and invariant; rows of both with their remainders
///   over the hull; the hull of the set with these rows, by certified linear programs. The invariant joins every update.
/// - **Reduction.** LP re-encoding ([`ConstrainedZonotope::reencode`]) before a prediction, every step or every few, and before an update
///   if many have come without a prediction.
///
/// A call that fails leaves the filter as it was, a proven contradiction ([`EstimatorError::Inconsistent`]) included: the predicted set
/// is kept, and the caller may go on without the measurement. A step in steady state allocates nothing, unless the measurement noise mixes
/// the outputs (its generators are then copied).
///
/// **Guarantee:** [`Guarantee::Rigorous`]. If the first state lies in the initial set, noises keep their bounds and the invariant holds,
/// every state lies in [`enclosure`](Estimator::enclosure) and in [`hull`](Self::hull), remainders and rounding included.
/// **Source:** ours; parts are those of paper 003 (Propositions 2 and 4 in the form with ranges, Section 4.4).
///
/// ```
/// use estimators::{Estimator, Rcz, RczOptions, Relation, System};
/// use nonlin_bounds::Function;
/// use scalars::Scalar;
/// use setrep::{ConstrainedZonotope, Zonotope};
///
/// /// A pendulum with friction, pushed a little by the wind: angle and rate, variables `(angle, rate, wind)`.
/// struct Swing;
/// impl Function for Swing {
///     fn variables(&self) -> usize { 3 }
///     fn outputs(&self) -> usize { 2 }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
///         let dt = S::decimal("0.05");
///         y[0] = x[0] + dt * x[1];
///         y[1] = x[1] - dt * (x[0].sin().scale(4.0) + x[1].scale(0.5)) + dt * x[2];
///     }
/// }
/// /// Its height is seen, with an error: variables `(angle, rate, error)`.
/// struct Height;
/// impl Function for Height {
///     fn variables(&self) -> usize { 3 }
///     fn outputs(&self) -> usize { 1 }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) { y[0] = S::one() - x[0].cos() + x[2]; }
/// }
///
/// let wind = Zonotope::from_box(&[0.0], &[0.01])?;
/// let error = Zonotope::from_box(&[0.0], &[0.01])?;
/// let system = System::new(Relation::new(Swing), wind, Relation::new(Height), error)?;
/// let start = ConstrainedZonotope::from_box(&[0.5, 0.0], &[0.3, 0.3])?;
/// let mut filter = Rcz::new(system, start, RczOptions::fast(2))?;
///
/// let (mut angle, mut rate) = (0.6_f64, 0.1_f64);
/// for _ in 0..40 {
///     filter.update(&[1.0 - angle.cos()])?;
///     filter.predict(&[])?;
///     (angle, rate) = (angle + 0.05 * rate, rate - 0.05 * (4.0 * angle.sin() + 0.5 * rate));
/// }
/// assert!(filter.hull()[0].contains(angle) && filter.hull()[1].contains(rate));
/// assert!(filter.hull()[0].rad() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Rcz {
    system: System,
    options: RczOptions,
    state: RczState,
    /// The state of the call that is under way, and the one to come back to.
    draft: RczState,
    saved: RczState,
    values: Vec<Interval>,
    parameters: Vec<Interval>,
    scratch: Scratch,
}

impl Rcz {
    /// A filter that starts with `x_0` in `initial`.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if `initial` is not of the system's dimension; [`EstimatorError::Set`] if it is proven empty.
    pub fn new(system: System, initial: ConstrainedZonotope, options: RczOptions) -> Result<Self, EstimatorError> {
        check_size("initial set", system.states(), initial.dim())?;
        let mut scratch = Scratch::default();
        let state = RczState::new(initial, &mut scratch.bounds.sets)?;
        let (draft, saved) = (state.clone(), state.clone());
        Ok(Self { system, options, state, draft, saved, values: vec![], parameters: vec![], scratch })
    }

    /// The system.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The system, whose dynamics, measurement and noises may be replaced between calls.
    pub fn system_mut(&mut self) -> &mut System {
        &mut self.system
    }

    /// The options, which may be changed between calls.
    pub fn options_mut(&mut self) -> &mut RczOptions {
        &mut self.options
    }

    /// A box that contains the state.
    #[must_use]
    pub fn hull(&self) -> &[Interval] {
        &self.state.hull
    }

    /// All that has to be saved to go on later.
    #[must_use]
    pub fn state(&self) -> &RczState {
        &self.state
    }

    /// Goes on from a state that was saved, or from a set known otherwise.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if its parts are not of the system's dimension, [`EstimatorError::EmptyRange`] and
    /// [`EstimatorError::NotFinite`] if its hull is empty or unbounded; the filter is then unchanged.
    pub fn restore(&mut self, state: &RczState) -> Result<(), EstimatorError> {
        let n = self.system.states();
        check_size("saved set", n, state.set.dim())?;
        check_size("saved hull", n, state.hull.len())?;
        check_size("saved directions", n, state.directions.dim())?;
        if let Some(index) = state.hull.iter().position(Interval::is_empty) {
            return Err(EstimatorError::EmptyRange { what: "saved hull", index });
        }
        if let Some(index) = state.hull.iter().position(|side| !side.is_bounded()) {
            return Err(EstimatorError::NotFinite { what: "saved hull", index, value: state.hull[index].mag() });
        }
        self.state.clone_from(state);
        Ok(())
    }

    /// [`update`](Estimator::update) for a measurement with parameters `p`, of which some entries may be missing.
    ///
    /// # Errors
    /// As [`update`](Estimator::update).
    pub fn update_some(&mut self, output: &[Option<f64>], p: &[f64]) -> Result<(), EstimatorError> {
        let g = self.system.measurement().function();
        check_size("measurement", g.outputs(), output.len())?;
        check_size("parameters of the measurement", g.parameters(), p.len())?;
        check_finite("parameters of the measurement", p)?;
        if let Some(index) = output.iter().position(|y| y.is_some_and(|y| !y.is_finite())) {
            let value = output[index].unwrap_or(f64::NAN);
            return Err(EstimatorError::NotFinite { what: "measurement", index, value });
        }
        self.values.clear();
        self.values.extend(output.iter().map(|y| y.map_or(Interval::ENTIRE, Interval::point)));
        self.parameters.clear();
        self.parameters.extend(p.iter().map(|&p| Interval::point(p)));
        self.correct(true)
    }

    /// Encloses the set in a small one now, instead of before the next prediction.
    ///
    /// # Errors
    /// [`EstimatorError::Set`] if an entry overflows; the filter is then unchanged.
    pub fn reduce(&mut self) -> Result<(), EstimatorError> {
        self.draft.clone_from(&self.state);
        self.draft.reduce(&self.options, &mut self.scratch.bounds.sets)?;
        core::mem::swap(&mut self.state, &mut self.draft);
        Ok(())
    }

    /// Cuts the state with the values at hand (if `measured`) and the invariant.
    fn correct(&mut self, measured: bool) -> Result<(), EstimatorError> {
        let Self { system, options, state, draft, values, parameters, scratch, .. } = self;
        let measurement = measured.then_some(Equation {
            relation: system.measurement(),
            noise: Some(system.measurement_noise()),
            values,
            parameters,
            culprit: Culprit::Measurement,
        });
        let invariant = system.invariant().map(|invariant| Equation {
            relation: invariant.relation(),
            noise: None,
            values: invariant.range(),
            parameters: &[],
            culprit: Culprit::Invariant,
        });
        draft.clone_from(state);
        let rows = [&measurement, &invariant].into_iter().flatten().map(|equation| equation.values.len()).sum();
        if draft.is_crowded(options, rows) {
            draft.reduce(options, &mut scratch.bounds.sets)?;
        }
        match (measurement, invariant) {
            (Some(measurement), Some(invariant)) => {
                correct::correct(&[measurement, invariant], options, draft, scratch)?;
            }
            (Some(only), None) | (None, Some(only)) => correct::correct(&[only], options, draft, scratch)?,
            (None, None) => return Ok(()),
        }
        core::mem::swap(state, draft);
        Ok(())
    }
}

impl Estimator for Rcz {
    type Input = [f64];
    type Output = [f64];
    type Set = ConstrainedZonotope;

    fn predict(&mut self, input: &[f64]) -> Result<(), EstimatorError> {
        check_size("input", self.system.dynamics().function().parameters(), input.len())?;
        check_finite("input", input)?;
        let Self { system, options, state, draft, scratch, .. } = self;
        draft.clone_from(state);
        if draft.is_due(options, system.process_noise().dim()) {
            draft.reduce(options, &mut scratch.bounds.sets)?;
        }
        predict::advance(system, options, input, draft, scratch)?;
        core::mem::swap(state, draft);
        Ok(())
    }

    /// Cuts the set with a measurement of all outputs, for a `g` without parameters, and with the invariant.
    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        let g = self.system.measurement().function();
        check_size("measurement", g.outputs(), output.len())?;
        check_size("parameters of the measurement", g.parameters(), 0)?;
        check_finite("measurement", output)?;
        self.parameters.clear();
        self.values.clear();
        self.values.extend(output.iter().map(|&y| Interval::point(y)));
        self.correct(true)
    }

    fn step(&mut self, input: &[f64], output: &[f64]) -> Result<(), EstimatorError> {
        self.saved.clone_from(&self.state);
        let result = self.update(output).and_then(|()| self.predict(input));
        if result.is_err() {
            core::mem::swap(&mut self.state, &mut self.saved);
        }
        result
    }

    /// Cuts the set with the invariant alone; every update does so as well.
    fn consistency(&mut self) -> Result<(), EstimatorError> {
        self.correct(false)
    }

    fn enclosure(&self) -> &ConstrainedZonotope {
        &self.state.set
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::Rigorous
    }
}
