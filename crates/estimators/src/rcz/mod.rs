//! [`Rcz`]: the default guaranteed filter, on ranged constrained zonotopes.

mod correct;
mod equation;
mod options;
mod predict;
mod scratch;
mod state;

pub use options::{RczOptions, Tier};
use scalars::Interval;
use setrep::ConstrainedZonotope;
pub use state::{RczMemory, RczState};

use crate::error::check_size;
use crate::set_filter::Equation;
use crate::{EstimatorError, Measured, Method, Phase, SetFilter, System};
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
/// A step in steady state allocates nothing.
///
/// **Guarantee:** rigorous, as [`SetFilter`] says.
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
///     const VARIABLES: Option<usize> = Some(3);
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
///     const VARIABLES: Option<usize> = Some(3);
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
pub type Rcz = SetFilter<RangedCz>;

/// The method of [`Rcz`].
#[derive(Debug, Clone, Copy)]
pub struct RangedCz;

impl Method for RangedCz {
    type Set = ConstrainedZonotope;
    type Memory = RczMemory;
    type Options = RczOptions;
    type Scratch = Scratch;

    fn start(
        _: &System,
        set: ConstrainedZonotope,
        _: &RczOptions,
        scratch: &mut Scratch,
    ) -> Result<RczState, EstimatorError> {
        state::start(set, &mut scratch.bounds.sets)
    }

    fn check_memory(system: &System, memory: &RczMemory) -> Result<(), EstimatorError> {
        check_size("saved directions", system.states(), memory.directions.dim())
    }

    fn predict(
        system: &System,
        options: &RczOptions,
        input: &[Interval],
        state: &mut RczState,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        if state::is_due(state, options, system.process_noise().dim()) {
            state::reduce(state, options, &mut scratch.bounds.sets)?;
            trace(Phase::Reduction);
        }
        predict::advance(system, options, input, state, scratch)?;
        trace(Phase::Prediction);
        Ok(())
    }

    /// Measurement and invariant cut the set together.
    fn correct(
        system: &System,
        options: &RczOptions,
        measured: Option<Measured<'_>>,
        state: &mut RczState,
        scratch: &mut Scratch,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        let phase = if measured.is_some() { Phase::Update } else { Phase::Consistency };
        let measurement = measured.map(|measured| Equation::measurement(system, measured));
        let invariant = Equation::invariant(system);
        let rows = [&measurement, &invariant].into_iter().flatten().map(|equation| equation.values.len()).sum();
        if state::is_crowded(state, options, rows) {
            state::reduce(state, options, &mut scratch.bounds.sets)?;
            trace(Phase::Reduction);
        }
        match (measurement, invariant) {
            (Some(measurement), Some(invariant)) => {
                correct::correct(&[measurement, invariant], options, state, scratch)?;
            }
            (Some(only), None) | (None, Some(only)) => correct::correct(&[only], options, state, scratch)?,
            (None, None) => return Ok(()),
        }
        trace(phase);
        Ok(())
    }

    fn reduce(
        _: &System,
        options: &RczOptions,
        state: &mut RczState,
        scratch: &mut Scratch,
    ) -> Result<(), EstimatorError> {
        state::reduce(state, options, &mut scratch.bounds.sets)
    }
}
