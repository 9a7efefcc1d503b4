//! Double-double numbers: unevaluated sums of two floats, about 106 bits.
//!
//! Nothing rests on their accuracy: what they lead to is proven from the data like every other answer.
//! Source: Dekker, *A floating-point technique for extending the available precision*, 1971; the sloppy forms of Joldes,
//! Muller, Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*, 2017.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

use crate::real::Real;

/// `head + tail` with `|tail|` at most half a unit in the last place of `head`; ordered by the heads first.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub(crate) struct DoubleDouble {
    head: f64,
    tail: f64,
}

/// The sum of two floats and its rounding error.
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The same if `|a| >= |b|` or `a = 0`.
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let head = a + b;
    DoubleDouble { head, tail: b - (head - a) }
}

impl From<f64> for DoubleDouble {
    fn from(head: f64) -> Self {
        Self { head, tail: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (head, error) = two_sum(self.head, other.head);
        let (tail, rest) = two_sum(self.tail, other.tail);
        let sum = fast_two_sum(head, error + tail);
        fast_two_sum(sum.head, rest + sum.tail)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self { head: -self.head, tail: -self.tail }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let head = self.head * other.head;
        let error = self.head.mul_add(other.head, -head);
        fast_two_sum(head, error + (self.head * other.tail + self.tail * other.head))
    }
}

impl AddAssign for DoubleDouble {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Real for DoubleDouble {
    const ZERO: Self = Self { head: 0.0, tail: 0.0 };
    const ONE: Self = Self { head: 1.0, tail: 0.0 };
    const FEASIBILITY: f64 = 1e-15;
    const CONTRADICTION: f64 = 1e-13;
    const NOISE: f64 = 1e-25;
    const SMALL_PIVOT: f64 = 1e-20;
    const SURE_PIVOT: f64 = 1e-6;
    const ZERO_PIVOT: f64 = 1e-26;
    const REBUILD_PIVOT: f64 = 1e-20;
    const SHIFT: f64 = 1e-22;

    fn to_f64(self) -> f64 {
        self.head
    }

    fn split(self) -> (f64, f64) {
        if self.tail == 0.0 || (self.head < 0.0) == (self.tail < 0.0) {
            return (self.head, self.tail);
        }
        // One step towards zero.
        let head = if self.head > 0.0 { self.head.next_down() } else { self.head.next_up() };
        (head, (self.head - head) + self.tail)
    }

    fn abs(self) -> Self {
        if self.head < 0.0 { -self } else { self }
    }

    fn recip(self) -> Self {
        Self::ONE.over(self)
    }

    fn over(self, divisor: Self) -> Self {
        let first = self.head / divisor.head;
        let rest = self - divisor * Self::from(first);
        let second = rest.head / divisor.head;
        fast_two_sum(first, second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(a: f64, b: f64) -> DoubleDouble {
        DoubleDouble::from(a) + DoubleDouble::from(b)
    }

    #[test]
    fn sums_and_products_have_twice_the_digits() {
        let (a, b) = (number(1.0, 1e-20), number(3.0, -2e-20));
        assert_eq!((a + b - DoubleDouble::from(4.0)).to_f64(), -1e-20);
        assert!(((a * b - DoubleDouble::from(3.0)).to_f64() - 1e-20).abs() < 1e-34);
        assert!((b.recip() * b - DoubleDouble::ONE).to_f64().abs() < 1e-31);
        assert!((a.over(b) * b - a).to_f64().abs() < 1e-31);
        assert!((b - a).abs() == (a - b).abs() && a > DoubleDouble::ONE && -a < -DoubleDouble::ONE);
    }

    #[test]
    fn split_parts_have_one_sign_and_the_same_sum() {
        for x in [number(1.0, 1e-20), number(1.0, -1e-20), number(-1.0, 1e-20), number(-3.0, -1e-17), number(0.1, 0.0)]
        {
            let (head, tail) = x.split();
            assert!(head * tail >= 0.0 && head.abs() >= tail.abs());
            assert!((number(head, tail) - x).to_f64().abs() < 1e-31);
        }
        assert_eq!(0.1.split(), (0.1, 0.0));
    }
}
