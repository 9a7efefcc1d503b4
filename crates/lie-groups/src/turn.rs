//! Rotations of the plane as the groups store them.

use crate::{Coeff, Complex};

/// A rotation of the plane: its unit complex number, and over intervals the range of its angle.
///
/// Over `f64` this is one unit complex number. Over `Interval` it is the set of rotations by the angles of [`arc`](Self::arc), and
/// [`unit`](Self::unit) encloses their cosines and sines. The arc is kept because products add angles exactly, whereas products of boxes of cosines and
/// sines would widen by a factor up to `|cos| + |sin|` each (the wrapping effect), `e^(2 pi)` in a full turn of small steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<S: Coeff> {
    unit: Complex<S>,
    arc: S::Arc,
}

impl<S: Coeff> Turn<S> {
    /// A rotation from its two descriptions, which must agree.
    #[inline]
    pub(crate) fn new(unit: Complex<S>, arc: S::Arc) -> Self {
        Self { unit, arc }
    }

    /// Cosine and sine, `cos theta + i sin theta`.
    #[inline]
    pub fn unit(&self) -> Complex<S> {
        self.unit
    }

    /// Range of the angle, in radians, not reduced to `(-pi, pi)`; `()` over `f64`.
    #[inline]
    pub fn arc(&self) -> S::Arc {
        self.arc
    }
}
