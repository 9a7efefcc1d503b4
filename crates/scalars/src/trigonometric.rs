//! Sine, cosine, tangent and their inverses.

use crate::Interval;
use crate::elementary::{above, below};
use crate::rounding::{larger, smaller};

impl Interval {
    /// `{ sin(x) }`.
    #[must_use]
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// `{ cos(x) }`.
    #[must_use]
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// `({ sin(x) }, { cos(x) })`.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        if self.is_empty() {
            return (self, self);
        }
        let unit = Self::raw(-1.0, 1.0);
        // Over less than a half turn the derivative has at most one zero, seen from its signs at the ends.
        if !(self.width() < Self::PI.lo) {
            return (unit, unit);
        }
        let (sin_lo, cos_lo) = pxfm::f_sincos(self.lo);
        let (sin_hi, cos_hi) = pxfm::f_sincos(self.hi);
        (
            range(sin_lo, sin_hi, cos_lo, cos_hi),
            range(cos_lo, cos_hi, -sin_lo, -sin_hi),
        )
    }

    /// `{ tan(x) }`.
    #[must_use]
    pub fn tan(self) -> Self {
        if self.is_empty() {
            return self;
        }
        if self.width() < Self::PI.lo
            && (pxfm::f_cos(self.lo) > 0.0) == (pxfm::f_cos(self.hi) > 0.0)
        {
            return self.increasing(pxfm::f_tan);
        }
        Self::ENTIRE
    }

    /// `{ asin(x) : |x| <= 1 }`.
    #[must_use]
    pub fn asin(self) -> Self {
        self.intersection(Self::raw(-1.0, 1.0))
            .increasing(pxfm::f_asin)
    }

    /// `{ acos(x) : |x| <= 1 }`.
    #[must_use]
    pub fn acos(self) -> Self {
        let x = self.intersection(Self::raw(-1.0, 1.0));
        if x.is_empty() {
            return x;
        }
        Self::raw(below(pxfm::f_acos(x.hi)), above(pxfm::f_acos(x.lo)))
    }

    /// `{ atan(x) }`.
    #[must_use]
    pub fn atan(self) -> Self {
        self.increasing(pxfm::f_atan)
    }

    /// `{ atan2(y, x) : (x, y) != 0 }`, `self` is `y`: the angle of the point `(x, y)` in `(-pi, pi]`.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let y = self;
        if y.is_empty() || x.is_empty() || (y == Self::ZERO && x == Self::ZERO) {
            return Self::EMPTY;
        }
        let angle =
            |y: f64, x: f64| Self::raw(below(pxfm::f_atan2(y, x)), above(pxfm::f_atan2(y, x)));
        if y.lo < 0.0 && y.hi >= 0.0 && x.lo < 0.0 {
            return Self::raw(-Self::PI.hi, Self::PI.hi);
        }
        if y.lo < 0.0 && y.hi <= 0.0 {
            return -((-y).atan2(x));
        }
        let corners = [(y.lo, x.lo), (y.lo, x.hi), (y.hi, x.lo), (y.hi, x.hi)];
        corners
            .into_iter()
            .filter(|&(y, x)| y != 0.0 || x != 0.0)
            .map(|(y, x)| angle(y + 0.0, x + 0.0))
            .fold(Self::EMPTY, Self::hull)
    }
}

/// Image of a function over less than a half turn, from its values and the signs of its derivative at the ends.
fn range(lo: f64, hi: f64, slope_lo: f64, slope_hi: f64) -> Interval {
    let (mut min, mut max) = (below(smaller(lo, hi)), above(larger(lo, hi)));
    if slope_lo >= 0.0 && slope_hi <= 0.0 {
        max = 1.0;
    }
    if slope_lo <= 0.0 && slope_hi >= 0.0 {
        min = -1.0;
    }
    Interval::raw(larger(-1.0, min), smaller(1.0, max))
}
