//! [`Series`]: a truncated power series in time, to find the Taylor coefficients of solutions.

use num_traits::{One, Zero};
use scalars::Scalar;

/// `c_0 + c_1 t + .. + c_{K-1} t^{K-1}`, of which the first `known` coefficients are known.
///
/// An operation knows as many coefficients of its result as of its operands, and computes no others: the coefficients of a solution are
/// found one by one. Every coefficient is found by the recurrence of its function from the coefficients before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Series<S, const K: usize> {
    coefficients: [S; K],
    known: usize,
    /// Coefficients from here on are structurally zero.
    end: usize,
}

impl<S: Scalar, const K: usize> Series<S, K> {
    /// A constant, known to every order.
    pub(super) fn constant(value: S) -> Self {
        let mut coefficients = [S::zero(); K];
        coefficients[0] = value;
        Self { coefficients, known: K, end: 1 }
    }

    /// A series of which only the first coefficient is known.
    pub(super) fn start(value: S) -> Self {
        Self { known: 1, end: K, ..Self::constant(value) }
    }

    /// Makes the next coefficient known.
    pub(super) fn push(&mut self, value: S) {
        if let Some(coefficient) = self.coefficients.get_mut(self.known) {
            *coefficient = value;
            self.known += 1;
        }
    }

    pub(super) fn coefficient(&self, k: usize) -> S {
        self.coefficients[k]
    }

    fn is_constant(&self) -> bool {
        self.end == 1
    }

    /// The series with coefficient 0 of `first` and those after it by a recurrence, from the order and the coefficients so far.
    fn recur(known: usize, first: S, mut next: impl FnMut(usize, &[S; K]) -> S) -> Self {
        let mut result = Self { known, end: K, ..Self::constant(first) };
        for k in 1..known {
            result.coefficients[k] = next(k, &result.coefficients);
        }
        result
    }

    /// `f` on every coefficient of both.
    fn zip(&self, other: &Self, f: impl Fn(S, S) -> S) -> Self {
        let (known, end) = (self.known.min(other.known), self.end.max(other.end));
        let mut result = Self { known, end, ..Self::constant(f(self.coefficients[0], other.coefficients[0])) };
        for k in 1..known.min(end) {
            result.coefficients[k] = f(self.coefficients[k], other.coefficients[k]);
        }
        result
    }

    /// `f` on every coefficient, for a linear `f`.
    fn map(mut self, f: impl Fn(S) -> S) -> Self {
        for k in 0..self.known.min(self.end) {
            self.coefficients[k] = f(self.coefficients[k]);
        }
        self
    }

    /// The same series with another first coefficient: a tighter one.
    fn with_first(mut self, first: S) -> Self {
        self.coefficients[0] = first;
        self
    }

    /// Coefficient `k` of the product.
    fn convolution(&self, other: &Self, k: usize) -> S {
        let start = (k + 1).saturating_sub(other.end);
        (start..=k.min(self.end - 1)).fold(S::zero(), |sum, j| sum + self.coefficients[j] * other.coefficients[k - j])
    }

    /// `v` with `v b = a`.
    fn quotient(self, b: &Self) -> Self {
        let divisor = b.coefficients[0];
        if b.is_constant() {
            return self.map(|x| x / divisor);
        }
        Self::recur(self.known.min(b.known), self.coefficients[0] / divisor, |k, v| {
            (1..=k).fold(self.coefficients[k], |rest, j| rest - b.coefficients[j] * v[k - j]) / divisor
        })
    }

    /// `v` with `v' = w u'`, `u` this series: coefficient `k` is `1/k sum_j j u_j w_{k-j}`.
    fn integrated(&self, first: S, w: &Self) -> Self {
        if self.is_constant() {
            return Self::constant(first);
        }
        Self::recur(self.known.min(w.known), first, |k, _| weighted(&self.coefficients, &w.coefficients, k))
    }

