//! Minkowski sum `X + Y = { x + y : x in X, y in Y }`.

use scalars::Interval;

use crate::bounds::{add_lengths, two_sum};
use crate::{Matrix, Part, SetError, Zonotope};

impl Zonotope {
    /// Minkowski sum of two zonotopes.
    ///
    /// `<c, G, r> + <d, H, s> = <c + d, [G H], r + s>`, shapes `G: n x ng`, `H: n x nh`.
    ///
    /// **Guarantee:** superset of the exact sum; only the rounding of `c + d` and `r + s` is added, to the box remainder.
    /// **Source:** paper 000, Property 2.1.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the sets live in different spaces, [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let x = Zonotope::from_box(&[0.0, 1.0], &[0.5, 0.5])?;
    /// let noise = Zonotope::from_box(&[0.0, 0.0], &[0.1, 0.1])?;
    /// let sum = x.minkowski_sum(&noise)?;
    /// assert!(sum.interval_hull()[0].contains(0.6));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn minkowski_sum(&self, other: &Self) -> Result<Self, SetError> {
        let mut sum = self.clone();
        sum.add_assign(other)?;
        Ok(sum)
    }

    /// [`minkowski_sum`](Self::minkowski_sum) in place: appends `other`'s generators, allocates nothing within capacity.
    ///
    /// # Errors
    /// As [`minkowski_sum`](Self::minkowski_sum); the set is then unchanged.
    pub fn add_assign(&mut self, other: &Self) -> Result<(), SetError> {
        SetError::check_size(Part::Center, self.dim(), other.dim())?;
        self.shift(&other.center, &other.remainder)?;
        self.generators.append_columns(other.generators.as_slice());
        Ok(())
    }

    /// Minkowski sum with a box, in place: its midpoint moves the center, its radii join the remainder. Allocates nothing.
    ///
    /// **Guarantee:** superset of the exact sum; only the rounding of midpoint, radii and sums is added, to the box remainder.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::UnboundedInterval`] for an empty or unbounded side, [`SetError::Overflow`]; the set is then
    /// unchanged.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::Zonotope;
    /// let mut x = Zonotope::from_box(&[0.0, 1.0], &[0.5, 0.5])?;
    /// x.add_box(&[Interval::new(0.0, 1.0).unwrap_or_default(), Interval::ZERO])?;
    /// assert!(x.center() == [0.5, 1.0] && (1.0..1.0 + 1e-15).contains(&x.remainder()[0]) && x.remainder()[1] == 0.5);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn add_box(&mut self, sides: &[Interval]) -> Result<(), SetError> {
        SetError::check_size(Part::Interval, self.dim(), sides.len())?;
        let moved = |set: &Self, i: usize| {
            let (center, error) = two_sum(set.center[i], sides[i].mid());
            (center, add_lengths(add_lengths(set.remainder[i], sides[i].rad()), error.abs()))
        };
        for (row, side) in sides.iter().enumerate() {
            if !side.is_bounded() {
                return Err(SetError::UnboundedInterval { part: Part::Interval, row, col: 0 });
            }
            let (center, remainder) = moved(self, row);
            if !(center.is_finite() && remainder.is_finite()) {
                return Err(SetError::Overflow { row });
            }
        }
        for i in 0..sides.len() {
            (self.center[i], self.remainder[i]) = moved(self, i);
        }
        Ok(())
    }

    /// Minkowski sum with `{ H xi : |xi| <= 1 }`: appends the columns of `H: n x nh`, allocates nothing within capacity.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`]; the set is then unchanged.
    pub fn append_generators(&mut self, columns: &Matrix) -> Result<(), SetError> {
        SetError::check_size(Part::Generators, self.dim(), columns.rows())?;
        SetError::check_finite(Part::Generators, columns.rows(), columns.as_slice())?;
        self.generators.append_columns(columns.as_slice());
        Ok(())
    }
}
