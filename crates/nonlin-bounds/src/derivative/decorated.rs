//! [`Decorated`]: a range over a box together with what is proven about the function that has it.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use scalars::{Interval, Scalar};

use crate::Smoothness;

/// The range of a quantity over a box, and how smooth the quantity is proven to be there as a function of the variables.
///
/// Smoothness is that of the composition: the least of what the operands have and what the operation keeps on their ranges.
/// A quantity that depends on no variable (a constant, a parameter) is smooth wherever it is defined: `|p|` across zero costs
/// nothing.
///
/// **Guarantee:** the range is an enclosure as for [`Interval`]; `C1` and `C2` hold on an open neighbourhood of the box, `C0` and
/// `Defined` on the box.
///
/// ```
/// use nonlin_bounds::{Decorated, Smoothness};
/// use scalars::{Interval, Scalar};
/// let x = Decorated::variable(Interval::new(0.0, 1.0)?);
/// assert_eq!(x.exp().smoothness(), Smoothness::C2);
/// assert_eq!(x.sqrt().smoothness(), Smoothness::C0);
/// assert_eq!(x.recip().smoothness(), Smoothness::Undefined);
/// # Ok::<(), scalars::ScalarError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decorated {
    range: Interval,
    smoothness: Smoothness,
    varies: bool,
}

impl Decorated {
    /// A variable that ranges over an interval.
    #[inline]
    #[must_use]
    pub fn variable(range: Interval) -> Self {
        Self { range, smoothness: Smoothness::C2, varies: true }
    }

    /// A number, the same on the whole box, that is known to lie in an interval.
    #[inline]
    #[must_use]
    pub fn constant(range: Interval) -> Self {
        Self { range, smoothness: Smoothness::C2, varies: false }
    }

    /// The range.
    #[inline]
    #[must_use]
    pub fn range(&self) -> Interval {
        self.range
    }

    /// What is proven on the whole box.
    #[inline]
    #[must_use]
    pub fn smoothness(&self) -> Smoothness {
        self.smoothness
    }

    /// A constant of the program text: a number only if its range is bounded and not empty.
    fn literal(range: Interval) -> Self {
        Self { range, smoothness: if_smooth(range.is_bounded()), varies: false }
    }

    /// The same quantity with at most `limit` proven; of what does not vary, only whether it is defined matters.
    #[inline]
    fn limited(mut self, limit: Smoothness) -> Self {
        if self.varies || limit == Smoothness::Undefined {
            self.smoothness = self.smoothness.min(limit);
        }
        self
    }

    /// `f(self)` with range `range`, for an `f` that keeps everything.
    #[inline]
    fn map(self, range: Interval) -> Self {
        Self { range, ..self }
    }

    /// The same for two operands.
    #[inline]
    fn join(self, other: Self, range: Interval) -> Self {
        Self { range, smoothness: self.smoothness.min(other.smoothness), varies: self.varies || other.varies }
    }
}

impl From<Decorated> for Interval {
    #[inline]
    fn from(x: Decorated) -> Self {
        x.range
    }
}

/// `C2` if `smooth`, else `Undefined`.
#[inline]
fn if_smooth(smooth: bool) -> Smoothness {
    if smooth { Smoothness::C2 } else { Smoothness::Undefined }
}

/// `C2` if `smooth`, else `C0` if at least `defined`, else `Undefined`.
#[inline]
fn if_smooth_or_defined(smooth: bool, defined: bool) -> Smoothness {
    if smooth { Smoothness::C2 } else { if_smooth(defined).min(Smoothness::C0) }
}

/// True if zero is not a member: the division by this range is defined.
#[inline]
fn nonzero(x: Interval) -> bool {
    x.lo() > 0.0 || x.hi() < 0.0
}

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $op:tt),*) => {$(
        impl $trait for Decorated {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.join(other, self.range $op other.range)
            }
        }
        impl $assign for Decorated {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = *self $op other;
            }
        }
    )*};
}
operators!(Add add AddAssign add_assign +, Sub sub SubAssign sub_assign -, Mul mul MulAssign mul_assign *);

impl Div for Decorated {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        self.join(other, self.range / other.range).limited(if_smooth(nonzero(other.range)))
    }
}

impl DivAssign for Decorated {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl Neg for Decorated {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(-self.range)
    }
}

