//! Sine, cosine, tangent and their inverses.
//!
//! Sine and cosine are decided by the signs of their derivatives at the two ends: over less than a half turn a derivative has
//! at most one zero, over less than a full turn at most two. No argument reduction is done here, so that arguments of any
//! size stay tight. Values come from `pxfm`, two units outward as in [`crate::elementary`].

use crate::Interval;
use crate::elementary::{above, around, below};
use crate::rounding::{larger, smaller};

impl Interval {
    /// `{ sin(x) }`, `x` in radians.
    #[must_use]
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// `{ cos(x) }`, `x` in radians.
    #[must_use]
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// `({ sin(x) }, { cos(x) })`, `x` in radians.
    ///
    /// ```
    /// use scalars::Interval;
    /// let (sin, cos) = Interval::new(-0.1, 2.0)?.sin_cos();
    /// assert!(sin.hi() == 1.0 && cos.hi() == 1.0 && cos.lo() < 0.0);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        if self.is_empty() {
            return (self, self);
        }
        // Rounded up, and the constants are below pi and 2 pi: no turn is missed.
        let width = self.width();
        if width > 2.0 * Self::PI.lo {
            return (Self::raw(-1.0, 1.0), Self::raw(-1.0, 1.0));
        }
        let (sin_lo, cos_lo) = pxfm::f_sincos(self.lo);
        let (sin_hi, cos_hi) = if self.lo == self.hi { (sin_lo, cos_lo) } else { pxfm::f_sincos(self.hi) };
        let over_half_turn = width > Self::PI.lo;
        (
            range((sin_lo, sin_hi), (cos_lo, cos_hi), over_half_turn),
            range((cos_lo, cos_hi), (-sin_lo, -sin_hi), over_half_turn),
        )
    }

    /// `{ tan(x) : cos(x) != 0 }`, `x` in radians.
    #[must_use]
    pub fn tan(self) -> Self {
        if self.is_empty() {
            return self;
        }
        // Over less than a half turn there is a pole inside exactly if the cosine changes sign; it is zero at no bound.
        let positive = |x: f64| pxfm::f_cos(x) > 0.0;
        let no_pole = self.lo == self.hi || (self.width() <= Self::PI.lo && positive(self.lo) == positive(self.hi));
        if no_pole { self.increasing(pxfm::f_tan) } else { Self::ENTIRE }
    }

    /// `{ asin(x) : |x| <= 1 }` in `[-pi/2, pi/2]`; empty if no member is in `[-1, 1]`.
    #[must_use]
    pub fn asin(self) -> Self {
        let quarter = Self::FRAC_PI_2.hi;
        self.intersection(Self::raw(-1.0, 1.0)).increasing(pxfm::f_asin).intersection(Self::raw(-quarter, quarter))
    }

    /// `{ acos(x) : |x| <= 1 }` in `[0, pi]`; empty if no member is in `[-1, 1]`.
    #[must_use]
    pub fn acos(self) -> Self {
        let x = self.intersection(Self::raw(-1.0, 1.0));
        if x.is_empty() {
            return x;
        }
        Self::raw(below(pxfm::f_acos(x.hi)), smaller(Self::PI.hi, above(pxfm::f_acos(x.lo))))
    }

    /// `{ atan(x) }` in `[-pi/2, pi/2]`.
    #[must_use]
    pub fn atan(self) -> Self {
        let quarter = Self::FRAC_PI_2.hi;
        self.increasing(pxfm::f_atan).intersection(Self::raw(-quarter, quarter))
    }

    /// `{ angle of the point (x, y) in (-pi, pi] : (x, y) != 0 }`, where `self` is `y`.
    ///
    /// A box that meets the cut (`y = 0`, `x < 0`) and reaches below it gives `[-pi, pi]`; `{ 0 } x { 0 }` gives the empty set.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let (y, zero) = (self, Self::ZERO);
        if y.is_empty() || x.is_empty() || (y == zero && x == zero) {
            return Self::EMPTY;
        }
        if y.lo < 0.0 && y.hi >= 0.0 && x.lo < 0.0 {
            return Self::raw(-Self::PI.hi, Self::PI.hi);
        }
        if y.lo < 0.0 && y.hi <= 0.0 {
            return -(-y).atan2(x);
        }
        // Now y.hi >= 0. The extreme angles are at corners; a corner at the origin gives way to its neighbour.
        let (least, greatest) = if y.lo < 0.0 {
            ((y.lo, x.lo), (y.hi, x.lo))
        } else {
            let least = match (x.hi >= 0.0, y.lo == 0.0 && x.hi == 0.0) {
                (_, true) if y.hi > 0.0 => (y.hi, 0.0),
                (_, true) => (0.0, x.lo),
                (true, _) => (y.lo, x.hi),
                (false, _) => (y.hi, x.hi),
            };
            let greatest = match (x.lo >= 0.0, y.hi == 0.0 && x.lo == 0.0) {
                (_, true) => (0.0, x.hi),
                (true, _) => (y.hi, x.lo),
                (false, _) => (y.lo, x.lo),
            };
            (least, greatest)
        };
        Self::raw(angle(least.0, least.1).lo, angle(greatest.0, greatest.1).hi)
    }
}

/// Enclosure of the angle of the point `(x, y)`, which is not the origin.
fn angle(y: f64, x: f64) -> Interval {
    let pi = Interval::PI;
    if y == 0.0 {
        // The sign of a zero has no meaning for a bound.
        return if x < 0.0 { pi } else { Interval::ZERO };
    }
    let angle = around(pxfm::f_atan2(y, x));
    if y > 0.0 { angle.intersection(Interval::raw(0.0, pi.hi)) } else { angle.intersection(Interval::raw(-pi.hi, 0.0)) }
}

/// Range of sine or cosine over less than a full turn, from its values and its slopes at the two ends.
fn range(values: (f64, f64), slopes: (f64, f64), over_half_turn: bool) -> Interval {
    let rises_then_falls = slopes.0 > 0.0 && slopes.1 < 0.0;
    let falls_then_rises = slopes.0 < 0.0 && slopes.1 > 0.0;
    // Slopes of one sign: no extremum inside up to a half turn, both beyond it.
    let (maximum, minimum) =
        if over_half_turn { (!falls_then_rises, !rises_then_falls) } else { (rises_then_falls, falls_then_rises) };
    let lo = if minimum { -1.0 } else { below(smaller(values.0, values.1)) };
    let hi = if maximum { 1.0 } else { above(larger(values.0, values.1)) };
    Interval::raw(larger(-1.0, lo), smaller(1.0, hi))
}
