//! Constraint elimination: one constraint fewer, a larger set.

use scalars::Interval;

use super::ConstrainedZonotope;
use super::rescale::{product, residual};
use super::score::Choice;
use crate::bounds::add_lengths;
use crate::{Matrix, SetError, Workspace};

impl ConstrainedZonotope {
    /// Encloses the set in one with at most `max_constraints` constraints and no more generators than before.
    ///
    /// While there are too many, the set is rescaled, and the coordinate or row range is freed whose bound matters least (see
    /// `score.rs`). A coordinate `xi_j` is freed by solving a row `a xi = m + s zeta`, `|zeta| <= 1`, for it: for **every** gain
    /// `(l; l')` the set lies in `<c + l m, G - l a, r; A - l' a, [b] - l' m>` with the additional generator `s (l; l')`, and
    /// `l = G_j / a_j`, `l' = A_j / a_j` removes column `j`, whose place `zeta` takes. A row range is freed by dropping the row.
    ///
    /// **Guarantee:** superset of the set; rounding goes to the remainder and the ranges.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Section 4.2, with ranges in place of slacks.
    ///
    /// # Errors
    /// [`SetError::Overflow`]; the set is then unchanged.
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Matrix, Workspace};
    /// let generators = Matrix::from_rows(&[&[1.5, -1.5, 0.5], &[1.0, 0.5, -1.0]])?;
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0, 1.0]])?;
    /// let mut set = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &generators, &rows, &[1.0])?;
    /// set.eliminate_constraints(0, &mut Workspace::new())?;
    /// assert_eq!((set.num_generators(), set.num_constraints()), (2, 0));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn eliminate_constraints(&mut self, max_constraints: usize, workspace: &mut Workspace) -> Result<(), SetError> {
        if self.num_constraints() <= max_constraints {
            return Ok(());
        }
        self.in_draft(workspace, |draft, workspace| {
            while draft.num_constraints() > max_constraints {
                draft.rescale(workspace)?;
                draft.remove_inactive_generators();
                draft.drop_loose_rows();
                if draft.num_constraints() > max_constraints {
                    match draft.least_loss(workspace) {
                        Choice::Row(i) => draft.remove_row(i),
                        Choice::Generator { column, row } => draft.eliminate(column, row, workspace)?,
                    }
                }
            }
            draft.remove_inactive_generators();
            Ok(())
        })
    }

    /// Runs a fallible change on a copy of the set that the workspace holds, and keeps it if it succeeds.
    pub(super) fn in_draft(
        &mut self,
        workspace: &mut Workspace,
        change: impl FnOnce(&mut Self, &mut Workspace) -> Result<(), SetError>,
    ) -> Result<(), SetError> {
        let mut draft = self.copy_into(workspace.draft.take());
        let result = change(&mut draft, workspace);
        if result.is_ok() {
            core::mem::swap(self, &mut draft);
        }
        workspace.draft = Some(draft);
        result
    }

    /// A copy of the set, in the storage of another one if there is one.
    pub(super) fn copy_into(&self, storage: Option<Self>) -> Self {
        let Some(mut copy) = storage else { return self.clone() };
        copy.clone_from(self);
        copy
    }

    /// Solves row `p` for `xi_j` and substitutes it everywhere.
    fn eliminate(&mut self, j: usize, p: usize, workspace: &mut Workspace) -> Result<(), SetError> {
        let (middle, radius) = (self.ranges[p].mid(), self.ranges[p].rad());
        let row = &mut workspace.objective;
        row.clear();
        row.extend((0..self.num_generators()).map(|k| self.constraints.col(k)[p]));
        let pivot = row[j];
        for i in 0..self.dim() {
            let gain = self.generators().col(j)[i] / pivot;
            if gain == 0.0 && self.generators().col(j)[i] == 0.0 {
                continue;
            }
            let moved = Interval::point(self.body.center[i]) + Interval::point(gain).scale(middle);
            let error = subtract_row(&mut self.body.generators, i, j, gain, row, radius);
            self.body.center[i] = moved.mid();
            let r = &mut self.body.remainder[i];
            *r = add_lengths(add_lengths(*r, moved.rad()), error);
        }
        for k in (0..self.ranges.len()).filter(|&k| k != p) {
            let gain = self.constraints.col(j)[k] / pivot;
            if gain == 0.0 && self.constraints.col(j)[k] == 0.0 {
                continue;
            }
            let error = subtract_row(&mut self.constraints, k, j, gain, row, radius);
            self.ranges[k] = (self.ranges[k] - Interval::point(gain).scale(middle)).inflate(error);
        }
        self.remove_row(p);
        if let Some(row) = self.ranges.iter().position(|range| range.is_empty() || !range.is_bounded()) {
            return Err(SetError::Overflow { row });
        }
        self.check_magnitudes()?;
        self.clip_ranges();
        Ok(())
    }
}

/// Row `i` of `matrix` minus `gain` times `row`, for the terms `xi`; in column `j`, which that makes zero but for rounding, the
/// coefficient `radius gain` of `zeta`. Returns a bound of the sum of all rounding errors.
fn subtract_row(matrix: &mut Matrix, i: usize, j: usize, gain: f64, row: &[f64], radius: f64) -> f64 {
    let mut errors = 0.0;
    for (k, &a) in row.iter().enumerate() {
        let entry = &mut matrix.col_mut(k)[i];
        let (value, error) = residual(*entry, gain, a);
        if k == j {
            let (slack, rounding) = product(radius, gain);
            errors = add_lengths(errors, add_lengths(add_lengths(value.abs(), error), rounding));
            *entry = slack;
        } else {
            errors = add_lengths(errors, error);
            *entry = value;
        }
    }
    errors
}
