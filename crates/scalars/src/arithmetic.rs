//! `+ - * /`, squares and roots of intervals, rounded outward.
//!
//! Bounds are computed to nearest and stepped outward ([`rounding`](crate::rounding)). Bounded operands take a path of
//! straight-line code; the rest of IEEE 1788 (empty, unbounded, division by an interval with zero) is in cold functions.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Interval;
use crate::rounding::{ETA, PHI, larger, outward, smaller, step_down, step_down_nonzero, step_up, step_up_nonzero};

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
        Self::raw(step_down_nonzero(self.lo + other.lo), step_up_nonzero(self.hi + other.hi))
    }
}

impl Sub for Interval {
    type Output = Self;
    /// `X - Y`.
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::raw(step_down_nonzero(self.lo - other.hi), step_up_nonzero(self.hi - other.lo))
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
        let sum = (p + q) + (r + s);
        // True if all products are finite (else 0 sum is NaN) and both bounds are nonzero, short of an underflow.
        if (lo * hi + 0.0 * sum).abs() > 0.0 {
            Self::raw(lo - outward(lo), hi + outward(hi))
        } else {
            mul_special(a, b)
        }
    }
}

/// Products with a zero bound, overflow, underflow, an empty or an unbounded operand.
#[inline(never)]
fn mul_special(a: Interval, b: Interval) -> Interval {
    if a.is_empty() || b.is_empty() {
        return Interval::EMPTY;
    }
    if a.is_zero() || b.is_zero() {
        return Interval::ZERO;
    }
    let lo = |x: f64, y: f64| product_down(x, y);
    let hi = |x: f64, y: f64| -product_down(-x, y);
    Interval::raw(
        smaller(smaller(lo(a.lo, b.lo), lo(a.lo, b.hi)), smaller(lo(a.hi, b.lo), lo(a.hi, b.hi))),
        larger(larger(hi(a.lo, b.lo), hi(a.lo, b.hi)), larger(hi(a.hi, b.lo), hi(a.hi, b.hi))),
    )
}

/// Lower bound of a product of bounds: `0 inf = 0`, and an underflow keeps the sign of the product.
fn product_down(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 {
        return 0.0;
    }
    let c = x * y;
    if c == 0.0 && c.is_sign_positive() { 0.0 } else { step_down(c) }
}

impl Div for Interval {
    type Output = Self;
    /// `X / Y = { x / y : y != 0 }`; empty for `Y = { 0 }`.
    #[inline]
    fn div(self, other: Self) -> Self {
        let (a, b) = if other.hi < 0.0 { (-self, -other) } else { (self, other) };
        // An empty or unbounded numerator needs no care: NaN and the right infinity pass.
        if b.lo > 0.0 && b.hi < f64::INFINITY { div_positive(a, b) } else { div_special(a, b) }
    }
}

/// `a / b` for `0 < b < inf`. The sign of a numerator is that of the quotient, also where this underflows.
#[inline(always)]
fn div_positive(a: Interval, b: Interval) -> Interval {
    let (lo_divisor, floor) = if a.lo >= 0.0 { (b.hi, 0.0) } else { (b.lo, f64::NEG_INFINITY) };
    let (hi_divisor, ceiling) = if a.hi <= 0.0 { (b.hi, 0.0) } else { (b.lo, f64::INFINITY) };
    Interval::raw(larger(floor, step_down(a.lo / lo_divisor)), smaller(ceiling, step_up(a.hi / hi_divisor)))
}

/// `a / b` for `b` empty, zero, with zero as inner point or lower bound, or unbounded above.
#[inline(never)]
fn div_special(a: Interval, b: Interval) -> Interval {
    if a.is_empty() || b.is_empty() || b.is_zero() {
        return Interval::EMPTY;
    }
    if a.is_zero() {
        return Interval::ZERO;
    }
    if b.lo < 0.0 {
        // Of negative divisors only those with zero inside or at the upper end come here.
        return if b.hi == 0.0 { div_special(-a, -b) } else { Interval::ENTIRE };
    }
    Interval::raw(quotient_down(a.lo, b), -quotient_down(-a.hi, b))
}

/// Lower bound of `{ x / y : y in b, y > 0 }` for `b >= 0`, where `b` touches zero or is unbounded.
fn quotient_down(x: f64, b: Interval) -> f64 {
    // The infimum is at the largest divisor for x >= 0, at the smallest for x < 0.
    let divisor = if x >= 0.0 { b.hi } else { b.lo };
    if divisor == 0.0 {
        f64::NEG_INFINITY
    } else if x >= 0.0 {
        larger(0.0, step_down(x / divisor))
    } else {
        step_down(x / divisor)
    }
}

impl Interval {
    /// `k X` for a floating-point number `k`. A NaN or infinite `k` is what [`Interval::point`] makes of it.
    #[inline]
    #[must_use]
    pub fn scale(self, k: f64) -> Self {
        let (p, q) = (k * self.lo, k * self.hi);
        // The empty set passes as NaN; a zero may be an underflow.
        if p != 0.0 && q != 0.0 && k != 0.0 && k.is_finite() {
            return Self::raw(step_down(smaller(p, q)), step_up(larger(p, q)));
        }
        mul_special(self, Self::point(k))
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
        // A lower bound that underflows is zero; the upper one is zero for { 0 } only.
        let hi = large * large;
        Self::raw(step_down_nonzero(small * small), hi + (hi * PHI + smaller(ETA, large)))
    }

    /// `{ 1 / x : x != 0 }`.
    #[inline]
    #[must_use]
    pub fn recip(self) -> Self {
        if self.lo > 0.0 || self.hi < 0.0 {
            // 1 / x underflows for infinite x only, where zero is exact.
            return Self::raw(step_down_nonzero(1.0 / self.hi), step_up_nonzero(1.0 / self.lo));
        }
        Self::ONE / self
    }

    /// `{ sqrt(x) : x >= 0 }`; empty if all of `X` is negative.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi >= 0.0 {
            // The bound at -0 or below is the root of 0, which is exact.
            return Self::raw(step_down_nonzero(larger(self.lo, 0.0).sqrt()), step_up_nonzero(self.hi.sqrt()));
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
