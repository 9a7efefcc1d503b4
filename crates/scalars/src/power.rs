//! Integer powers `x^n`, within a few units in the last place for every `n`.
//!
//! Powers of a bound are computed by repeated squaring of an unevaluated sum of two floating-point numbers times a power of
//! two. One product of such sums has a relative error of at most `5 u^2` (Joldes, Muller, Popescu, *Tight and rigorous error
//! bounds for basic building blocks of double-word arithmetic*, ACM TOMS 44, 2017), so `x^n` is off by less than
//! `5 |n| u^2 < 2^-70`, far less than the step outward that follows.

use crate::Interval;
use crate::rounding::{step_down, step_up};

impl Interval {
    /// `{ x^n : x in X, x != 0 if n < 0 }`; `x^0 = 1` for every `x`.
    ///
    /// **Guarantee:** superset; for each bound at most 4 units in the last place from the tightest.
    ///
    /// ```
    /// use scalars::Interval;
    /// let x = Interval::new(-2.0, 3.0)?;
    /// assert!(x.powi(2).lo() == 0.0 && x.powi(3).contains(-8.0));
    /// assert_eq!(x.powi(-1), Interval::ENTIRE);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        if self.is_empty() {
            return self;
        }
        match n {
            0 => Self::ONE,
            1 => self,
            2 => self.sqr(),
            -1 => self.recip(),
            _ if n % 2 == 0 => self.abs().monotone_power(n),
            _ if self.lo >= 0.0 => self.monotone_power(n),
            _ if self.hi <= 0.0 => -(-self).monotone_power(n),
            _ if n < 0 => Self::ENTIRE,
            _ => Self::raw(-bounds(-self.lo, n).1, bounds(self.hi, n).1),
        }
    }

    /// `x^n` for a nonempty interval of numbers `x >= 0`.
    fn monotone_power(self, n: i32) -> Self {
        if n > 0 {
            Self::raw(bounds(self.lo, n).0, bounds(self.hi, n).1)
        } else if self.hi == 0.0 {
            Self::EMPTY
        } else {
            Self::raw(bounds(self.hi, n).0, bounds(self.lo, n).1)
        }
    }
}

/// Lower and upper bound of `x^n` for `x >= 0`; `0` and `inf` go to their limits.
fn bounds(x: f64, n: i32) -> (f64, f64) {
    if x == 0.0 || x == f64::INFINITY {
        let limit = if (x == 0.0) == (n > 0) { 0.0 } else { f64::INFINITY };
        return (limit, limit);
    }
    let power = DoubleWord::new(x).power(n.unsigned_abs());
    let power = if n < 0 { power.recip() } else { power };
    power.bounds()
}

/// The positive number `(hi + lo) 2^exponent`, `hi` in `(1/2, 2)`, `|lo| <= ulp(hi)/2`.
#[derive(Clone, Copy)]
struct DoubleWord {
    hi: f64,
    lo: f64,
    exponent: i64,
}

impl DoubleWord {
    /// A positive finite number, exactly.
    fn new(x: f64) -> Self {
        const FRACTION: u64 = (1 << 52) - 1;
        let (x, shift) = if x < f64::MIN_POSITIVE { (x * 2f64.powi(54), -54) } else { (x, 0) };
        let biased = (x.to_bits() >> 52) as i64;
        Self {
            hi: f64::from_bits((x.to_bits() & FRACTION) | 1.0_f64.to_bits()),
            lo: 0.0,
            exponent: biased - 1023 + shift,
        }
    }

    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.hi, other.hi);
        let error = error + (self.hi * other.lo + self.lo * other.hi);
        let hi = product + error;
        let lo = error - (hi - product);
        let exponent = self.exponent + other.exponent;
        if hi >= 2.0 { Self { hi: 0.5 * hi, lo: 0.5 * lo, exponent: exponent + 1 } } else { Self { hi, lo, exponent } }
    }

    /// `self^n`, `n >= 1`.
    fn power(self, n: u32) -> Self {
        // From the second-highest bit of n down: square, and multiply where the bit is set.
        (0..n.ilog2()).rev().fold(self, |power, bit| {
            let square = power.mul(power);
            if n >> bit & 1 == 1 { square.mul(self) } else { square }
        })
    }

    /// `1 / self`: one Newton step from the quotient of the leading words, relative error below `8 u^2`.
    fn recip(self) -> Self {
        let quotient = 1.0 / self.hi;
        let (product, error) = two_product(quotient, self.hi);
        let residual = (1.0 - product) - error - quotient * self.lo;
        let correction = quotient * residual;
        let hi = quotient + correction;
        Self { hi, lo: correction - (hi - quotient), exponent: -self.exponent }
    }

    /// Bounds of the number: `hi` is off by half a unit in the last place and the accumulated `2^-70`.
    fn bounds(self) -> (f64, f64) {
        let e = self.exponent;
        if e > 1030 {
            (f64::MAX, f64::INFINITY)
        } else if e < -1100 {
            (0.0, f64::from_bits(1))
        } else {
            let x = times_power_of_two(self.hi, e);
            if e.abs() < 1000 {
                return (step_down(x), step_up(x));
            }
            // The last product may round (underflow) or overflow: one more step.
            (step_down(step_down(x)).max(0.0), step_up(step_up(x)))
        }
    }
}

/// `x 2^e` to nearest, for `x` in `[1/2, 2^128)`: exact unless it overflows or is subnormal.
pub(crate) fn times_power_of_two(x: f64, e: i64) -> f64 {
    // Two factors within the normal numbers; only the second product can round, or the result is zero.
    let e = e.clamp(-2044, 2046);
    let power = |e: i64| f64::from_bits(((1023 + e) as u64) << 52);
    x * power(e / 2) * power(e - e / 2)
}

/// `a b = product + error`, exactly, for numbers in `(1/4, 4)` (Dekker's product).
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let t = 134_217_729.0 * x; // 2^27 + 1
        let high = t - (t - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    (product, a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2))
}