    /// Two functions `(v, w)` with `v' = w u'`, `w' = sign v u'`.
    fn integrated_pair(&self, (v, w): (S, S), negative: bool) -> (Self, Self) {
        if self.is_constant() {
            return (Self::constant(v), Self::constant(w));
        }
        let mut pair = (Self { known: self.known, end: K, ..Self::constant(v) }, Self::constant(w));
        pair.1 = Self { known: self.known, end: K, ..pair.1 };
        for k in 1..self.known {
            pair.0.coefficients[k] = weighted(&self.coefficients, &pair.1.coefficients, k);
            let slope = weighted(&self.coefficients, &pair.0.coefficients, k);
            pair.1.coefficients[k] = if negative { -slope } else { slope };
        }
        pair
    }

    /// The derivative by time, times `t`: coefficient `k` is `k c_k`.
    fn euler_derivative(mut self) -> Self {
        self.coefficients[0] = S::zero();
        for k in 2..self.known.min(self.end) {
            self.coefficients[k] = self.coefficients[k].scale(k as f64);
        }
        self
    }

    /// One of two: `a` where `lead` is positive, `b` where it is negative.
    fn select(self, other: Self, first: S, lead: S) -> Self {
        let side = lead.sign();
        let (a, b) = (side.add_f64(1.0).scale(0.5), (-side).add_f64(1.0).scale(0.5));
        self.zip(&other, |x, y| a * x + b * y).with_first(first)
    }
}

