//! [`Interval`]: a closed set of real numbers between two floating-point bounds.

use crate::ScalarError;
use crate::rounding::{self, larger, smaller};

/// A closed interval of real numbers with floating-point bounds; the empty set and unbounded intervals are values.
///
/// `[a, b] = { x real : a <= x <= b }`, where `a` may be `-inf` and `b` may be `+inf` (which are not members).
///
/// **Guarantee:** every operation returns a superset of `{ f(x, ..) : x in X, .. and f defined there }`, rounding included.
/// Equality is equality of sets.
///
/// Representation: either `lo <= hi`, `lo < inf`, `hi > -inf`, or both bounds are NaN, which is the empty set. NaN is the
/// value that sums, differences and products of bounds pass on, so that the empty set needs no branch in `+` and `-`:
/// bounds of nonempty operands never meet as `inf - inf`.
///
/// **Source:** IEEE Std 1788-2015, set-based flavour, bare intervals.
///
/// ```
/// use scalars::Interval;
/// let x = Interval::new(1.0, 2.0)?;
/// let y = x * x - x;
/// assert!(y.contains(0.0) && y.contains(2.0) && !y.contains(4.0));
/// # Ok::<(), scalars::ScalarError>(())
/// ```
#[derive(Clone, Copy)]
pub struct Interval {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
}

impl Interval {
    /// The empty set.
    pub const EMPTY: Self = Self {
        lo: f64::NAN,
        hi: f64::NAN,
    };
    /// The whole real line.
    pub const ENTIRE: Self = Self {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
    };
    /// `{ 0 }`.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };
    /// `{ 1 }`.
    pub const ONE: Self = Self { lo: 1.0, hi: 1.0 };
    /// `pi`, between two neighbouring floating-point numbers.
    pub const PI: Self = Self {
        lo: std::f64::consts::PI,
        hi: std::f64::consts::PI.next_up(),
    };
    /// `pi / 2`, between two neighbouring floating-point numbers.
    pub const FRAC_PI_2: Self = Self {
        lo: std::f64::consts::FRAC_PI_2,
        hi: std::f64::consts::FRAC_PI_2.next_up(),
    };

    /// `[lo, hi]`; `lo = -inf` and `hi = inf` are allowed.
    ///
    /// # Errors
    /// [`ScalarError::InvalidBounds`] unless `lo <= hi`, `lo < inf`, `hi > -inf` (NaN fails).
    #[inline]
    pub fn new(lo: f64, hi: f64) -> Result<Self, ScalarError> {
        if lo <= hi && lo < f64::INFINITY && hi > f64::NEG_INFINITY {
            Ok(Self { lo, hi })
        } else {
            Err(ScalarError::InvalidBounds { lo, hi })
        }
    }

    /// `{ x }`. An infinite `x` stands for the numbers that overflow to it: `[MAX, inf]` or `[-inf, -MAX]`; NaN is any
    /// number: the whole line.
    #[inline]
    #[must_use]
    pub fn point(x: f64) -> Self {
        if x.is_finite() {
            return Self { lo: x, hi: x };
        }
        if x.is_nan() {
            Self::ENTIRE
        } else {
            Self {
                lo: x.min(f64::MAX),
                hi: x.max(f64::MIN),
            }
        }
    }

    /// Bounds that a computation produced: `[lo, hi]` if they enclose something, else the empty set.
    #[inline(always)]
    pub(crate) fn raw(lo: f64, hi: f64) -> Self {
        Self { lo, hi }
    }

    /// Lower bound; NaN for the empty set.
    #[inline]
    #[must_use]
    pub const fn lo(&self) -> f64 {
        self.lo
    }

    /// Upper bound; NaN for the empty set.
    #[inline]
    #[must_use]
    pub const fn hi(&self) -> f64 {
        self.hi
    }

    /// True for the empty set.
    #[inline]
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.lo.is_nan()
    }

    /// True if nonempty with two finite bounds.
    #[inline]
    #[must_use]
    pub const fn is_bounded(&self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// A member close to the midpoint: finite for every nonempty interval, without overflow; NaN for the empty set.
    ///
    /// Half-lines give the largest finite number on their side, the whole line gives 0.
    #[inline]
    #[must_use]
    pub fn mid(&self) -> f64 {
        let mid = 0.5 * self.lo + 0.5 * self.hi;
        if mid.is_finite() {
            // Halving subnormal bounds may round out of the interval by one step.
            return smaller(self.hi, larger(self.lo, mid));
        }
        if self.is_empty() {
            f64::NAN
        } else if self.lo == f64::NEG_INFINITY && self.hi == f64::INFINITY {
            0.0
        } else if self.lo == f64::NEG_INFINITY {
            f64::MIN
        } else {
            f64::MAX
        }
    }

    /// Upper bound of the distance of a member from [`mid`](Self::mid): `rad >= max(hi - mid, mid - lo)`; NaN for the empty set.
    #[inline]
    #[must_use]
    pub fn rad(&self) -> f64 {
        if self.is_empty() {
            return f64::NAN;
        }
        let mid = self.mid();
        rounding::sub_up(self.hi, mid).max(rounding::sub_up(mid, self.lo))
    }

    /// Upper bound of `hi - lo`; NaN for the empty set.
    #[inline]
    #[must_use]
    pub fn width(&self) -> f64 {
        if self.is_empty() {
            f64::NAN
        } else {
            rounding::sub_up(self.hi, self.lo)
        }
    }

    /// Magnitude `max { |x| : x in X }`, exact; NaN for the empty set.
    #[inline]
    #[must_use]
    pub fn mag(&self) -> f64 {
        larger(self.lo.abs(), self.hi.abs())
    }

    /// Mignitude `min { |x| : x in X }`, exact; NaN for the empty set.
    #[inline]
    #[must_use]
    pub fn mig(&self) -> f64 {
        // larger(a, b) passes the NaN of b on: the empty set needs no branch.
        larger(-self.hi, larger(0.0, self.lo))
    }
}

impl Default for Interval {
    /// `{ 0 }`, the neutral element of addition.
    fn default() -> Self {
        Self::ZERO
    }
}

impl PartialEq for Interval {
    /// Equality of sets: the empty set equals itself, and `-0` equals `0`.
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        (self.lo == other.lo && self.hi == other.hi) || (self.is_empty() && other.is_empty())
    }
}

impl std::fmt::Debug for Interval {
    /// The two bounds in shortest round-trip form.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.is_empty() {
            write!(f, "[empty]")
        } else {
            write!(f, "[{:?}, {:?}]", self.lo, self.hi)
        }
    }
}
