//! [`LinearCz`]: the filter for linear systems, without conservatism but for rounding.

mod system;

use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Reduction, SetError, Workspace};
pub use system::LinearSystem;

use crate::error::{check_finite, check_size};
use crate::set_filter::{FilterState, of_hull};
use crate::{Culprit, Estimator, EstimatorError, Guarantee};

/// How a measurement is written in a [`LinearCz`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NoiseForm {
    /// The noise widens the range of a row if it acts on each output by itself: no generators. Noise that mixes outputs is written as
    /// generators all the same.
    Ranges,
    /// The generators and constraints of the noise join those of the set, as in (B.3).
    Generators,
}

/// Options of a [`LinearCz`]. Without a limit sets are exact but for rounding, and grow with every step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LinearOptions {
    /// How large a set may be after an update; `None` for as large as it gets.
    pub limit: Option<Complexity>,
    /// How generators are reduced to that.
    pub reduction: Reduction,
    /// How measurements are written.
    pub noise: NoiseForm,
    /// Whether an update ends with the consistency step.
    pub consistency: bool,
}

impl Default for LinearOptions {
    fn default() -> Self {
        Self { limit: None, reduction: Reduction::Method4, noise: NoiseForm::Ranges, consistency: true }
    }
}

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
/// **Guarantee:** [`Guarantee::Rigorous`].
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

    /// [`update`](Estimator::update) with the input `u_k` that acts on the outputs, and outputs that may be missing.
    ///
    /// # Errors
    /// As [`update`](Estimator::update).
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

    /// All constraints of the draft come from the prediction.
    fn begin_cuts(&mut self) {
        self.scratch.culprits.clear();
        self.scratch.culprits.resize(self.draft.set.num_constraints(), Culprit::Prediction);
    }

    /// (B.3) for the outputs that were measured.
    fn cut_by_measurement(&mut self, output: &[Option<f64>], input: &[f64]) -> Result<(), EstimatorError> {
        let LinearSystem { c, d_u, d_v, v, .. } = &self.system;
        let Scratch { sets, noise, rows, noise_map, shift, ranges, culprits, .. } = &mut self.scratch;
        let measured = || output.iter().enumerate().filter_map(|(i, y)| y.map(|y| (i, y)));
        let (n, count) = (self.draft.set.dim(), measured().count());
        if count == 0 {
            return Ok(());
        }
        rows.reset(count, n);
        noise_map.reset(count, v.dim());
        shift.clear();
        for (row, (i, y)) in measured().enumerate() {
            (0..n).for_each(|k| rows[(row, k)] = c[(i, k)]);
            (0..v.dim()).for_each(|k| noise_map[(row, k)] = -d_v[(i, k)]);
            shift.push(Interval::point(y) - combination(d_u, i, input));
        }
        noise.clone_from(v);
        noise.linear_map_in_place(noise_map, sets)?;
        noise.add_box(shift)?;
        let is_box = noise.num_constraints() == 0
            && noise.generators().columns().all(|g| g.iter().filter(|x| **x != 0.0).count() <= 1);
        if self.options.noise == NoiseForm::Ranges && is_box {
            ranges.clear();
            ranges.resize(count, Interval::EMPTY);
            noise.unconstrained().interval_hull_into(ranges)?;
            self.draft.set.intersect_rows(rows, ranges, sets)?;
        } else {
            self.draft.set.intersect(rows, noise, sets)?;
            // The noise's own constraints come before the rows.
            culprits.resize(self.draft.set.num_constraints() - count, Culprit::Prediction);
        }
        culprits.extend(measured().map(|(i, _)| Culprit::Measurement(i)));
        Ok(())
    }

    /// (B.4) if that is asked for, the hull, the reduction, and the end of the call.
    fn finish_cuts(&mut self, consistency: bool) -> Result<(), EstimatorError> {
        let (e, d) = (&self.system.e, &self.system.d);
        if consistency && !d.is_empty() {
            self.system.check_invariant(self.draft.set.dim())?;
            self.draft.set.intersect_rows(e, d, &mut self.scratch.sets)?;
            self.scratch.culprits.extend((0..d.len()).map(Culprit::Invariant));
        }
        let Scratch { sets, own, culprits, .. } = &mut self.scratch;
        let FilterState { set, hull, step, .. } = &mut self.draft;
        own.clear();
        own.resize(hull.len(), Interval::EMPTY);
        set.interval_hull_into(own, sets)?;
        if own.iter().zip(hull.iter()).any(|(own, held)| own.disjoint(held)) {
            return Err(of_hull(*step, set, (own, hull), culprits, sets));
        }
        hull.iter_mut().zip(own.iter()).for_each(|(side, &found)| *side = side.intersection(found));
        self.reduce_draft()?;
        core::mem::swap(&mut self.state, &mut self.draft);
        Ok(())
    }
}

/// Encloses row `i` of `M u`.
fn combination(matrix: &Matrix, i: usize, u: &[f64]) -> Interval {
    u.iter().enumerate().fold(Interval::ZERO, |sum, (k, &u)| sum + Interval::point(u).scale(matrix[(i, k)]))
}

impl Estimator for LinearCz {
    /// The input `u`, of which (B.1a) takes that of the step before, (B.1b) that of the measurement.
    type Input = [f64];
    type Output = [f64];
    type Set = ConstrainedZonotope;

    fn predict(&mut self, input: &[f64]) -> Result<(), EstimatorError> {
        let LinearSystem { a, b_u, b_w, w, .. } = &self.system;
        let n = self.state.set.dim();
        self.system.check_dynamics(n)?;
        check_size("input", b_u.cols(), input.len())?;
        check_finite("input", input)?;
        self.draft.clone_from(&self.state);
        let Scratch { sets, noise, shift, own, .. } = &mut self.scratch;
        let FilterState { set, hull, step, .. } = &mut self.draft;
        set.linear_map_in_place(a, sets)?;
        shift.clear();
        shift.extend((0..n).map(|i| combination(b_u, i, input)));
        set.add_box(shift)?;
        noise.clone_from(w);
        noise.linear_map_in_place(b_w, sets)?;
        set.add_assign(noise)?;
        *step += 1;
        own.clear();
        own.resize(n, Interval::EMPTY);
        set.interval_hull_into(own, sets)?;
        if own.iter().any(Interval::is_empty) {
            return Err(of_hull(*step, set, (own, hull), &[], sets));
        }
        if let Some(row) = own.iter().position(|side| !side.is_bounded()) {
            return Err(SetError::Overflow { row }.into());
        }
        hull.copy_from_slice(own);
        core::mem::swap(&mut self.state, &mut self.draft);
        Ok(())
    }

    /// Cuts the set with a measurement of all outputs, on which no input acts.
    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        let mut values = core::mem::take(&mut self.scratch.values);
        values.clear();
        values.extend(output.iter().map(|&y| Some(y)));
        let result = self.update_some(&values, &[]);
        self.scratch.values = values;
        result
    }

    fn step(&mut self, input: &[f64], output: &[f64]) -> Result<(), EstimatorError> {
        self.saved.clone_from(&self.state);
        let result = self.update(output).and_then(|()| self.predict(input));
        if result.is_err() {
            core::mem::swap(&mut self.state, &mut self.saved);
        }
        result
    }

    /// Cuts the set with the invariant.
    fn consistency(&mut self) -> Result<(), EstimatorError> {
        self.draft.clone_from(&self.state);
        self.begin_cuts();
        self.finish_cuts(true)
    }

    fn enclosure(&self) -> &ConstrainedZonotope {
        &self.state.set
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::Rigorous
    }
}
