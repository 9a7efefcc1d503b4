//! `+ - * /`, squares and roots of intervals, rounded outward.
//!
//! Bounds are computed to nearest and stepped outward ([`rounding`](crate::rounding)). Bounded operands take a path of
//! straight-line code; the rest of IEEE 1788 (empty, unbounded, division by an interval with zero) is in cold functions.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Interval;
use crate::rounding::{
    div_down, div_up, larger, mul_down, mul_up, smaller, step_down, step_down_nonzero, step_up,
    step_up_nonzero,
};

impl Neg for Interval {
    type Output = Self;
    /// `-X`, exact.
    #[inline]
    fn neg(self) -> Self {
        Self::raw(-self.hi, -self.lo)
    }
}

impl Add for Interval {
    type Output = Self;
    /// `X + Y`.
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::raw(
            step_down_nonzero(self.lo + other.lo),
            step_up_nonzero(self.hi + other.hi),
        )
    }
}

impl Sub for Interval {
    type Output = Self;
    /// `X - Y`.
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::raw(
            step_down_nonzero(self.lo - other.hi),
            step_up_nonzero(self.hi - other.lo),
        )
    }
}

impl Mul for Interval {
    type Output = Self;
    /// `X Y`.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let (p, q, r, s) = (a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi);
        let lo = smaller(smaller(p, q), smaller(r, s));
        let hi = larger(larger(p, q), larger(r, s));
        // Finite and nonzero products of bounds decide the bounds of the product; everything else is rare.
        if (lo.abs() * hi.abs() > 0.0) && (hi - lo).is_finite() && (p + q + r + s).is_finite() {
            Self::raw(step_down(lo), step_up(hi))
        } else {
            mul_special(a, b)
        }
    }
}

/// Products with a zero, an infinite or no bound, or that overflow or underflow: bound by bound.
#[inline(never)]
fn mul_special(a: Interval, b: Interval) -> Interval {
    if a.is_empty() || b.is_empty() {
        return Interval::EMPTY;
    }
    let pairs = [(a.lo, b.lo), (a.lo, b.hi), (a.hi, b.lo), (a.hi, b.hi)];
    let lo = pairs
        .map(|(x, y)| mul_down(x, y))
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    let hi = pairs
        .map(|(x, y)| mul_up(x, y))
        .into_iter()
        .fold(f64::NEG_INFINITY, f64::max);
    Interval::raw(lo, hi)
}

impl Div for Interval {
    type Output = Self;
    /// `X / Y = { x / y : y != 0 }`; empty for `Y = { 0 }`.
    #[inline]
    fn div(self, other: Self) -> Self {
        div_special(self, other)
    }
}

/// Division, all cases.
fn div_special(a: Interval, b: Interval) -> Interval {
    if a.is_empty() || b.is_empty() || (b.lo == 0.0 && b.hi == 0.0) {
        return Interval::EMPTY;
    }
    if a.lo == 0.0 && a.hi == 0.0 {
        return Interval::ZERO;
    }
    if b.lo < 0.0 && b.hi > 0.0 {
        return Interval::ENTIRE;
    }
    if b.hi <= 0.0 {
        return div_special(-a, -b);
    }
    // Here b >= 0 and b.hi > 0; b.lo = 0 makes the quotient unbounded on the side of each sign of a.
    let lo_divisor = if a.lo >= 0.0 { b.hi } else { b.lo };
    let hi_divisor = if a.hi <= 0.0 { b.hi } else { b.lo };
    let lo = if a.lo == f64::NEG_INFINITY {
        f64::NEG_INFINITY
    } else if lo_divisor == f64::INFINITY {
        0.0
    } else {
        div_down(a.lo, lo_divisor)
    };
    let hi = if a.hi == f64::INFINITY {
        f64::INFINITY
    } else if hi_divisor == f64::INFINITY {
        0.0
    } else {
        div_up(a.hi, hi_divisor)
    };
    Interval::raw(lo, hi)
}

impl Interval {
    /// `k X` for a floating-point number `k`. A NaN or infinite `k` is what [`Interval::point`] makes of it.
    #[inline]
    #[must_use]
    pub fn scale(self, k: f64) -> Self {
        self * Self::point(k)
    }

    /// `X + k` for a floating-point number `k`. A NaN or infinite `k` is what [`Interval::point`] makes of it.
    #[inline]
    #[must_use]
    pub fn add_f64(self, k: f64) -> Self {
        self + Self::point(k)
    }

    /// `{ x^2 }`: tighter than `X * X` where `X` contains zero.
    #[inline]
    #[must_use]
    pub fn sqr(self) -> Self {
        let (small, large) = (self.mig(), self.mag());
        if self.is_empty() {
            return Self::EMPTY;
        }
        Self::raw(mul_down(small, small), mul_up(large, large))
    }

    /// `{ 1 / x : x != 0 }`.
    #[inline]
    #[must_use]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// `{ sqrt(x) : x >= 0 }`; empty if all of `X` is negative.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi >= 0.0 {
            // The bound at -0 or below is the root of 0, which is exact.
            return Self::raw(
                step_down_nonzero(larger(self.lo, 0.0).sqrt()),
                step_up_nonzero(self.hi.sqrt()),
            );
        }
        Self::EMPTY
    }

    /// `{ |x| }`, exact.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        Self::raw(self.mig(), self.mag())
    }

    /// `{ min(x, y) }`, exact.
    #[inline]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if self.is_empty() || other.is_empty() {
            return Self::EMPTY;
        }
        Self::raw(smaller(self.lo, other.lo), smaller(self.hi, other.hi))
    }

    /// `{ max(x, y) }`, exact.
    #[inline]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self.is_empty() || other.is_empty() {
            return Self::EMPTY;
        }
        Self::raw(larger(self.lo, other.lo), larger(self.hi, other.hi))
    }
}

/// `x op= y` as `x = x op y`.
macro_rules! assign {
    ($($trait:ident $method:ident $op:tt),*) => {$(
        impl $trait for Interval {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $op other;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Zero for Interval {
    #[inline]
    fn zero() -> Self {
        Self::ZERO
    }
    #[inline]
    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl One for Interval {
    #[inline]
    fn one() -> Self {
        Self::ONE
    }
}
