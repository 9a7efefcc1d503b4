//! [`Method`]: what distinguishes one set-valued filter from another.

use std::fmt::Debug;

use scalars::Interval;
use setrep::SupportFunction;

use super::FilterState;
use crate::{EstimatorError, Guarantee, System};

/// Part of a step. The `_traced` calls of a [`SetFilter`](crate::SetFilter) report each at its end, so that a caller can time them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Phase {
    /// The set has moved on with the dynamics.
    Prediction,
    /// The set is cut with the measurement.
    Update,
    /// The set is cut with the invariant alone.
    Consistency,
    /// The set is enclosed in a smaller representation.
    Reduction,
}

/// A measurement as a method sees it.
#[derive(Debug, Clone, Copy)]
pub struct Measured<'a> {
    /// The value of each output; [`Interval::ENTIRE`] where it is missing.
    pub values: &'a [Interval],
    /// The parameters `p` of the measurement.
    pub parameters: &'a [Interval],
}

/// The recursion of a set-valued filter; [`SetFilter`](crate::SetFilter) makes an estimator of it.
///
/// The functions work on a draft of the state, which they may leave spoiled when they fail: the filter then goes back. Sizes of
/// arguments have been checked against the system, numbers are finite. In steady state they allocate nothing: buffers live in
/// [`Scratch`](Self::Scratch), which grows once and holds no result.
pub trait Method: Sized + Clone + Debug {
    /// The form of the sets.
    type Set: SupportFunction + Clone + Debug;
    /// What has to be kept besides the set, its hull and the number of steps.
    type Memory: Clone + Debug;
    /// Options that a user chooses.
    type Options: Clone + Debug;
    /// Buffers.
    type Scratch: Default + Clone + Debug;

    /// What the sets promise.
    const GUARANTEE: Guarantee = Guarantee::Rigorous;

    /// The first state: the set, its hull and the memory.
    ///
    /// # Errors
    /// A set that is proven empty or unbounded, options that cannot work.
    fn start(
        system: &System,
        set: Self::Set,
        options: &Self::Options,
        scratch: &mut Self::Scratch,
    ) -> Result<FilterState<Self::Set, Self::Memory>, EstimatorError>;

    /// Whether the memory of a saved state fits the system.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if it does not.
    fn check_memory(_system: &System, _memory: &Self::Memory) -> Result<(), EstimatorError> {
        Ok(())
    }

    /// Moves the state on by one step of the dynamics with input `u`, and counts the step.
    ///
    /// # Errors
    /// Results that are not finite, functions that cannot be enclosed.
    fn predict(
        system: &System,
        options: &Self::Options,
        input: &[Interval],
        state: &mut FilterState<Self::Set, Self::Memory>,
        scratch: &mut Self::Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError>;

    /// Cuts the state with a measurement, and with the invariant where the method uses it; without a measurement, with the invariant alone.
    ///
    /// # Errors
    /// [`EstimatorError::Inconsistent`] with proof if no state is left; functions that cannot be enclosed.
    fn correct(
        system: &System,
        options: &Self::Options,
        measured: Option<Measured<'_>>,
        state: &mut FilterState<Self::Set, Self::Memory>,
        scratch: &mut Self::Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError>;

    /// Encloses the set in one of the size that the options ask for.
    ///
    /// # Errors
    /// [`EstimatorError::Set`] if an entry overflows.
    fn reduce(
        system: &System,
        options: &Self::Options,
        state: &mut FilterState<Self::Set, Self::Memory>,
        scratch: &mut Self::Scratch,
    ) -> Result<(), EstimatorError>;
}
