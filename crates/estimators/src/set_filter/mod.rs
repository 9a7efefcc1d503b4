//! [`SetFilter`]: the shell of all set-valued filters of a [`System`]: what they check, keep and give back.

mod contradiction;
mod delayed;
mod equation;
mod faults;
mod method;
mod stacked;
mod state;

pub(crate) use contradiction::{inconsistent, of_hull, of_values, under};
pub use delayed::DelayedFilter;
pub(crate) use equation::{Equation, check_strips};
pub use faults::{Fault, FaultPolicy, Inflate, Recovery};
pub use method::{Measured, Method, Phase};
use scalars::Interval;
use setrep::SupportFunction;
pub(crate) use stacked::{Stacked, is_box, store};
pub use state::FilterState;

use crate::error::{check_finite, check_size};
use crate::{Estimator, EstimatorError, Guarantee, System};

/// A set-valued filter of a [`System`] by the [`Method`] `M`. The filters are aliases of it, such as [`Rcz`](crate::Rcz).
///
/// A call that fails leaves the filter as it was, a proven contradiction ([`EstimatorError::Inconsistent`]) included: the predicted set
/// is kept, and the caller may go on without the measurement.
///
/// **Guarantee:** that of the method, [`Method::GUARANTEE`]. If it is [`Guarantee::Rigorous`]: when the first state lies in the initial
/// set, noises keep their bounds and the invariant holds, every state lies in [`enclosure`](Estimator::enclosure) and in
/// [`hull`](Self::hull), remainders and rounding included.
#[derive(Debug, Clone)]
pub struct SetFilter<M: Method> {
    system: System,
    options: M::Options,
    state: FilterState<M::Set, M::Memory>,
    /// The state of the call that is under way, and the one to come back to.
    draft: FilterState<M::Set, M::Memory>,
    saved: FilterState<M::Set, M::Memory>,
    values: Vec<Interval>,
    parameters: Vec<Interval>,
    scratch: M::Scratch,
}

