//! [`Interval`]: a closed set of real numbers between two floating-point bounds.

use crate::ScalarError;
use crate::rounding::{larger, sub_up_tight};

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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "crate::serialization::Bounds", try_from = "crate::serialization::Bounds"))]
pub struct Interval {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
}

impl Interval {
    /// The empty set.
    pub const EMPTY: Self = Self { lo: f64::NAN, hi: f64::NAN };
    /// The whole real line.
    pub const ENTIRE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// `{ 0 }`.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };
    /// `{ 1 }`.
    pub const ONE: Self = Self { lo: 1.0, hi: 1.0 };
    /// `pi`, between two neighbouring floating-point numbers.
    pub const PI: Self = Self { lo: std::f64::consts::PI, hi: std::f64::consts::PI.next_up() };
    /// `pi / 2`, between two neighbouring floating-point numbers.
    pub const FRAC_PI_2: Self = Self { lo: std::f64::consts::FRAC_PI_2, hi: std::f64::consts::FRAC_PI_2.next_up() };

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
        if x.is_nan() { Self::ENTIRE } else { Self { lo: x.min(f64::MAX), hi: x.max(f64::MIN) } }
    }

    /// Bounds that a computation produced and that fulfil the representation.
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

    /// The midpoint rounded to nearest, a member of every nonempty interval; NaN for the empty set. It never overflows.
    ///
    /// Half-lines give the largest finite number on their side, the whole line gives 0.
    #[inline]
    #[must_use]
    pub fn mid(&self) -> f64 {
        let sum = self.lo + self.hi;
        if sum.is_finite() {
            return 0.5 * sum;
        }
        if self.is_bounded() {
            return 0.5 * self.lo + 0.5 * self.hi;
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

    /// `max(hi - mid, mid - lo)` rounded up: `mid +- rad` contains the interval. NaN for the empty set.
    #[inline]
    #[must_use]
    pub fn rad(&self) -> f64 {
        if self.is_empty() {
            return f64::NAN;
        }
        let mid = self.mid();
        larger(sub_up_tight(self.hi, mid), sub_up_tight(mid, self.lo))
    }

    /// `hi - lo` rounded up; NaN for the empty set.
    #[inline]
    #[must_use]
    pub fn width(&self) -> f64 {
        if self.is_empty() { f64::NAN } else { sub_up_tight(self.hi, self.lo) }
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
        if self.is_empty() { write!(f, "[empty]") } else { write!(f, "[{:?}, {:?}]", self.lo, self.hi) }
    }
}