impl Zero for Decorated {
    #[inline]
    fn zero() -> Self {
        Self::constant(Interval::ZERO)
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.range.is_zero()
    }
}

impl One for Decorated {
    #[inline]
    fn one() -> Self {
        Self::constant(Interval::ONE)
    }
}

/// Functions that are smooth everywhere.
macro_rules! smooth {
    ($($method:ident),*) => {$(
        #[inline]
        fn $method(self) -> Self {
            self.map(self.range.$method())
        }
    )*};
}

impl Scalar for Decorated {
    fn from_f64(x: f64) -> Self {
        Self::literal(Interval::from_f64(x))
    }
    fn lit(lo: f64, hi: f64) -> Self {
        Self::literal(Interval::new(lo, hi).unwrap_or(Interval::ENTIRE))
    }
    fn ratio(p: i64, q: i64) -> Self {
        Self::literal(Interval::ratio(p, q))
    }
    fn decimal(text: &str) -> Self {
        Self::literal(Interval::decimal(text))
    }
    fn pi() -> Self {
        Self::constant(Interval::PI)
    }
    #[inline]
    fn scale(self, k: f64) -> Self {
        self.map(self.range.scale(k)).limited(if_smooth(k.is_finite()))
    }
    #[inline]
    fn add_f64(self, k: f64) -> Self {
        self.map(self.range.add_f64(k)).limited(if_smooth(k.is_finite()))
    }
    smooth!(sqr, exp, sin, cos, atan, sinh, cosh, tanh);
    fn recip(self) -> Self {
        self.map(self.range.recip()).limited(if_smooth(nonzero(self.range)))
    }
    fn sqrt(self) -> Self {
        let lo = self.range.lo();
        self.map(self.range.sqrt()).limited(if_smooth_or_defined(lo > 0.0, lo >= 0.0))
    }
    fn powi(self, n: i32) -> Self {
        self.map(self.range.powi(n)).limited(if_smooth(n >= 0 || nonzero(self.range)))
    }
    fn ln(self) -> Self {
        self.map(self.range.ln()).limited(if_smooth(self.range.lo() > 0.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.range.sin_cos();
        (self.map(sin), self.map(cos))
    }
    fn tan(self) -> Self {
        // The range is bounded exactly if no pole is met.
        let range = self.range.tan();
        self.map(range).limited(if_smooth(range.is_bounded()))
    }
    fn asin(self) -> Self {
        let (lo, hi) = (self.range.lo(), self.range.hi());
        self.map(self.range.asin()).limited(if_smooth_or_defined(lo > -1.0 && hi < 1.0, lo >= -1.0 && hi <= 1.0))
    }
    fn acos(self) -> Self {
        let (lo, hi) = (self.range.lo(), self.range.hi());
        self.map(self.range.acos()).limited(if_smooth_or_defined(lo > -1.0 && hi < 1.0, lo >= -1.0 && hi <= 1.0))
    }
    fn atan2(self, x: Self) -> Self {
        let (y, right) = (self.range, x.range);
        let limit = if nonzero(y) || right.lo() > 0.0 {
            Smoothness::C2
        } else if !nonzero(right) {
            // The origin may be met.
            Smoothness::Undefined
        } else if y.lo() >= 0.0 {
            // The cut from above: continuous there, not below it.
            Smoothness::C0
        } else {
            Smoothness::Defined
        };
        self.join(x, y.atan2(right)).limited(limit)
    }
    fn abs(self) -> Self {
        self.map(self.range.abs()).limited(if_smooth_or_defined(nonzero(self.range), true))
    }
    fn sign(self) -> Self {
        let limit = if nonzero(self.range) { Smoothness::C2 } else { Smoothness::Defined };
        self.map(self.range.sign()).limited(limit)
    }
    fn min(self, other: Self) -> Self {
        self.join(other, self.range.min(other.range))
            .limited(if_smooth_or_defined(self.range.disjoint(&other.range), true))
    }
    fn max(self, other: Self) -> Self {
        self.join(other, self.range.max(other.range))
            .limited(if_smooth_or_defined(self.range.disjoint(&other.range), true))
    }
    fn stumpff(self, k: usize) -> Self {
        self.map(self.range.stumpff(k)).limited(if_smooth(k <= 20))
    }
}
