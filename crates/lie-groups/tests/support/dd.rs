//! Double-double numbers: an unevaluated sum of two `f64`, about 32 digits.
//!
//! The reference arithmetic of the tests: its error (2^-100 relative) is far below the last place of any bound it judges.
//! Algorithms: Dekker 1971, Knuth (two-sum), with the fused multiply-add for the product error.

use std::ops::{Add, Div, Mul, Neg, Sub};

use scalars::Interval;

/// `hi + lo` with `|lo| <= ulp(hi) / 2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dd {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl Dd {
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    pub(crate) const ONE: Self = Self { hi: 1.0, lo: 0.0 };

    fn quick_two_sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        Self { hi, lo: b - (hi - a) }
    }

    fn two_sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let rest = hi - a;
        Self { hi, lo: (a - (hi - rest)) + (b - rest) }
    }

    fn two_product(a: f64, b: f64) -> Self {
        let hi = a * b;
        Self { hi, lo: a.mul_add(b, -hi) }
    }

    pub(crate) fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// `hi + lo >= x` for an `f64` number `x` (the difference of `hi` and `x` is exact where it matters: when they are close).
    pub(crate) fn at_least(self, x: f64) -> bool {
        (self.hi - x) + self.lo >= 0.0
    }

    /// Membership, up to the error of a reference value: 2^-98 of itself.
    pub(crate) fn in_interval(self, bounds: &Interval) -> bool {
        let error = Self::from(self.hi.abs() * 2.0_f64.powi(-98));
        (self + error).at_least(bounds.lo()) && (error - self).at_least(-bounds.hi())
    }

    /// An interval that contains the number this one approximates: the neighbours of `hi`; zero is taken for exact.
    pub(crate) fn enclose(self) -> Interval {
        if self == Self::ZERO {
            return Interval::ZERO;
        }
        Interval::new(self.hi.next_down(), self.hi.next_up()).unwrap()
    }
}

impl From<f64> for Dd {
    fn from(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
}

impl Neg for Dd {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for Dd {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = Self::two_sum(self.hi, other.hi);
        let low = Self::two_sum(self.lo, other.lo);
        let sum = Self::quick_two_sum(high.hi, high.lo + low.hi);
        Self::quick_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Sub for Dd {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = Self::two_product(self.hi, other.hi);
        Self::quick_two_sum(high.hi, high.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for Dd {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // Long division: three quotient digits.
        let first = self.hi / other.hi;
        let rest = self - other * first.into();
        let second = rest.hi / other.hi;
        let rest = rest - other * second.into();
        let third = rest.hi / other.hi;
        Self::quick_two_sum(first, second) + third.into()
    }
}
