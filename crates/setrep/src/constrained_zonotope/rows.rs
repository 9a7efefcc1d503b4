//! Rows of constraints: their size, their clipping, and rows formed as products, with the rounding in the ranges.

use scalars::Interval;

use super::ConstrainedZonotope;
use crate::bounds::{gamma, product_sum_bound, sum_bound};
use crate::{Matrix, Part, SetError};

impl ConstrainedZonotope {
    /// Upper bound of `|A_i|_1`, which must be finite.
    pub(super) fn row_norm(&self, i: usize) -> Result<f64, SetError> {
        let sum: f64 = (0..self.num_generators()).map(|j| self.constraints.col(j)[i].abs()).sum();
        finite_norm(i, sum, self.num_generators())
    }

    /// The row of `a'x in [d]`, an intersection: writes `a'G` to `row` and returns `[d] - a'c +- |a|'r`, widened by the rounding of the
    /// row and clipped to its reach. `norm` is the sum of absolute values of `entries` further entries that the row will have.
    /// `None` if something overflows.
    pub(super) fn form_row(
        &self,
        a: &[f64],
        range: Interval,
        row: &mut [f64],
        norm: f64,
        entries: usize,
    ) -> Option<Interval> {
        let error = combine(a, self.generators(), row);
        let reach = sum_bound(norm + row.iter().map(|x| x.abs()).sum::<f64>(), row.len() + entries);
        let offset = combine_box(a, self.center(), self.remainder());
        let shifted = (range - offset).inflate(error);
        let bounded = error.is_finite() && reach.is_finite() && offset.is_bounded() && !shifted.is_empty();
        bounded.then(|| clip(shifted, reach))
    }

    /// Clips the ranges of new rows; makes the set its body if one of them has no finite bound.
    pub(crate) fn settle_ranges(&mut self) -> Result<(), SetError> {
        let settled = (0..self.ranges.len()).try_for_each(|i| {
            let norm = self.row_norm(i)?;
            self.ranges[i] = clip(self.ranges[i], norm);
            if self.ranges[i].is_bounded() { Ok(()) } else { Err(SetError::Overflow { row: i }) }
        });
        if settled.is_err() {
            self.ranges.clear();
            self.constraints.reset(0, self.body.num_generators());
        }
        settled
    }

    /// Gives the constraint matrix the zero columns of generators that were appended to the body.
    pub(super) fn pad_constraints(&mut self) {
        self.constraints.push_zero_cols(self.body.num_generators() - self.constraints.cols());
    }
}

/// Upper bound of the exact sum of absolute entries of row `i` from the computed one.
pub(super) fn finite_norm(i: usize, sum: f64, entries: usize) -> Result<f64, SetError> {
    let norm = sum_bound(sum, entries);
    if norm.is_finite() { Ok(norm) } else { Err(SetError::Overflow { row: i }) }
}

/// `Ok` if a range has points.
pub(super) fn check_not_empty(row: usize, range: &Interval) -> Result<(), SetError> {
    if range.is_empty() { Err(SetError::EmptyInterval { part: Part::Range, row }) } else { Ok(()) }
}

/// The part of a range that a row with `|A_i xi| <= norm` can reach: always bounded. A range out of reach shrinks to its near end,
/// which is out of reach as well.
pub(super) fn clip(range: Interval, norm: f64) -> Interval {
    let (mut lo, mut hi) = (range.lo(), range.hi());
    if lo < -norm {
        lo = hi.min(-norm);
    }
    if hi > norm {
        hi = lo.max(norm);
    }
    Interval::new(lo, hi).unwrap_or(range)
}

/// Writes `a'G` to `product` (length `ng`) and returns an upper bound of the 1-norm of its rounding errors; infinite or NaN if
/// something overflows.
///
/// An entry is off by at most `gamma_z sum_k |a_k G_kj|` with `z` nonzero coefficients, and by `eta` a product for underflow.
pub(super) fn combine(a: &[f64], generators: &Matrix, product: &mut [f64]) -> f64 {
    let nonzeros = a.iter().filter(|&&a| a != 0.0).count();
    let (mut magnitude, mut products) = (0.0, 0);
    for (j, target) in product.iter_mut().enumerate() {
        let mut dot = 0.0;
        for (a, g) in a.iter().zip(generators.col(j)) {
            let term = a * g;
            dot += term;
            magnitude += term.abs();
            products += usize::from(*a != 0.0 && *g != 0.0);
        }
        *target = dot;
    }
    if nonzeros <= 1 && a.iter().all(|&a| a == 0.0 || a.abs() == 1.0) {
        // The row selects or negates one coordinate: exact.
        return 0.0;
    }
    let magnitude = product_sum_bound(magnitude, products, a.len() + product.len());
    product_sum_bound(gamma(nonzeros) * magnitude, products, 1)
}

/// Encloses `a'x` for `x` in `center +- radius`.
pub(super) fn combine_box(a: &[f64], center: &[f64], radius: &[f64]) -> Interval {
    let mut sum = Interval::ZERO;
    for ((&a, &c), &r) in a.iter().zip(center).zip(radius) {
        if a != 0.0 {
            sum += Interval::point(c).inflate(r).scale(a);
        }
    }
    sum
}
