//! [`Scalar`]: the numbers a model is written in.

use std::fmt::Debug;
use std::ops::{AddAssign, Div, DivAssign, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Interval;

/// A number type that a model can be evaluated over: `f64` for simulation, [`Interval`] for ranges.
///
/// There is no order and no conversion to `f64`: a model must not branch on values, so that one evaluation over
/// intervals covers every member. `zero()` and `one()` come from `num_traits`.
///
/// **Guarantee:** over [`Interval`] every method encloses the exact image; over `f64` methods round and promise nothing.
pub trait Scalar:
    Copy
    + PartialEq
    + Debug
    + 'static
    + Zero
    + One
    + Neg<Output = Self>
    + Sub<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// The number `x`.
    fn from_f64(x: f64) -> Self;
    /// A constant known to lie in `[lo, hi]`; over `f64` a number between the two.
    fn lit(lo: f64, hi: f64) -> Self;
    /// The rational number `p / q`; `q = 0` gives the whole line (NaN over `f64`).
    fn ratio(p: i64, q: i64) -> Self;
    /// The number a decimal literal names, as `"0.1"`; malformed text gives the whole line (NaN over `f64`).
    fn decimal(text: &str) -> Self;
    /// The number pi.
    fn pi() -> Self;
    /// `k x`.
    fn scale(self, k: f64) -> Self;
    /// `x + k`.
    fn add_f64(self, k: f64) -> Self;
    /// `x^2`.
    fn sqr(self) -> Self;
    /// `1 / x`.
    fn recip(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// `x^n`.
    fn powi(self, n: i32) -> Self;
    /// `e^x`.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Sine.
    fn sin(self) -> Self;
    /// Cosine.
    fn cos(self) -> Self;
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// Tangent.
    fn tan(self) -> Self;
    /// Inverse sine.
    fn asin(self) -> Self;
    /// Inverse cosine.
    fn acos(self) -> Self;
    /// Inverse tangent.
    fn atan(self) -> Self;
    /// Angle of the point `(x, self)` in `(-pi, pi]`.
    fn atan2(self, x: Self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// `|x|`.
    fn abs(self) -> Self;
    /// The sign of `x`, the slope of `|x|`; over intervals `[-1, 1]` if zero is a member (Clarke's generalised derivative).
    fn sign(self) -> Self {
        self / self.abs()
    }
    /// The smaller of two.
    fn min(self, other: Self) -> Self;
    /// The larger of two.
    fn max(self, other: Self) -> Self;
    /// Stumpff function `C_k(s) = sum_j (-s)^j / (2j + k)!` of `s = theta^2`, `k <= 20`, smooth across zero; beyond, the whole
    /// line (NaN over `f64`). See [`Interval::stumpff`].
    fn stumpff(self, k: usize) -> Self;
}

/// Methods of the trait that are methods of the type.
macro_rules! forward {
    ($type:ty: $($method:ident($($arg:ident: $arg_type:ty),*) -> $ret:ty),* $(,)?) => {$(
        #[inline]
        fn $method(self, $($arg: $arg_type),*) -> $ret {
            <$type>::$method(self, $($arg),*)
        }
    )*};
}

impl Scalar for Interval {
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::point(x)
    }
    #[inline]
    fn lit(lo: f64, hi: f64) -> Self {
        Self::new(lo, hi).unwrap_or(Self::ENTIRE)
    }
    #[inline]
    fn ratio(p: i64, q: i64) -> Self {
        Self::ratio(p, q)
    }
    #[inline]
    fn decimal(text: &str) -> Self {
        Self::decimal(text)
    }
    #[inline]
    fn pi() -> Self {
        Self::PI
    }
    #[inline]
    fn sign(self) -> Self {
        if self.lo() > 0.0 {
            Self::ONE
        } else if self.hi() < 0.0 {
            -Self::ONE
        } else if self.is_empty() {
            self
        } else {
            Self::raw(-1.0, 1.0)
        }
    }
    forward! { Self:
        scale(k: f64) -> Self, add_f64(k: f64) -> Self, sqr() -> Self, recip() -> Self, sqrt() -> Self,
        powi(n: i32) -> Self, exp() -> Self, ln() -> Self, sin() -> Self, cos() -> Self, sin_cos() -> (Self, Self),
        tan() -> Self, asin() -> Self, acos() -> Self, atan() -> Self, atan2(x: Self) -> Self, sinh() -> Self,
        cosh() -> Self, tanh() -> Self, abs() -> Self, min(other: Self) -> Self, max(other: Self) -> Self,
        stumpff(k: usize) -> Self,
    }
}

impl Scalar for f64 {
    #[inline]
    fn from_f64(x: f64) -> Self {
        x
    }
    #[inline]
    fn lit(lo: f64, hi: f64) -> Self {
        0.5 * lo + 0.5 * hi
    }
    #[inline]
    fn ratio(p: i64, q: i64) -> Self {
        if q == 0 { f64::NAN } else { p as f64 / q as f64 }
    }
    #[inline]
    fn decimal(text: &str) -> Self {
        text.trim().parse().unwrap_or(f64::NAN)
    }
    #[inline]
    fn pi() -> Self {
        std::f64::consts::PI
    }
    #[inline]
    fn scale(self, k: f64) -> Self {
        k * self
    }
    #[inline]
    fn add_f64(self, k: f64) -> Self {
        self + k
    }
    #[inline]
    fn sqr(self) -> Self {
        self * self
    }
    #[inline]
    fn sign(self) -> Self {
        if self == 0.0 { 0.0 } else { self.signum() }
    }
    #[inline]
    fn stumpff(self, k: usize) -> Self {
        crate::stumpff::stumpff_at(self, k)
    }
    forward! { f64:
        recip() -> Self, sqrt() -> Self, powi(n: i32) -> Self, exp() -> Self, ln() -> Self, sin() -> Self,
        cos() -> Self, sin_cos() -> (Self, Self), tan() -> Self, asin() -> Self, acos() -> Self, atan() -> Self,
        atan2(x: Self) -> Self, sinh() -> Self, cosh() -> Self, tanh() -> Self, abs() -> Self,
        min(other: Self) -> Self, max(other: Self) -> Self,
    }
}
