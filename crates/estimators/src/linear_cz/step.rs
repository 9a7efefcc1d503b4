//! The steps of a [`LinearCz`]: prediction, cuts by measurements and invariants.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, SetError};

use super::{LinearCz, LinearSystem, NoiseForm, Scratch};
use crate::error::{check_finite, check_size};
use crate::set_filter::{FilterState, of_hull};
use crate::{Culprit, Estimator, EstimatorError, Guarantee};

impl LinearCz {
    /// All constraints of the draft come from the prediction.
    pub(super) fn begin_cuts(&mut self) {
        self.scratch.culprits.clear();
        self.scratch.culprits.resize(self.draft.set.num_constraints(), Culprit::Prediction);
    }

    /// (B.3) for the outputs that were measured.
    pub(super) fn cut_by_measurement(&mut self, output: &[Option<f64>], input: &[f64]) -> Result<(), EstimatorError> {
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
    pub(super) fn finish_cuts(&mut self, consistency: bool) -> Result<(), EstimatorError> {
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
