//! Minkowski sum `X + Y = { x + y : x in X, y in Y }`.

use scalars::Interval;

use super::ConstrainedZonotope;
use crate::SetError;

impl ConstrainedZonotope {
    /// Minkowski sum of two constrained zonotopes.
    ///
    /// `<c, G, r; A, [a]> + <d, H, s; B, [b]> = <c + d, [G H], r + s; diag(A, B), ([a], [b])>`.
    ///
    /// **Guarantee:** superset of the exact sum; only the rounding of `c + d` and `r + s` is added, to the box remainder.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Proposition 1.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the sets live in different spaces, [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::ConstrainedZonotope;
    /// let x = ConstrainedZonotope::from_box(&[0.0, 1.0], &[0.5, 0.5])?;
    /// let noise = ConstrainedZonotope::from_box(&[0.0, 0.0], &[0.1, 0.1])?;
    /// assert!(x.minkowski_sum(&noise)?.remainder()[0] >= 0.6);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn minkowski_sum(&self, other: &Self) -> Result<Self, SetError> {
        let mut sum = self.clone();
        sum.add_assign(other)?;
        Ok(sum)
    }

    /// [`minkowski_sum`](Self::minkowski_sum) in place; allocates nothing within capacity.
    ///
    /// # Errors
    /// As [`minkowski_sum`](Self::minkowski_sum); the set is then unchanged.
    pub fn add_assign(&mut self, other: &Self) -> Result<(), SetError> {
        self.body.add_assign(&other.body)?;
        self.append_constraints(other);
        Ok(())
    }

    /// Minkowski sum with a box, in place: its midpoint moves the center, its radii join the remainder. Allocates nothing.
    ///
    /// **Guarantee:** superset of the exact sum; only rounding is added, to the box remainder.
    ///
    /// # Errors
    /// As [`Zonotope::add_box`](crate::Zonotope::add_box); the set is then unchanged.
    pub fn add_box(&mut self, sides: &[Interval]) -> Result<(), SetError> {
        self.body.add_box(sides)
    }
}
