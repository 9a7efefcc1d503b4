//! Translation and scaling.

use super::ConstrainedZonotope;
use crate::SetError;

impl ConstrainedZonotope {
    /// Translation `t + X`; the constraints do not change.
    ///
    /// **Guarantee:** superset of the exact translate; the rounding of `c + t` goes to the box remainder.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`], [`SetError::Overflow`]; the set is then unchanged.
    pub fn translate(&mut self, translation: &[f64]) -> Result<(), SetError> {
        self.body.translate(translation)
    }

    /// Scaling `a X = { a x : x in X }` about the origin: `<a c, a G, |a| r; A, [b]>`.
    ///
    /// **Guarantee:** superset of the exact set, exact for `a` in `{-1, 0, 1}`.
    ///
    /// # Errors
    /// [`SetError::NonFinite`] for the factor, [`SetError::Overflow`]; the set is then unchanged.
    pub fn scale(&mut self, factor: f64) -> Result<(), SetError> {
        self.body.scale(factor)
    }
}
