//! Translation and scaling.

use scalars::rounding::mul_up;

use crate::bounds::{add_abs_row_sums, add_lengths, product_sum_bound, sum_bound, two_sum};
use crate::{Part, SetError, Zonotope};

impl Zonotope {
    /// Translation `t + X`.
    ///
    /// **Guarantee:** superset of the exact translate; the rounding of `c + t` goes to the box remainder.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`], [`SetError::Overflow`]; the set is then unchanged.
    pub fn translate(&mut self, translation: &[f64]) -> Result<(), SetError> {
        SetError::check_size(Part::Translation, self.dim(), translation.len())?;
        SetError::check_finite(Part::Translation, translation.len(), translation)?;
        self.shift(translation, &[])
    }

    /// Scaling `a X = { a x : x in X }` about the origin.
    ///
    /// `a <c, G, r> = <a c, a G, |a| r>`.
    ///
    /// **Guarantee:** superset of the exact set, exact for `a` in `{-1, 0, 1}`.
    ///
    /// # Errors
    /// [`SetError::NonFinite`] for the factor, [`SetError::Overflow`]; the set is then unchanged.
    pub fn scale(&mut self, factor: f64) -> Result<(), SetError> {
        SetError::check_finite(Part::Factor, 1, &[factor])?;
        let a = factor.abs();
        let mut sums = vec![0.0; self.dim()];
        add_abs_row_sums(self.generators.as_slice(), &mut sums);
        let columns = self.num_generators() + 1;
        for (i, sum) in sums.iter_mut().enumerate() {
            let extent = sum_bound(*sum + self.center[i].abs(), columns + 4);
            let image = mul_up(a, extent);
            // Each product is off by at most u times itself, or half of eta.
            let products = if a == 0.0 || a == 1.0 || extent == 0.0 { 0 } else { columns };
            let rounding = if products == 0 { 0.0 } else { product_sum_bound(f64::EPSILON * image, products, 1) };
            *sum = if a == 1.0 { self.remainder[i] } else { add_lengths(mul_up(a, self.remainder[i]), rounding) };
            let bounded = image + *sum < f64::MAX;
            if !bounded {
                return Err(SetError::Overflow { row: i });
            }
        }
        for x in self.center.iter_mut().chain(self.generators.as_mut_slice()) {
            *x *= factor;
        }
        self.remainder = sums;
        Ok(())
    }

    /// Adds `shift` to the center and `extra` (if not empty) to the remainder, and the rounding of both to the remainder.
    /// The lengths are the caller's to check.
    pub(crate) fn shift(&mut self, shift: &[f64], extra: &[f64]) -> Result<(), SetError> {
        let moved = |set: &Self, i: usize| {
            let (center, error) = two_sum(set.center[i], shift[i]);
            let remainder = add_lengths(set.remainder[i], extra.get(i).copied().unwrap_or(0.0));
            (center, add_lengths(remainder, error.abs()))
        };
        for i in 0..self.dim() {
            let (center, remainder) = moved(self, i);
            if !(center.is_finite() && remainder.is_finite()) {
                return Err(SetError::Overflow { row: i });
            }
        }
        for i in 0..self.dim() {
            (self.center[i], self.remainder[i]) = moved(self, i);
        }
        Ok(())
    }
}
