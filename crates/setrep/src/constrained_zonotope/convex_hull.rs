//! Convex hull of two constrained zonotopes.

use scalars::Interval;

use super::ConstrainedZonotope;
use super::rescale::product;
use crate::bounds::add_lengths;
use crate::{Matrix, Part, SetError};

impl ConstrainedZonotope {
    /// Convex hull `{ l x + (1 - l) y : x in X, y in Y, 0 <= l <= 1 }`.
    ///
    /// With `l = (1 + t) / 2` and the scaled coordinates `l xi`, `(1 - l) eta` of members, the hull of `<c, G; A, [a]>` and
    /// `<d, H; B, [b]>` is
    /// `(c + d) / 2 + (c - d) / 2 t + G xi + H eta` with `|xi_j| <= (1 + t) / 2`, `|eta_j| <= (1 - t) / 2`, `A xi in (1 + t) / 2 [a]`,
    /// `B eta in (1 - t) / 2 [b]`: `ng_x + ng_y + 1` generators and two rows for each of the first and for each range with width.
    /// Remainders of model size become generators first; of what is left the larger encloses.
    ///
    /// **Guarantee:** superset of the exact hull, by rounding only; the other set if one of them is empty.
    /// **Source:** Raghuraman, Koeln 2022, Theorem 5, with ranges in place of slacks.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the sets live in different spaces, [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Workspace};
    /// let x = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let y = ConstrainedZonotope::from_box(&[4.0, 0.0], &[0.0, 0.0])?;
    /// let mut workspace = Workspace::new();
    /// let hull = x.convex_hull(&y)?;
    /// assert!((4.0..4.0 + 1e-13).contains(&hull.support(&[1.0, 3.0], &mut workspace)?));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn convex_hull(&self, other: &Self) -> Result<Self, SetError> {
        SetError::check_size(Part::Center, self.dim(), other.dim())?;
        let (mut x, mut y) = (self.clone(), other.clone());
        for set in [&mut x, &mut y] {
            set.body.materialize_model_size();
            set.pad_constraints();
        }
        let n = x.dim();
        let mut hull = Self::from(x.body.clone());
        hull.body.generators.append_columns(y.generators().as_slice());
        hull.body.generators.push_zero_cols(1);
        let last = hull.num_generators() - 1;
        for i in 0..n {
            let (c, d) = (Interval::point(x.center()[i]), Interval::point(y.center()[i]));
            let (middle, half) = ((c + d).scale(0.5), (c - d).scale(0.5));
            hull.body.center[i] = middle.mid();
            hull.body.generators.col_mut(last)[i] = half.mid();
            let larger = x.remainder()[i].max(y.remainder()[i]);
            let remainder = add_lengths(larger, add_lengths(middle.rad(), half.rad()));
            let fits = hull.body.center[i].is_finite() && half.is_bounded() && remainder.is_finite();
            if !fits {
                return Err(SetError::Overflow { row: i });
            }
            hull.body.remainder[i] = remainder;
        }
        let mut rows = Rows { columns: hull.num_generators(), entries: Vec::new(), ranges: Vec::new() };
        rows.share(&x, 0, 1.0);
        rows.share(&y, x.num_generators(), -1.0);
        let count = rows.ranges.len();
        hull.constraints = Matrix::from_column_slice(rows.columns, count, &rows.entries)?.transpose();
        hull.ranges = rows.ranges;
        hull.settle_ranges()?;
        Ok(hull)
    }
}

/// Rows being collected, one after the other.
struct Rows {
    columns: usize,
    entries: Vec<f64>,
    ranges: Vec<Interval>,
}

impl Rows {
    /// The rows of one set, whose coordinates start at column `first` and have the share `(1 + sign t) / 2`.
    fn share(&mut self, set: &ConstrainedZonotope, first: usize, sign: f64) {
        let upper = |bound: f64| Interval::new(f64::NEG_INFINITY, bound).unwrap_or(Interval::ENTIRE);
        for j in 0..set.num_generators() {
            for side in [1.0, -1.0] {
                // side xi_j - sign t / 2 <= 1 / 2.
                let row = self.start(-0.5 * sign, upper(0.5));
                row[first + j] = side;
            }
        }
        for (i, range) in set.ranges.iter().enumerate() {
            let ends = if range.lo() == range.hi() { vec![0.0] } else { vec![1.0, -1.0] };
            for side in ends {
                // side A_i xi - sign b / 2 t <= b / 2, with b the upper end of side [b_i]; both ends at once for a point.
                let (factor, b) = match side {
                    1.0 => (1.0, range.hi()),
                    -1.0 => (-1.0, -range.lo()),
                    _ => (1.0, range.lo()),
                };
                let (half, error) = product(0.5, b);
                let bound = Interval::point(half).inflate(2.0 * error);
                let bound = if side == 0.0 { bound } else { upper(bound.hi()) };
                let row = self.start(-sign * half, bound);
                for j in 0..set.num_generators() {
                    row[first + j] = factor * set.constraints.col(j)[i];
                }
            }
        }
    }

    /// Appends a row of zeros but for the entry of `t`, the last one.
    fn start(&mut self, t: f64, range: Interval) -> &mut [f64] {
        let first = self.entries.len();
        self.entries.resize(first + self.columns, 0.0);
        self.ranges.push(range);
        let row = &mut self.entries[first..];
        row[self.columns - 1] = t;
        row
    }
}
