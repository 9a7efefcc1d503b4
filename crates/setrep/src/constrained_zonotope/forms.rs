//! Equivalent forms: the box remainder as generators, ranges as points.

use scalars::Interval;

use super::ConstrainedZonotope;
use crate::SetError;

impl ConstrainedZonotope {
    /// Turns the box remainder into generators: `<c, G, r; A, [b]>` becomes `<c, [G diag(r)], 0; [A 0], [b]>`, zero columns left out.
    ///
    /// **Guarantee:** exact (the same set).
    ///
    /// ```
    /// # use setrep::ConstrainedZonotope;
    /// let mut x = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 0.0])?;
    /// x.materialize();
    /// assert_eq!((x.num_generators(), x.remainder()), (1, &[0.0, 0.0][..]));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn materialize(&mut self) {
        self.body.materialize();
        self.pad_constraints();
    }

    /// Turns the components of the box remainder that are of model size into generators; see
    /// [`Zonotope::materialize_model_size`](crate::Zonotope::materialize_model_size).
    ///
    /// **Guarantee:** exact (the same set).
    pub fn materialize_model_size(&mut self) {
        self.body.materialize_model_size();
        self.pad_constraints();
    }

    /// The textbook form (CG-rep) of the set: `r = 0` and every range a point, one slack generator for each range with width.
    ///
    /// `A_i xi in m +- s` becomes `A_i xi - s zeta = m`, `|zeta| <= 1`, with midpoint `m` and radius `s` of the range.
    ///
    /// **Guarantee:** exact in real arithmetic; a superset by the rounding of `m` and `s`.
    ///
    /// # Errors
    /// [`SetError::Overflow`] if a row with its slack does.
    pub fn textbook_form(&self) -> Result<Self, SetError> {
        let mut set = self.clone();
        set.materialize();
        for i in 0..set.ranges.len() {
            let (middle, radius) = (set.ranges[i].mid(), set.ranges[i].rad());
            if radius > 0.0 {
                set.body.generators.push_zero_cols(1);
                set.constraints.push_axis(i, -radius);
                set.ranges[i] = Interval::point(middle);
                set.row_norm(i)?;
            }
        }
        Ok(set)
    }
}