/// `1/k sum_{j=1}^k j u_j w_{k-j}`.
fn weighted<S: Scalar, const K: usize>(u: &[S; K], w: &[S; K], k: usize) -> S {
    (1..=k).fold(S::zero(), |sum, j| sum + (u[j] * w[k - j]).scale(j as f64)) / S::from_f64(k as f64)
}

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident |$a:ident, $b:ident| $body:expr;)*) => {$(
        impl<S: Scalar, const K: usize> std::ops::$trait for Series<S, K> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $body
            }
        }
        impl<S: Scalar, const K: usize> std::ops::$assign for Series<S, K> {
            fn $assign_method(&mut self, other: Self) {
                *self = std::ops::$trait::$method(*self, other);
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign |a, b| a.zip(&b, |x, y| x + y);
    Sub sub SubAssign sub_assign |a, b| a.zip(&b, |x, y| x - y);
    Mul mul MulAssign mul_assign |a, b| {
        let known = a.known.min(b.known);
        let product = Self::recur(known, a.coefficients[0] * b.coefficients[0], |k, _| a.convolution(&b, k));
        Self { end: (a.end + b.end - 1).min(K), ..product }
    };
    Div div DivAssign div_assign |a, b| a.quotient(&b);
}

impl<S: Scalar, const K: usize> std::ops::Neg for Series<S, K> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<S: Scalar, const K: usize> Zero for Series<S, K> {
    fn zero() -> Self {
        Self::constant(S::zero())
    }
    fn is_zero(&self) -> bool {
        self.coefficients.iter().all(S::is_zero)
    }
}

impl<S: Scalar, const K: usize> One for Series<S, K> {
    fn one() -> Self {
        Self::constant(S::one())
    }
}

impl<S: Scalar, const K: usize> Scalar for Series<S, K> {
    fn from_f64(x: f64) -> Self {
        Self::constant(S::from_f64(x))
    }
    fn lit(lo: f64, hi: f64) -> Self {
        Self::constant(S::lit(lo, hi))
    }
    fn ratio(p: i64, q: i64) -> Self {
        Self::constant(S::ratio(p, q))
    }
    fn decimal(text: &str) -> Self {
        Self::constant(S::decimal(text))
    }
    fn pi() -> Self {
        Self::constant(S::pi())
    }
    fn scale(self, k: f64) -> Self {
        self.map(|x| x.scale(k))
    }
    fn add_f64(self, k: f64) -> Self {
        self.with_first(self.coefficients[0].add_f64(k))
    }
    fn sqr(self) -> Self {
        (self * self).with_first(self.coefficients[0].sqr())
    }
    fn recip(self) -> Self {
        (Self::one() / self).with_first(self.coefficients[0].recip())
    }
    fn sqrt(self) -> Self {
        let root = self.coefficients[0].sqrt();
        if self.is_constant() {
            return Self::constant(root);
        }
        Self::recur(self.known, root, |k, v| {
            (1..k).fold(self.coefficients[k], |rest, j| rest - v[j] * v[k - j]) / root.scale(2.0)
        })
    }
    fn powi(self, n: i32) -> Self {
        let first = self.coefficients[0].powi(n);
        if self.is_constant() || n == 0 {
            return Self::constant(first);
        }
        // From the second-highest bit of |n| down: square, and multiply where the bit is set.
        let degree = n.unsigned_abs();
        let power = (0..degree.ilog2()).rev().fold(self, |power, bit| {
            let square = power.sqr();
            if degree >> bit & 1 == 1 { square * self } else { square }
        });
        (if n < 0 { power.recip() } else { power }).with_first(first)
    }
    fn exp(self) -> Self {
        let first = self.coefficients[0].exp();
        if self.is_constant() {
            return Self::constant(first);
        }
        Self::recur(self.known, first, |k, v| weighted(&self.coefficients, v, k))
    }
    fn ln(self) -> Self {
        self.integrated(self.coefficients[0].ln(), &self.recip())
    }
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    fn sin_cos(self) -> (Self, Self) {
        self.integrated_pair(self.coefficients[0].sin_cos(), true)
    }
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        (sin / cos).with_first(self.coefficients[0].tan())
    }
    fn asin(self) -> Self {
        self.integrated(self.coefficients[0].asin(), &(Self::one() - self.sqr()).sqrt().recip())
    }
    fn acos(self) -> Self {
        self.integrated(self.coefficients[0].acos(), &-(Self::one() - self.sqr()).sqrt().recip())
    }
    fn atan(self) -> Self {
        self.integrated(self.coefficients[0].atan(), &self.sqr().add_f64(1.0).recip())
    }
    fn atan2(self, x: Self) -> Self {
        // t times the derivative of the angle, then each coefficient over its order.
        let area = x * self.euler_derivative() - self * x.euler_derivative();
        let turned = area / (x.sqr() + self.sqr());
        let first = self.coefficients[0].atan2(x.coefficients[0]);
        Self::recur(turned.known, first, |k, _| turned.coefficients[k] / S::from_f64(k as f64))
    }
    fn sinh(self) -> Self {
        self.integrated_pair((self.coefficients[0].sinh(), self.coefficients[0].cosh()), false).0
    }
    fn cosh(self) -> Self {
        self.integrated_pair((self.coefficients[0].sinh(), self.coefficients[0].cosh()), false).1
    }
    fn tanh(self) -> Self {
        self.integrated(self.coefficients[0].tanh(), &self.cosh().recip().sqr())
    }
    fn abs(self) -> Self {
        let side = self.coefficients[0].sign();
        self.map(|x| side * x).with_first(self.coefficients[0].abs())
    }
    fn sign(self) -> Self {
        Self::constant(self.coefficients[0].sign())
    }
    fn min(self, other: Self) -> Self {
        let (a, b) = (self.coefficients[0], other.coefficients[0]);
        self.select(other, a.min(b), b - a)
    }
    fn max(self, other: Self) -> Self {
        let (a, b) = (self.coefficients[0], other.coefficients[0]);
        self.select(other, a.max(b), a - b)
    }
    fn stumpff(self, k: usize) -> Self {
        let first = self.coefficients[0].stumpff(k);
        if self.is_constant() {
            return Self::constant(first);
        }
        // Taylor polynomial of C_k about the first coefficient, by Horner's rule. Its derivative j is the sum over i of
        // weights[i] C_{k+j+i}, by C_m' = (m C_{m+2} - C_{m+1}) / 2; the weights are exact.
        let at = self.coefficients[0];
        let (mut terms, mut weights, mut factorial) = ([first; K], [0.0; K], 1);
        weights[0] = 1.0;
        for j in 1..self.known {
            for i in (0..j).rev() {
                weights[i + 1] += 0.5 * k.saturating_add(j - 1 + i) as f64 * weights[i];
                weights[i] *= -0.5;
            }
            factorial *= j as i64;
            let derivative =
                (0..=j).fold(S::zero(), |sum, i| sum + at.stumpff(k.saturating_add(j + i)).scale(weights[i]));
            terms[j] = derivative / S::ratio(factorial, 1);
        }
        let step = self.with_first(S::zero());
        let last = Self::constant(terms[self.known - 1]);
        (0..self.known - 1).rev().fold(last, |sum, j| sum * step + Self::constant(terms[j])).with_first(first)
    }
}
