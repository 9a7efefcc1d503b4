//! Exact numbers `m 2^e`: floats, their sums, products and powers without any rounding.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use scalars::Interval;

/// `mantissa 2^exponent`.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    pub fn new(mantissa: BigInt, exponent: i64) -> Self {
        Self { mantissa, exponent }
    }

    /// A finite float, exactly.
    pub fn from_float(x: f64) -> Self {
        assert!(x.is_finite());
        let bits = x.to_bits();
        let biased = ((bits >> 52) & 0x7FF) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let mantissa = if biased == 0 { fraction } else { fraction | 1 << 52 };
        let mantissa = if x.is_sign_negative() { -mantissa } else { mantissa };
        Self { mantissa: mantissa.into(), exponent: biased.max(1) - 1075 }
    }

    pub fn add(&self, other: &Self) -> Self {
        let exponent = self.exponent.min(other.exponent);
        let at = |x: &Self| &x.mantissa << (x.exponent - exponent) as usize;
        Self { mantissa: at(self) + at(other), exponent }
    }

    pub fn mul(&self, other: &Self) -> Self {
        Self { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }

    pub fn pow(&self, n: u32) -> Self {
        Self { mantissa: self.mantissa.pow(n), exponent: self.exponent * i64::from(n) }
    }

    pub fn neg(&self) -> Self {
        Self { mantissa: -&self.mantissa, exponent: self.exponent }
    }

    pub fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    pub fn compare(&self, other: &Self) -> Ordering {
        // Signs and magnitudes decide most cases without long shifts.
        let (a, b) = (self.sign(), other.sign());
        if a != b || a == Ordering::Equal {
            return a.cmp(&b);
        }
        let magnitude = |x: &Self| x.mantissa.bits() as i64 + x.exponent;
        let (p, q) = (magnitude(self), magnitude(other));
        if p != q {
            return if a == Ordering::Greater { p.cmp(&q) } else { q.cmp(&p) };
        }
        let exponent = self.exponent.min(other.exponent);
        let at = |x: &Self| &x.mantissa << (x.exponent - exponent) as usize;
        at(self).cmp(&at(other))
    }
}

/// The float bound (possibly infinite) is at or below `num / den`.
pub fn at_most(bound: f64, num: &Dyadic, den: &Dyadic) -> bool {
    if !bound.is_finite() {
        return bound < 0.0;
    }
    let (num, den) = if den.sign() == Ordering::Less { (num.neg(), den.neg()) } else { (num.clone(), den.clone()) };
    Dyadic::from_float(bound).mul(&den).compare(&num) != Ordering::Greater
}

/// `num / den` lies in the interval.
pub fn contains_ratio(x: Interval, num: &Dyadic, den: &Dyadic) -> bool {
    at_most(x.lo(), num, den) && at_most(-x.hi(), &num.neg(), den)
}

/// The float bound (possibly infinite) is at or below the exact number.
pub fn at_or_below(bound: f64, value: &Dyadic) -> bool {
    if bound.is_finite() { Dyadic::from_float(bound).compare(value).is_le() } else { bound < 0.0 }
}

/// The exact number lies in the interval.
pub fn contains(x: Interval, value: &Dyadic) -> bool {
    at_or_below(x.lo(), value) && at_or_below(-x.hi(), &value.neg())
}
