//! Exact arithmetic on dyadic rationals `m 2^e`: every finite `f64` is one, and sums and products stay so.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

/// The number `mantissa * 2^exponent`.
#[derive(Debug, Clone)]
pub(crate) struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    pub(crate) fn zero() -> Self {
        Self { mantissa: BigInt::ZERO, exponent: 0 }
    }

    /// The exact value of a finite number.
    pub(crate) fn from(x: f64) -> Self {
        assert!(x.is_finite(), "{x} is no dyadic number");
        let bits = x.to_bits();
        let (biased, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
        let (magnitude, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
        let magnitude = magnitude as i64;
        Self { mantissa: BigInt::from(if x < 0.0 { -magnitude } else { magnitude }), exponent }
    }

    pub(crate) fn abs(self) -> Self {
        if self.mantissa.sign() == Sign::Minus { -self } else { self }
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.mantissa.sign() == Sign::NoSign
    }

    pub(crate) fn sign(&self) -> Ordering {
        self.mantissa.sign().cmp(&Sign::NoSign)
    }

    /// The quotient rounded to 60 bits or so, as a float; zero for a zero divisor.
    pub(crate) fn ratio(&self, divisor: &Self) -> f64 {
        if divisor.is_zero() || self.is_zero() {
            return 0.0;
        }
        let shift = (divisor.mantissa.bits() as i64 + 62 - self.mantissa.bits() as i64).max(0);
        let quotient = (self.mantissa.clone() << shift) / &divisor.mantissa;
        to_f64(&quotient) * 2f64.powi((self.exponent - divisor.exponent - shift).clamp(-1100, 1000) as i32)
    }

    /// An approximation.
    pub(crate) fn approx(&self) -> f64 {
        self.ratio(&Self::from(1.0))
    }

    /// Both mantissas over the common exponent.
    fn aligned(&self, other: &Self) -> (BigInt, BigInt, i64) {
        match self.exponent.cmp(&other.exponent) {
            Ordering::Equal => (self.mantissa.clone(), other.mantissa.clone(), self.exponent),
            Ordering::Greater => {
                (&self.mantissa << (self.exponent - other.exponent), other.mantissa.clone(), other.exponent)
            }
            Ordering::Less => {
                (self.mantissa.clone(), &other.mantissa << (other.exponent - self.exponent), self.exponent)
            }
        }
    }
}

fn to_f64(x: &BigInt) -> f64 {
    let (sign, digits) = x.to_u64_digits();
    let magnitude = digits.iter().rev().fold(0.0, |value, &digit| value * 2f64.powi(64) + digit as f64);
    if sign == Sign::Minus { -magnitude } else { magnitude }
}

impl Add<&Dyadic> for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: &Dyadic) -> Dyadic {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let (a, b, exponent) = self.aligned(other);
        Dyadic { mantissa: a + b, exponent }
    }
}

impl Sub<&Dyadic> for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: &Dyadic) -> Dyadic {
        self + &-other.clone()
    }
}

impl AddAssign<&Dyadic> for Dyadic {
    fn add_assign(&mut self, other: &Dyadic) {
        *self = &*self + other;
    }
}

impl Mul<&Dyadic> for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }
}

impl Neg for Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -self.mantissa, exponent: self.exponent }
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        (self - other).sign()
    }
}
