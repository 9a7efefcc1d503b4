//! Minkowski sum `X + Y = { x + y : x in X, y in Y }`.

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
