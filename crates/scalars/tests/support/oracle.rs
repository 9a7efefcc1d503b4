//! Elementary functions in fixed point of a chosen precision: Taylor series after argument reduction, integers only.
//!
//! Values are integers `v` for `v / 2^P`; the error of each function is far below `2^20` units (`MARGIN`).

use std::collections::HashMap;
use std::sync::Mutex;

use num_bigint::BigInt;

use scalars::Interval;

use super::dyadic::{Dyadic, at_or_below};
use super::excess;

/// Units in the last place that cover the truncations of every function here.
const MARGIN: u32 = 24;

/// Fixed-point numbers with `P` fractional bits.
#[derive(Clone, Copy)]
pub struct Fixed {
    pub bits: usize,
}

/// A value with its error, as two exact numbers around the true one.
pub struct Enclosure {
    pub lo: Dyadic,
    pub hi: Dyadic,
}

fn float_parts(x: f64) -> (BigInt, i64) {
    let bits = x.to_bits();
    let biased = ((bits >> 52) & 0x7FF) as i64;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let mantissa = if biased == 0 { fraction } else { fraction | 1 << 52 };
    (BigInt::from(if x < 0.0 { -mantissa } else { mantissa }), biased.max(1) - 1075)
}

impl Enclosure {
    /// False only if the true value is proven outside the interval.
    pub fn may_lie_in(&self, x: Interval) -> bool {
        at_or_below(x.lo(), &self.hi) && at_or_below(-x.hi(), &self.lo.neg())
    }

    /// Floats between the bounds of an interval and the tightest bounds of the value: the larger of both sides.
    pub fn excess_of(&self, x: Interval) -> u32 {
        let lower = excess(x.lo(), f64::next_up, |bound| at_or_below(bound, &self.lo));
        let upper = excess(x.hi(), f64::next_down, |bound| at_or_below(-bound, &self.hi.neg()));
        lower.max(upper)
    }
}

impl Fixed {
    /// Enough bits for a value near `x` to have 200 significant ones.
    pub fn for_size(x: f64) -> Self {
        let exponent = float_parts(x).0.bits() as i64 + float_parts(x).1;
        Self { bits: (320 - exponent.min(0)) as usize }
    }

    pub fn enclose(self, value: &BigInt) -> Enclosure {
        let margin = BigInt::from(1) << MARGIN;
        let e = -(self.bits as i64);
        Enclosure { lo: Dyadic::new(value - &margin, e), hi: Dyadic::new(value + &margin, e) }
    }

    pub fn one(self) -> BigInt {
        BigInt::from(1) << self.bits
    }

    pub fn float(self, x: f64) -> BigInt {
        let (mantissa, exponent) = float_parts(x);
        let shift = exponent + self.bits as i64;
        if shift >= 0 { mantissa << shift as usize } else { mantissa >> (-shift) as usize }
    }

    fn mul(self, a: &BigInt, b: &BigInt) -> BigInt {
        (a * b) >> self.bits
    }

    fn div(self, a: &BigInt, b: &BigInt) -> BigInt {
        (a << self.bits) / b
    }

    fn sqrt(self, a: &BigInt) -> BigInt {
        (a << self.bits).sqrt()
    }

    /// `sum_j sign^j x^(2j + first) / (2j + first)!`.
    fn factorial_series(self, x: &BigInt, first: u32, sign: i32) -> BigInt {
        let square = self.mul(x, x) * sign;
        let mut term = if first == 0 { self.one() } else { x.clone() };
        let (mut sum, mut n) = (term.clone(), first);
        while term.magnitude().bits() > 1 {
            term = self.mul(&term, &square) / ((n + 1) * (n + 2));
            sum += &term;
            n += 2;
        }
        sum
    }

    /// `sum_j sign^j x^(2j + 1) / (2j + 1)`.
    fn odd_series(self, x: &BigInt, sign: i32) -> BigInt {
        let square = self.mul(x, x) * sign;
        let (mut power, mut sum, mut n) = (x.clone(), x.clone(), 1_u32);
        while power.magnitude().bits() > 1 {
            power = self.mul(&power, &square);
            n += 2;
            sum += &power / n;
        }
        sum
    }

    /// Pi by Machin's formula, kept for every precision asked.
    pub fn pi(self) -> BigInt {
        static KNOWN: Mutex<Option<HashMap<usize, BigInt>>> = Mutex::new(None);
        let mut known = KNOWN.lock().unwrap();
        known
            .get_or_insert_default()
            .entry(self.bits)
            .or_insert_with(|| {
                let wide = Fixed { bits: self.bits + 32 };
                let atan_inverse = |n: u32| wide.odd_series(&(wide.one() / n), -1);
                (atan_inverse(5) * 16 - atan_inverse(239) * 4) >> 32
            })
            .clone()
    }

    fn ln2(self) -> BigInt {
        let atanh_inverse = |n: u32| self.odd_series(&(self.one() / n), 1);
        atanh_inverse(26) * 18 - atanh_inverse(4801) * 2 + atanh_inverse(8749) * 8
    }

    /// `e^x` for `|x| < 2^11`.
    pub fn exp(self, x: &BigInt) -> BigInt {
        let wide = Fixed { bits: self.bits + 64 };
        let x: BigInt = x << 64;
        let ln2 = wide.ln2();
        let k = (&x / &ln2).to_string().parse::<i64>().unwrap();
        const HALVINGS: usize = 8;
        let r = (&x - &ln2 * k) >> HALVINGS;
        let mut y = wide.factorial_series(&r, 0, 1) + wide.factorial_series(&r, 1, 1);
        for _ in 0..HALVINGS {
            y = wide.mul(&y, &y);
        }
        if k >= 0 { (y << k as usize) >> 64 } else { y >> (64 - k) as usize }
    }

