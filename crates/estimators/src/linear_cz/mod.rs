//! [`LinearCz`]: the filter for linear systems, without conservatism but for rounding.

mod options;
mod step;
mod system;

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, SetError, Workspace};

pub use options::{LinearOptions, NoiseForm};
pub use system::LinearSystem;

use crate::error::{check_finite, check_size};
use crate::set_filter::FilterState;
use crate::{Culprit, EstimatorError};

/// Guaranteed state estimation for a [`LinearSystem`] with constrained zonotopes.
///
/// ```text
/// prediction     A X + B_u u + B_w W                     (B.2)
/// update         { x in X : C x in y - D_u u - D_v V }   (B.3)
/// consistency    { x in X : E x in [d] }                 (B.4)
/// ```
///
/// All three are exact but for rounding, which is enclosed; only a [`limit`](LinearOptions::limit) makes sets larger than the states that
/// agree with all measurements. A call that fails leaves the filter as it was. In steady state, with a limit, nothing is allocated.
///
/// **Guarantee:** [`Guarantee::Rigorous`](crate::Guarantee::Rigorous).
/// **Source:** paper 003, Appendix B; Scott, Raimondo, Marseglia, Braatz 2016.
///
/// ```
/// use estimators::{Estimator, LinearCz, LinearOptions, LinearSystem};
/// use setrep::{ConstrainedZonotope, Matrix};
///
/// // A cart: position and speed, pushed a little; its position is seen.
/// let a = Matrix::from_rows(&[&[1.0, 0.125], &[0.0, 1.0]])?;
/// let push = ConstrainedZonotope::from_box(&[0.0, 0.0], &[0.0, 0.01])?;
/// let error = ConstrainedZonotope::from_box(&[0.0], &[0.05])?;
/// let system = LinearSystem::new(a, push, Matrix::from_rows(&[&[1.0, 0.0]])?, error)?;
/// let start = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
/// let mut filter = LinearCz::new(system, start, LinearOptions::default())?;
/// for k in 0..20 {
///     filter.update(&[0.5 * 0.125 * f64::from(k)])?; // half a meter a second
///     filter.predict(&[])?;
/// }
/// assert!(filter.hull()[1].contains(0.5) && filter.hull()[1].rad() < 0.25);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct LinearCz {
    system: LinearSystem,
    options: LinearOptions,
    state: FilterState<ConstrainedZonotope>,
    /// The state of the call that is under way, and the one to come back to.
    draft: FilterState<ConstrainedZonotope>,
    saved: FilterState<ConstrainedZonotope>,
    scratch: Scratch,
}

/// Buffers of a step.
#[derive(Debug, Clone)]
struct Scratch {
    sets: Workspace,
    /// A noise, mapped to states or outputs.
    noise: ConstrainedZonotope,
    /// The rows of `C` and `-D_v` that were measured, the shift by inputs and values, ranges, the hull of a set.
    rows: Matrix,
    noise_map: Matrix,
    shift: Vec<Interval>,
    ranges: Vec<Interval>,
    own: Vec<Interval>,
    /// All outputs, measured.
    values: Vec<Option<f64>>,
    /// What each constraint of the set comes from.
    culprits: Vec<Culprit>,
}

impl LinearCz {
    /// A filter that starts with `x_0` in `initial`.
    ///
    /// # Errors
    /// Sizes that do not fit `initial`, entries that are not finite, a limit of fewer generators than states; [`SetError::EmptySet`] if
    /// `initial` is proven empty.
    pub fn new(
        system: LinearSystem,
        initial: ConstrainedZonotope,
        options: LinearOptions,
    ) -> Result<Self, EstimatorError> {
        let n = initial.dim();
        system.check_dynamics(n)?;
        system.check_measurement(n)?;
        system.check_invariant(n)?;
        if let Some(limit) = options.limit.filter(|limit| limit.generators < n) {
            return Err(SetError::TooFewGenerators { max_generators: limit.generators, dim: n }.into());
        }
        let mut sets = Workspace::new();
        let hull = initial.interval_hull(&mut sets)?.to_vec();
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet.into());
        }
        let scratch = Scratch {
            sets,
            noise: system.w.clone(),
            rows: Matrix::default(),
            noise_map: Matrix::default(),
            shift: Vec::new(),
            ranges: Vec::new(),
            own: Vec::new(),
            values: Vec::new(),
            culprits: Vec::new(),
        };
        let state = FilterState { set: initial, hull, step: 0, memory: () };
        let (draft, saved) = (state.clone(), state.clone());
        Ok(Self { system, options, state, draft, saved, scratch })
    }

    /// The system.
    #[must_use]
    pub fn system(&self) -> &LinearSystem {
        &self.system
    }

    /// The system, which may be written to between calls.
    pub fn system_mut(&mut self) -> &mut LinearSystem {
        &mut self.system
    }

    /// The options.
    #[must_use]
    pub fn options(&self) -> &LinearOptions {
        &self.options
    }

    /// The options, which may be changed between calls.
    pub fn options_mut(&mut self) -> &mut LinearOptions {
        &mut self.options
    }

    /// The interval hull of the set.
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
    pub fn state(&self) -> &FilterState<ConstrainedZonotope> {
        &self.state
    }

    /// Goes on from a state that was saved, or from a set known otherwise.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if its parts are not of the system's dimension, [`EstimatorError::EmptyRange`] and
    /// [`EstimatorError::NotFinite`] if its hull is empty or unbounded; the filter is then unchanged.
    pub fn restore(&mut self, state: &FilterState<ConstrainedZonotope>) -> Result<(), EstimatorError> {
        state.check(self.state.hull.len())?;
        self.state.clone_from(state);
        Ok(())
    }

    /// [`update`](crate::Estimator::update) with the input `u_k` that acts on the outputs, and outputs that may be missing.
    ///
    /// # Errors
    /// As [`update`](crate::Estimator::update).
    pub fn update_some(&mut self, output: &[Option<f64>], input: &[f64]) -> Result<(), EstimatorError> {
        self.draft.clone_from(&self.state);
        self.system.check_measurement(self.draft.set.dim())?;
        check_size("measurement", self.system.c.rows(), output.len())?;
        if let Some(index) = output.iter().position(|y| y.is_some_and(|y| !y.is_finite())) {
            let value = output[index].unwrap_or(f64::NAN);
            return Err(EstimatorError::NotFinite { what: "measurement", index, value });
        }
        check_size("input of the measurement", self.system.d_u.cols(), input.len())?;
        check_finite("input of the measurement", input)?;
        self.begin_cuts();
        self.cut_by_measurement(output, input)?;
        self.finish_cuts(self.options.consistency)
    }

    /// Encloses the set in one within the limit now; does nothing without one.
    ///
    /// # Errors
    /// [`EstimatorError::Set`] if an entry overflows; the filter is then unchanged.
    pub fn reduce(&mut self) -> Result<(), EstimatorError> {
        self.draft.clone_from(&self.state);
        self.reduce_draft()?;
        core::mem::swap(&mut self.state, &mut self.draft);
        Ok(())
    }

    fn reduce_draft(&mut self) -> Result<(), EstimatorError> {
        let Some(limit) = self.options.limit else { return Ok(()) };
        Ok(self.draft.set.reduce(limit, self.options.reduction, &mut self.scratch.sets)?)
    }
}