impl<M: Method> SetFilter<M> {
    /// A filter that starts with `x_0` in `initial`.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if `initial` is not of the system's dimension; [`EstimatorError::Set`] if it is proven empty or has no
    /// bounds; what the method says of its options.
    pub fn new(system: System, initial: M::Set, options: M::Options) -> Result<Self, EstimatorError> {
        check_size("initial set", system.states(), initial.dim())?;
        let mut scratch = M::Scratch::default();
        let state = M::start(&system, initial, &options, &mut scratch)?;
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

    /// The options.
    #[must_use]
    pub fn options(&self) -> &M::Options {
        &self.options
    }

    /// The options, which may be changed between calls.
    pub fn options_mut(&mut self) -> &mut M::Options {
        &mut self.options
    }

    /// A box that contains the state.
    #[must_use]
    pub fn hull(&self) -> &[Interval] {
        &self.state.hull
    }

    /// Number of predictions so far.
    #[must_use]
    pub fn step_index(&self) -> u64 {
        self.state.step
    }

    /// All that has to be saved to go on later, bit for bit.
    #[must_use]
    pub fn state(&self) -> &FilterState<M::Set, M::Memory> {
        &self.state
    }

    /// Goes on from a state that was saved, or from a set known otherwise.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if its parts are not of the system's dimension, [`EstimatorError::EmptyRange`] and
    /// [`EstimatorError::NotFinite`] if its hull is empty or unbounded; the filter is then unchanged.
    pub fn restore(&mut self, state: &FilterState<M::Set, M::Memory>) -> Result<(), EstimatorError> {
        state.check(self.system.states())?;
        M::check_memory(&self.system, &state.memory)?;
        self.state.clone_from(state);
        Ok(())
    }

    /// [`predict`](Estimator::predict), with a report at the end of each phase.
    ///
    /// # Errors
    /// As [`predict`](Estimator::predict).
    pub fn predict_traced(&mut self, input: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        check_size("input", self.system.dynamics().function().parameters(), input.len())?;
        check_finite("input", input)?;
        let Self { system, options, state, draft, parameters, scratch, .. } = self;
        parameters.clear();
        parameters.extend(input.iter().map(|&u| Interval::point(u)));
        draft.clone_from(state);
        M::predict(system, options, parameters, draft, scratch, trace).map_err(|error| under(M::GUARANTEE, error))?;
        core::mem::swap(state, draft);
        Ok(())
    }

    /// [`update`](Estimator::update) for a measurement with parameters `p`, of which some entries may be missing.
    ///
    /// # Errors
    /// As [`update`](Estimator::update).
    pub fn update_some(&mut self, output: &[Option<f64>], p: &[f64]) -> Result<(), EstimatorError> {
        self.update_traced(output, p, &mut |_| {})
    }

    /// [`update_some`](Self::update_some), with a report at the end of each phase.
    ///
    /// # Errors
    /// As [`update`](Estimator::update).
    pub fn update_traced(
        &mut self,
        output: &[Option<f64>],
        p: &[f64],
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        if let Some(index) = output.iter().position(|y| y.is_some_and(|y| !y.is_finite())) {
            let value = output[index].unwrap_or(f64::NAN);
            return Err(EstimatorError::NotFinite { what: "measurement", index, value });
        }
        check_finite("parameters of the measurement", p)?;
        self.values.clear();
        self.values.extend(output.iter().map(|y| y.map_or(Interval::ENTIRE, Interval::point)));
        self.cut_by_values(p, trace)
    }

    /// Encloses the set in a small one now, instead of when the method finds it due.
    ///
    /// # Errors
    /// [`EstimatorError::Set`] if an entry overflows; the filter is then unchanged.
    pub fn reduce(&mut self) -> Result<(), EstimatorError> {
        let Self { system, options, state, draft, scratch, .. } = self;
        draft.clone_from(state);
        M::reduce(system, options, draft, scratch)?;
        core::mem::swap(state, draft);
        Ok(())
    }

    /// Cuts the state with the values at hand.
    fn cut_by_values(&mut self, p: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        let g = self.system.measurement().function();
        check_size("measurement", g.outputs(), self.values.len())?;
        check_size("parameters of the measurement", g.parameters(), p.len())?;
        self.parameters.clear();
        self.parameters.extend(p.iter().map(|&p| Interval::point(p)));
        self.correct(true, trace)
    }

    /// Cuts the state with the values at hand (if `measured`) and the invariant.
    fn correct(&mut self, measured: bool, trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        let Self { system, options, state, draft, values, parameters, scratch, .. } = self;
        let measured = measured.then_some(Measured { values, parameters });
        draft.clone_from(state);
        M::correct(system, options, measured, draft, scratch, trace).map_err(|error| under(M::GUARANTEE, error))?;
        core::mem::swap(state, draft);
        Ok(())
    }
}

impl<M: Method> Estimator for SetFilter<M> {
    type Input = [f64];
    type Output = [f64];
    type Set = M::Set;

    fn predict(&mut self, input: &[f64]) -> Result<(), EstimatorError> {
        self.predict_traced(input, &mut |_| {})
    }

    /// Cuts the set with a measurement of all outputs, for a `g` without parameters.
    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        check_finite("measurement", output)?;
        self.values.clear();
        self.values.extend(output.iter().map(|&y| Interval::point(y)));
        self.cut_by_values(&[], &mut |_| {})
    }

    fn step(&mut self, input: &[f64], output: &[f64]) -> Result<(), EstimatorError> {
        self.saved.clone_from(&self.state);
        let result = self.update(output).and_then(|()| self.predict(input));
        if result.is_err() {
            core::mem::swap(&mut self.state, &mut self.saved);
        }
        result
    }

    /// Cuts the set with the invariant alone.
    fn consistency(&mut self) -> Result<(), EstimatorError> {
        self.correct(false, &mut |_| {})
    }

    fn enclosure(&self) -> &M::Set {
        &self.state.set
    }

    fn guarantee(&self) -> Guarantee {
        M::GUARANTEE
    }
}