    /// `ln(x)`, `x > 0` given as a float.
    pub fn ln(self, x: f64) -> BigInt {
        let (mantissa, exponent) = float_parts(x);
        // x = m 2^e with m in [1/2, 1), or [1, 2) where x is near one, so that nothing cancels.
        let bits = mantissa.bits() as i64 - i64::from(x >= 1.0);
        let m = if bits <= self.bits as i64 { mantissa << (self.bits as i64 - bits) as usize } else { unreachable!() };
        let e = exponent + bits;
        const ROOTS: usize = 6;
        let root = (0..ROOTS).fold(m, |m, _| self.sqrt(&m));
        let z = self.div(&(&root - self.one()), &(&root + self.one()));
        (self.odd_series(&z, 1) << (ROOTS + 1)) + self.ln2() * e
    }

    /// Sine and cosine of a float of any size.
    pub fn sin_cos(self, x: f64) -> (BigInt, BigInt) {
        let wide = Fixed { bits: self.bits + 1100 };
        let half_pi: BigInt = wide.pi() >> 1;
        let x = wide.float(x);
        // Floor division by hand: truncation goes towards zero.
        let mut k: BigInt = &x / &half_pi;
        if x < BigInt::ZERO {
            k -= 1;
        }
        let r: BigInt = (x - &k * half_pi) >> 1100;
        let (s, c) = (self.factorial_series(&r, 1, -1), self.factorial_series(&r, 0, -1));
        // Two bits of k, also for negative k, count the quarter turns.
        match (k.bit(1), k.bit(0)) {
            (false, false) => (s, c),
            (false, true) => (c, -s),
            (true, false) => (-s, -c),
            (true, true) => (-c, s),
        }
    }

    /// Tangent of a float.
    pub fn tan(self, x: f64) -> BigInt {
        let (s, c) = self.sin_cos(x);
        self.div(&s, &c)
    }

    /// Inverse tangent.
    pub fn atan(self, x: &BigInt) -> BigInt {
        if *x < BigInt::ZERO {
            return -self.atan(&-x);
        }
        if *x > self.one() {
            return (self.pi() >> 1) - self.atan(&self.div(&self.one(), x));
        }
        const HALVINGS: usize = 6;
        let half = (0..HALVINGS).fold(x.clone(), |x, _| {
            let root = self.sqrt(&(self.one() + self.mul(&x, &x)));
            self.div(&x, &(self.one() + root))
        });
        self.odd_series(&half, -1) << HALVINGS
    }

    /// Angle of a point given by two floats, `x` and `y` not both zero.
    pub fn atan2(self, y: f64, x: f64) -> BigInt {
        let ratio = |a: f64, b: f64| {
            let ((a, e), (b, f)) = (float_parts(a.abs()), float_parts(b.abs()));
            let shift = self.bits as i64 + e - f;
            if shift >= 0 { (a << shift as usize) / b } else { a / (b << (-shift) as usize) }
        };
        let acute =
            if y.abs() <= x.abs() { self.atan(&ratio(y, x)) } else { (self.pi() >> 1) - self.atan(&ratio(x, y)) };
        let upper = if x < 0.0 { self.pi() - acute } else { acute };
        if y < 0.0 { -upper } else { upper }
    }

    /// Inverse sine of a float in `[-1, 1]`.
    pub fn asin(self, x: f64) -> BigInt {
        let v = self.float(x);
        let cosine = self.sqrt(&(self.one() - self.mul(&v, &v)));
        if cosine == BigInt::ZERO {
            let quarter: BigInt = self.pi() >> 1;
            return if x > 0.0 { quarter } else { -quarter };
        }
        self.atan(&self.div(&v, &cosine))
    }

    /// Inverse cosine of a float in `[-1, 1]`.
    pub fn acos(self, x: f64) -> BigInt {
        let v = self.float(x);
        if v == -self.one() {
            return self.pi();
        }
        self.atan(&self.sqrt(&self.div(&(self.one() - &v), &(self.one() + &v)))) * 2
    }

    /// Hyperbolic sine and cosine.
    pub fn sinh_cosh(self, x: &BigInt) -> (BigInt, BigInt) {
        if *x.magnitude() < *self.one().magnitude() {
            return (self.factorial_series(x, 1, 1), self.factorial_series(x, 0, 1));
        }
        let (plus, minus) = (self.exp(x), self.exp(&-x));
        ((&plus - &minus) >> 1, (plus + minus) >> 1)
    }

    /// Hyperbolic tangent.
    pub fn tanh(self, x: &BigInt) -> BigInt {
        let (s, c) = self.sinh_cosh(x);
        self.div(&s, &c)
    }

    /// Stumpff function `sum_j (-s)^j / (2j + k)!` by its plain series.
    pub fn stumpff(self, s: f64, k: u32) -> BigInt {
        // Terms grow up to e^sqrt|s| before they cancel or add up; 64 spare bits cover the roundings.
        let wide = Fixed { bits: self.bits + 64 };
        let s = wide.float(s);
        let mut term = (1..=k).fold(wide.one(), |t, i| t / i);
        let (mut sum, mut n) = (term.clone(), k);
        while term.magnitude().bits() > 1 {
            term = -wide.mul(&term, &s) / ((n + 1) * (n + 2));
            sum += &term;
            n += 2;
        }
        sum >> 64
    }
}
