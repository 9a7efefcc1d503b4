//! Rescaling: coordinates `xi_j` whose constraints allow less than `[-1, 1]`.

use scalars::Interval;
use scalars::rounding::{ETA, add_up, mul_up, sub_up, up};

use super::ConstrainedZonotope;
use super::rows::clip;
use crate::bounds::{add_lengths, sum_bound};
use crate::polytope::error_free::dot_compensated;
use crate::{SetError, Workspace};

/// A range of `xi_j` with at least this half-width is left as it is.
const WORTHWHILE: f64 = 1.0 - 1e-6;

/// A coordinate with at most this half-width is a constant but for rounding, which belongs to remainder and ranges.
const CONSTANT: f64 = 1e-13;

/// A range that a row can miss by no more than this share of its reach does not bind.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Entries and ends beyond this are refused, so that nothing overflows.
const LARGEST: f64 = f64::MAX / 16.0;

impl ConstrainedZonotope {
    /// Rewrites the set so that the coordinates use the whole of `[-1, 1]` as far as single constraints tell, and drops the
    /// constraints that hold anyway.
    ///
    /// Row `i` leaves `xi_j` the range `([b_i] -+ sum_{k != j} |A_ik|) / A_ij`, cut with `[-1, 1]` to `m +- h`; with
    /// `xi_j = m + h xi_j'` the center moves by `G_j m`, the ranges by `-A_j m`, and the columns shrink by `h`. Two sweeps over the
    /// rows. A row whose range contains `[-|A_i|_1, |A_i|_1]` is dropped.
    ///
    /// **Guarantee:** the same set in real arithmetic; a superset by rounding, which goes to the remainder and the ranges. An empty
    /// set may be left as it is.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Section 4.2.
    ///
    /// # Errors
    /// [`SetError::Overflow`] for numbers near the largest; the set is then unchanged.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{ConstrainedZonotope, Matrix, Workspace};
    /// let rows = Matrix::from_rows(&[&[1.0, 0.0]])?;
    /// let half = Interval::new(0.0, 1.0).unwrap_or(Interval::ENTIRE);
    /// let mut set = ConstrainedZonotope::new(&[0.0, 0.0], &Matrix::identity(2), &rows, &[half])?;
    /// set.rescale(&mut Workspace::new())?;
    /// assert_eq!((set.center()[0], set.num_constraints()), (0.5, 0));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn rescale(&mut self, workspace: &mut Workspace) -> Result<(), SetError> {
        self.check_magnitudes()?;
        for _ in 0..2 {
            let mut changed = false;
            for i in 0..self.ranges.len() {
                match self.rescale_by_row(i, workspace) {
                    Some(by_row) => changed |= by_row,
                    None => return Ok(()),
                }
            }
            if !changed {
                break;
            }
        }
        self.clip_ranges();
        self.drop_loose_rows();
        Ok(())
    }

    /// `Ok` if sums of the set's numbers are far from overflow.
    pub(super) fn check_magnitudes(&self) -> Result<(), SetError> {
        let fits = |sum: f64| sum < LARGEST;
        let extent = |i: usize| -> f64 { self.generators().columns().map(|g| g[i].abs()).sum() };
        if let Some(row) = (0..self.dim()).find(|&i| !fits(self.center()[i].abs() + self.remainder()[i] + extent(i))) {
            return Err(SetError::Overflow { row });
        }
        match (0..self.ranges.len()).find(|&i| !fits(self.row_bound(i) + self.ranges[i].mag())) {
            Some(row) => Err(SetError::Overflow { row }),
            None => Ok(()),
        }
    }

    /// Upper bound of `|A_i|_1`.
    pub(super) fn row_bound(&self, i: usize) -> f64 {
        let entries = (0..self.num_generators()).map(|j| self.constraints.col(j)[i].abs()).filter(|&a| a != 0.0);
        let (sum, count) = entries.fold((0.0, 0_usize), |(sum, count), a| (sum + a, count + 1));
        if count <= 1 { sum } else { sum_bound(sum, count) }
    }

    /// The range that row `i`, whose bound is `norm`, leaves `xi_j` (not cut with `[-1, 1]`).
    pub(super) fn implied(&self, i: usize, j: usize, norm: f64) -> Interval {
        let a = self.constraints.col(j)[i];
        // A tiny entry says nothing, and its reciprocal overflows.
        if a.abs() <= 1e-12 * norm || a.abs() < f64::MIN_POSITIVE {
            return Interval::ENTIRE;
        }
        self.ranges[i].inflate(sub_up(norm, a.abs())) / Interval::point(a)
    }

    /// Rescales all coordinates by one row, from its values at entry, and says whether that changed any; `None` if the row proves the set
    /// empty.
    fn rescale_by_row(&mut self, i: usize, workspace: &mut Workspace) -> Option<bool> {
        if !self.may_bind(i) {
            return Some(false);
        }
        let norm = self.row_bound(i);
        let unit = Interval::new(-1.0, 1.0).unwrap_or(Interval::ENTIRE);
        let mut implied = core::mem::take(&mut workspace.ranges);
        implied.clear();
        implied.extend((0..self.num_generators()).map(|j| self.implied(i, j, norm).intersection(unit)));
        let consistent = !implied.iter().any(Interval::is_empty);
        let changed = consistent && self.substitute(&implied, workspace);
        workspace.ranges = implied;
        consistent.then_some(changed)
    }

    /// Whether row `i` may leave some `xi_j` a range that is worth it, or none: that takes `|A_i|_1 + min(hi, -lo) < 2 |A_ij|`.
    fn may_bind(&self, i: usize) -> bool {
        let entries = self.constraints.columns().map(|column| column[i].abs());
        let (norm, largest) = entries.fold((0.0, 0.0_f64), |(norm, largest), a| (norm + a, largest.max(a)));
        let reach = self.ranges[i].hi().min(-self.ranges[i].lo());
        let slack = norm + reach - 2.0 * largest * (1.0 - 0.25 * (1.0 - WORTHWHILE));
        // Overflow gives NaN.
        slack.is_nan() || slack <= 0.0
    }

    /// `xi_j = m_j + h_j xi_j'` for the coordinates whose range `m_j +- h_j` is worth it; `false` if none is.
    ///
    /// A shift `G m` or `A m` may cancel most of a center or a range, so it is one compensated sum for all of them.
    fn substitute(&mut self, implied: &[Interval], workspace: &mut Workspace) -> bool {
        let Workspace { objective: factors, row_sums: entries, selected, .. } = workspace;
        selected.clear();
        selected.extend((0..implied.len()).filter(|&j| implied[j].rad() < WORTHWHILE));
        if selected.is_empty() {
            return false;
        }
        factors.clear();
        factors.push(1.0);
        factors.extend(selected.iter().map(|&j| implied[j].mid()));
        for i in 0..self.dim() {
            entries.clear();
            entries.push(self.body.center[i]);
            entries.extend(selected.iter().map(|&j| self.body.generators.col(j)[i]));
            let (value, error) = dot_compensated(factors, entries);
            self.body.center[i] = value;
            self.body.remainder[i] = add_lengths(self.body.remainder[i], error);
        }
        for (i, range) in self.ranges.iter_mut().enumerate() {
            let mut shifted = |end: f64| {
                entries.clear();
                entries.push(end);
                entries.extend(selected.iter().map(|&j| -self.constraints.col(j)[i]));
                let (value, error) = dot_compensated(factors, entries);
                Interval::point(value).inflate(error)
            };
            *range = match (range.lo(), range.hi()) {
                (lo, hi) if lo == hi => shifted(lo),
                (lo, hi) => shifted(lo).hull(shifted(hi)),
            };
        }
        for &j in selected.iter() {
            self.shrink(j, implied[j].rad());
        }
        true
    }

    /// Shrinks column `j` by a factor.
    fn shrink(&mut self, j: usize, radius: f64) {
        let constant = radius <= CONSTANT;
        let shrunk = |entry: f64| if constant { (0.0, mul_up(entry.abs(), radius)) } else { product(entry, radius) };
        for (g, r) in self.body.generators.col_mut(j).iter_mut().zip(&mut self.body.remainder) {
            let (entry, error) = shrunk(*g);
            *g = entry;
            *r = add_lengths(*r, error);
        }
        for (a, range) in self.constraints.col_mut(j).iter_mut().zip(&mut self.ranges) {
            let (entry, error) = shrunk(*a);
            *a = entry;
            *range = range.inflate(error);
        }
    }

    /// Clips every range to what its row can reach.
    pub(super) fn clip_ranges(&mut self) {
        for i in 0..self.ranges.len() {
            self.ranges[i] = clip(self.ranges[i], self.row_bound(i));
        }
    }

    /// Drops the rows that every `|xi| <= 1` satisfies, or misses by rounding.
    pub(super) fn drop_loose_rows(&mut self) {
        let loose = |set: &Self, i: usize| {
            let norm = set.row_bound(i) * (1.0 - ROUNDING);
            set.ranges[i].lo() <= -norm && norm <= set.ranges[i].hi()
        };
        for i in (0..self.ranges.len()).rev() {
            if loose(self, i) {
                self.remove_row(i);
            }
        }
    }

    /// Drops one row: a superset.
    pub(super) fn remove_row(&mut self, row: usize) {
        self.constraints.retain_rows(|i| i != row);
        self.ranges.remove(row);
    }
}

/// The rounded product `a b` and a bound of its error.
pub(super) fn product(a: f64, b: f64) -> (f64, f64) {
    let value = a * b;
    if value.abs() > 1e-280 {
        // The rounding error of a product far from underflow is itself a number.
        return (value, a.mul_add(b, -value).abs());
    }
    (value, if a == 0.0 || b == 0.0 { 0.0 } else { ETA })
}

/// The rounded difference `x - a b` and a bound of its error.
pub(super) fn residual(x: f64, a: f64, b: f64) -> (f64, f64) {
    let (value, error) = product(a, b);
    if value == 0.0 {
        return (x, error);
    }
    let difference = x - value;
    (difference, add_up(error, up(0.5 * f64::EPSILON * difference.abs())))
}
