//! Exact simplification: generators that do nothing, constraints that hold anyway.

use scalars::Interval;

use super::ConstrainedZonotope;
use super::optimizer::{prepared, refused};
use crate::{SetError, Workspace};

/// A row is dropped only if the rows that imply it do so with multipliers of at most this many times its size.
const LEVERAGE: f64 = 8.0;

impl ConstrainedZonotope {
    /// Drops generators that do nothing: zero columns of `G` and `A`; slacks (`G_j = 0`, one entry `A_ij`), which widen the range
    /// `[b_i]` by `|A_ij|` instead; and of two generators with equal or opposite columns the second, doubling the first.
    ///
    /// **Guarantee:** the same set in real arithmetic; a superset by the rounding of the widened ranges.
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Matrix};
    /// // The textbook form of the band x_1 + x_2 in [-1/2, 1/2] has a slack.
    /// let generators = Matrix::from_rows(&[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]])?;
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0, -0.5]])?;
    /// let mut band = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &generators, &rows, &[0.0])?;
    /// band.remove_inactive_generators();
    /// assert_eq!(band.num_generators(), 2);
    /// assert!((1.0..1.0 + 1e-15).contains(&band.ranges()[0].width()));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn remove_inactive_generators(&mut self) {
        self.remove_inactive(&mut Vec::new());
    }

    /// [`remove_inactive_generators`](Self::remove_inactive_generators) with a buffer.
    pub(super) fn remove_inactive(&mut self, lengths: &mut Vec<f64>) {
        self.merge_equal_generators(lengths);
        for j in 0..self.num_generators() {
            if self.generators().col(j).iter().any(|&g| g != 0.0) {
                continue;
            }
            let column = self.constraints.col_mut(j);
            let mut nonzero = column.iter().enumerate().filter(|(_, a)| **a != 0.0).map(|(i, _)| i);
            if let (Some(i), None) = (nonzero.next(), nonzero.next()) {
                let widened = self.ranges[i].inflate(column[i].abs());
                if widened.lo() > f64::MIN && widened.hi() < f64::MAX {
                    self.ranges[i] = widened;
                    column[i] = 0.0;
                }
            }
        }
        let Self { body, constraints, .. } = self;
        let zero = |column: &[f64]| column.iter().all(|&x| x == 0.0);
        let mut kept = 0;
        for j in 0..body.generators.cols() {
            if !(zero(body.generators.col(j)) && zero(constraints.col(j))) {
                body.generators.copy_col(j, kept);
                constraints.copy_col(j, kept);
                kept += 1;
            }
        }
        body.generators.truncate_cols(kept);
        constraints.truncate_cols(kept);
    }

    /// Of generators with equal or opposite columns, zeroes the second and doubles the first (exact). Such columns have the same length,
    /// bit for bit, so that few are compared.
    fn merge_equal_generators(&mut self, lengths: &mut Vec<f64>) {
        let entries = |j: usize| self.generators().col(j).iter().chain(self.constraints.col(j));
        lengths.clear();
        lengths.extend((0..self.num_generators()).map(|j| entries(j).map(|x| x.abs()).sum::<f64>()));
        for j in 0..lengths.len() {
            for k in j + 1..lengths.len() {
                let alike = lengths[j] == lengths[k] && lengths[j] > 0.0 && lengths[j] < f64::MAX / 2.0;
                if alike && (self.same_column(j, k, 1.0) || self.same_column(j, k, -1.0)) {
                    self.body.generators.col_mut(k).fill(0.0);
                    self.constraints.col_mut(k).fill(0.0);
                    self.body.generators.col_mut(j).iter_mut().for_each(|g| *g *= 2.0);
                    self.constraints.col_mut(j).iter_mut().for_each(|a| *a *= 2.0);
                    (lengths[j], lengths[k]) = (2.0 * lengths[j], 0.0);
                }
            }
        }
    }

    /// Whether column `k` is `sign` times column `j`.
    fn same_column(&self, j: usize, k: usize, sign: f64) -> bool {
        let (g, a) = (self.generators(), &self.constraints);
        let equal = |x: &[f64], y: &[f64]| x.iter().zip(y).all(|(x, y)| *x == sign * y);
        equal(g.col(j), g.col(k)) && equal(a.col(j), a.col(k))
    }

    /// Drops constraints that the others imply, one after the other: rows whose proven maximum and minimum over the rest lie in
    /// their range. Equal and opposite rows are merged first, their ranges intersected.
    ///
    /// **Guarantee:** the same set, or a superset by rounding where a row can be missed by no more than that. A row is kept in
    /// doubt, as an equality that others imply usually is, and so is one that others imply only by the difference of large
    /// multiples: without it the set would move far with the rounding of its rows.
    ///
    /// # Errors
    /// [`SetError::TooLarge`]; the set is then unchanged.
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// set.intersect_half_space(&[1.0, 1.0], 0.5, &mut workspace)?;
    /// set.intersect_half_space(&[1.0, 1.125], 1.5, &mut workspace)?;
    /// set.remove_redundant_constraints(&mut workspace)?;
    /// assert_eq!(set.num_constraints(), 1);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn remove_redundant_constraints(&mut self, workspace: &mut Workspace) -> Result<(), SetError> {
        self.optimizer(workspace)?;
        self.merge_equal_rows();
        self.drop_loose_rows();
        self.optimizer(workspace)?;
        let Workspace { solver, objective, selected: redundant, .. } = workspace;
        let solver = prepared(solver)?;
        redundant.clear();
        for (i, range) in self.ranges.iter().enumerate() {
            solver.set_range(i, f64::NEG_INFINITY, f64::INFINITY).map_err(refused)?;
            objective.clear();
            objective.extend((0..self.num_generators()).map(|j| self.constraints.col(j)[i]));
            let most = LEVERAGE * self.row_bound(i);
            let light = |multipliers: &[(usize, f64)]| {
                multipliers.iter().map(|&(k, y)| y.abs() * self.row_bound(k)).sum::<f64>() <= most
            };
            let mut extreme = |objective: &[f64]| match solver.maximize(objective) {
                Ok(solution) if solution.bound == f64::NEG_INFINITY || light(solution.multipliers) => solution.bound,
                _ => f64::INFINITY,
            };
            let above = extreme(objective);
            if above == f64::NEG_INFINITY {
                // The others contradict each other: the set is empty with or without this row, and stays as it is.
                redundant.clear();
                break;
            }
            let implied = above <= range.hi() && {
                objective.iter_mut().for_each(|a| *a = -*a);
                let below = extreme(objective);
                -below >= range.lo()
            };
            if implied {
                redundant.push(i);
            } else {
                solver.set_range(i, range.lo(), range.hi()).map_err(refused)?;
            }
        }
        for &i in redundant.iter().rev() {
            self.remove_row(i);
        }
        Ok(())
    }

    /// Merges rows that are equal or opposite; rows whose ranges have no common point stay.
    fn merge_equal_rows(&mut self) {
        let entry = |set: &Self, i: usize, j: usize| set.constraints.col(j)[i];
        let mut i = 0;
        while i < self.ranges.len() {
            for k in (i + 1..self.ranges.len()).rev() {
                let columns = || 0..self.num_generators();
                let range = if columns().all(|j| entry(self, i, j) == entry(self, k, j)) {
                    self.ranges[k]
                } else if columns().all(|j| entry(self, i, j) == -entry(self, k, j)) {
                    -self.ranges[k]
                } else {
                    Interval::EMPTY
                };
                let common = self.ranges[i].intersection(range);
                if !common.is_empty() {
                    self.ranges[i] = common;
                    self.remove_row(k);
                }
            }
            i += 1;
        }
    }
}
