//! Constraint elimination: one constraint fewer, a larger set.

use scalars::Interval;
use scalars::rounding::UNIT_ROUNDOFF;

use super::ConstrainedZonotope;
use super::rescale::{product, residual};
use super::score::Choice;
use crate::bounds::{add_abs_row_sums, add_lengths, product_sum_bound};
use crate::{SetError, Workspace};

/// Eliminations for which candidates are compared by their hulls: the last ones, which have the most to lose.
const COMPARED: usize = 3;

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
        self.eliminate_comparing(max_constraints, 1, workspace)
    }

    /// [`eliminate_constraints`](Self::eliminate_constraints) that tries some `candidates`: each of the last three eliminations is that of the
    /// best ones by the estimate which leaves the smallest interval hull, found by linear programs (the sum of its radii, in units of the generators' extent).
    ///
    /// The estimate goes by single rows and knows nothing of what the others bound; for sets with many more columns than dimensions it
    /// is often the second or third candidate that costs least.
    ///
    /// **Guarantee:** as [`eliminate_constraints`](Self::eliminate_constraints).
    ///
    /// # Errors
    /// As [`eliminate_constraints`](Self::eliminate_constraints).
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// for k in 0..6 {
    ///     set.intersect_half_space(&[1.0, f64::from(k) - 2.5], 1.0, &mut workspace)?;
    /// }
    /// set.eliminate_comparing(2, 4, &mut workspace)?;
    /// assert!(set.num_constraints() <= 2);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn eliminate_comparing(
        &mut self,
        max_constraints: usize,
        candidates: usize,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        if self.num_constraints() <= max_constraints {
            return Ok(());
        }
        self.in_draft(workspace, |draft, workspace| {
            while draft.num_constraints() > max_constraints {
                draft.rescale(workspace)?;
                draft.remove_inactive(&mut workspace.coordinates);
                let excess = draft.num_constraints().saturating_sub(max_constraints);
                if excess > 0 {
                    let choice = draft.choose(if excess <= COMPARED { candidates.max(1) } else { 1 }, workspace);
                    draft.free(choice, workspace)?;
                }
            }
            draft.check_magnitudes()?;
            draft.clip_ranges();
            draft.remove_inactive(&mut workspace.coordinates);
            Ok(())
        })
    }

    /// The elimination of least estimated loss, or of some `candidates` that which leaves the smallest hull; one that fails is none.
    fn choose(&self, candidates: usize, workspace: &mut Workspace) -> Choice {
        self.rank_losses(candidates, workspace);
        let choices = core::mem::take(&mut workspace.choices);
        let mut best = (f64::INFINITY, choices.first().map_or(Choice::Row(0), |first| first.1));
        if choices.len() > 1 {
            let (mut hull, mut extents) =
                (core::mem::take(&mut workspace.offsets), core::mem::take(&mut workspace.center));
            extents.clear();
            extents.resize(self.dim(), 0.0);
            add_abs_row_sums(self.generators().as_slice(), &mut extents);
            hull.clear();
            hull.resize(self.dim(), Interval::EMPTY);
            for &(_, choice) in &choices {
                let mut trial = self.copy_into(workspace.trial.take());
                let freed = trial.free(choice, workspace);
                trial.clip_ranges();
                let found = freed.and_then(|()| trial.interval_hull_into(&mut hull, workspace));
                let sides = hull.iter().zip(&extents).filter(|(_, extent)| **extent > 0.0);
                // An empty set stays one that way. NaN fails the comparison.
                let size: f64 =
                    sides.map(|(side, extent)| if side.is_empty() { 0.0 } else { side.rad() / extent }).sum();
                if found.is_ok() && size < best.0 {
                    best = (size, choice);
                }
                workspace.trial = Some(trial);
            }
            (workspace.offsets, workspace.center) = (hull, extents);
        }
        workspace.choices = choices;
        best.1
    }

    /// Frees what is chosen; magnitudes are not checked, ranges not clipped yet.
    fn free(&mut self, choice: Choice, workspace: &mut Workspace) -> Result<(), SetError> {
        match choice {
            Choice::Row(i) => {
                self.remove_row(i);
                Ok(())
            }
            Choice::Generator { column, row } => self.eliminate(column, row, workspace),
        }
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

    /// Solves row `p` for `xi_j` and substitutes it everywhere; magnitudes are not checked, ranges not clipped yet.
    ///
    /// A column loses a multiple of the gains; each of its entries `x - g a` is rounded twice, by at most `u (|g a| + |x - g a|)` but for
    /// underflow, and a row sums that.
    fn eliminate(&mut self, j: usize, p: usize, workspace: &mut Workspace) -> Result<(), SetError> {
        let (n, middle, radius) = (self.dim(), self.ranges[p].mid(), self.ranges[p].rad());
        let pivot = self.constraints.col(j)[p];
        let Workspace { scales: gains, row_sums: magnitudes, .. } = workspace;
        gains.clear();
        gains.extend(self.generators().col(j).iter().chain(self.constraints.col(j)).map(|x| x / pivot));
        magnitudes.clear();
        magnitudes.resize(gains.len(), 0.0);
        let mut products = 0;
        for k in (0..self.num_generators()).filter(|&k| k != j) {
            let a = self.constraints.col(k)[p];
            if a != 0.0 {
                products += 1;
                subtract(self.body.generators.col_mut(k), a, &gains[..n], &mut magnitudes[..n]);
                subtract(self.constraints.col_mut(k), a, &gains[n..], &mut magnitudes[n..]);
            }
        }
        // Two sums and two products a column, and those of what is added here.
        let rounding = |magnitude: f64| product_sum_bound(UNIT_ROUNDOFF * magnitude, products, 2 * products + 2);
        for i in 0..n {
            let entry = &mut self.body.generators.col_mut(j)[i];
            if *entry == 0.0 {
                continue;
            }
            let error = add_lengths(rounding(magnitudes[i]), replace(entry, gains[i], pivot, radius));
            let moved = Interval::point(self.body.center[i]) + Interval::point(gains[i]).scale(middle);
            self.body.center[i] = moved.mid();
            let r = &mut self.body.remainder[i];
            *r = add_lengths(add_lengths(*r, moved.rad()), error);
        }
        for k in (0..self.ranges.len()).filter(|&k| k != p) {
            let entry = &mut self.constraints.col_mut(j)[k];
            if *entry == 0.0 {
                continue;
            }
            let error = add_lengths(rounding(magnitudes[n + k]), replace(entry, gains[n + k], pivot, radius));
            self.ranges[k] = (self.ranges[k] - Interval::point(gains[n + k]).scale(middle)).inflate(error);
        }
        self.remove_row(p);
        if let Some(row) = self.ranges.iter().position(|range| range.is_empty() || !range.is_bounded()) {
            return Err(SetError::Overflow { row });
        }
        Ok(())
    }
}

/// Subtracts `a` times the gains from a column, and adds the magnitudes of products and differences to `magnitudes`.
fn subtract(column: &mut [f64], a: f64, gains: &[f64], magnitudes: &mut [f64]) {
    for ((x, gain), magnitude) in column.iter_mut().zip(gains).zip(magnitudes) {
        let product = gain * a;
        *x -= product;
        *magnitude += product.abs() + x.abs();
    }
}

/// The coefficient `radius gain` of `zeta` in place of an entry that becomes zero but for rounding; returns a bound of both roundings.
fn replace(entry: &mut f64, gain: f64, pivot: f64, radius: f64) -> f64 {
    let (left, error) = residual(*entry, gain, pivot);
    let (slack, rounding) = product(radius, gain);
    *entry = slack;
    add_lengths(add_lengths(left.abs(), error), rounding)
}
