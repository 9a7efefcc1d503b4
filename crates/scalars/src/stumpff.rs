//! Stumpff functions `C_k(s) = sum_j (-s)^j / (2j + k)!`: sine and cosine without a square root of the argument.
//!
//! With `s = theta^2`: `C_0 = cos theta`, `C_1 = sin theta / theta`, `C_2 = (1 - cos theta) / theta^2`,
//! `C_3 = (theta - sin theta) / theta^3`; with `s = -theta^2` the hyperbolic functions. They are entire functions, smooth
//! across `s = 0`, which makes them the coefficients of exponentials and Jacobians of rotation groups.
//!
//! Facts used: `C_{k+2}(s) = (1/k! - C_k(s)) / s`; `C_2(s) = C_1(s/4)^2 / 2`; every `C_k` decreases on `s <= 0`; `C_1`
//! decreases up to its first minimum at `s = 20.19..`; `C_k` decreases everywhere for `k >= 3`. The last: for `C_3` this is
//! the Cusa-Huygens inequality `3 sin theta < theta (2 + cos theta)`, and `C_{k+1}(s) = int_0^1 t^k C_k(s t^2) dt` passes
//! it on. So a range is found from the values at the two ends, except for `C_0`, `C_1`, `C_2` far out.

use crate::{Interval, Scalar};

impl Interval {
    /// `{ C_k(s) }` for every interval of `s`, positive, negative or both, and `k <= 20`; beyond, the whole line.
    ///
    /// **Guarantee:** superset; the exact range up to rounding, except for `k = 1` beyond `s = 20` and `k = 2` beyond `s = 80`.
    ///
    /// ```
    /// use scalars::Interval;
    /// let s = Interval::new(-1e-9, 1e-9)?; // theta^2, theta near 0
    /// assert!(s.stumpff(1).contains(1.0) && s.stumpff(1).width() < 1e-9);
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    #[must_use]
    pub fn stumpff(self, k: usize) -> Self {
        if self.is_empty() {
            return self;
        }
        let half_line = Self::raw(0.0, f64::INFINITY);
        match k {
            0 => {
                let circular = self.intersection(half_line).sqrt().cos();
                let hyperbolic = (-self).intersection(half_line).sqrt().cosh();
                circular.hull(hyperbolic)
            }
            1 => {
                const MONOTONE: f64 = 20.0;
                let near = self.intersection(Self::raw(f64::NEG_INFINITY, MONOTONE)).decreasing_stumpff(1);
                let theta = self.intersection(Self::raw(MONOTONE, f64::INFINITY)).sqrt();
                near.hull(theta.sin() / theta)
            }
            2 => self.scale(0.25).stumpff(1).sqr().scale(0.5),
            _ => self.decreasing_stumpff(k),
        }
    }

    /// Range where `C_k` decreases.
    fn decreasing_stumpff(self, k: usize) -> Self {
        if self.is_empty() {
            return self;
        }
        let at_lo = stumpff_at::<Self>(self.lo, k);
        let at_hi = if self.lo == self.hi { at_lo } else { stumpff_at(self.hi, k) };
        Self::raw(at_hi.lo, at_lo.hi)
    }
}

/// `C_k(s)` at a floating-point number, `k >= 1` if `s` is infinite; the table of factorials serves `k <= 20`.
pub(crate) fn stumpff_at<S: Scalar>(s: f64, k: usize) -> S {
    if k > 20 {
        return inverse_factorial(usize::MAX);
    }
    if s.is_infinite() {
        return if s > 0.0 { S::zero() } else { S::from_f64(f64::INFINITY) };
    }
    // For larger s, terms of the series cancel.
    if s.abs() <= if k < 3 { 4.0 } else { 16.0 } {
        return series(s, k);
    }
    match k {
        0 | 1 => {
            let theta = S::from_f64(s.abs()).sqrt();
            match (k, s > 0.0) {
                (0, true) => theta.cos(),
                (0, false) => theta.cosh(),
                (_, true) => theta.sin() / theta,
                (_, false) => theta.sinh() / theta,
            }
        }
        2 => stumpff_at::<S>(0.25 * s, 1).sqr().scale(0.5),
        _ => (inverse_factorial::<S>(k - 2) - stumpff_at(s, k - 2)) / S::from_f64(s),
    }
}

/// Taylor series by Horner's rule, for `|s| <= 16`.
fn series<S: Scalar>(s: f64, k: usize) -> S {
    let terms = match s.abs() {
        r if r <= 0.01 => 6,
        r if r <= 4.0 => 13,
        _ => 16,
    };
    // From the first term left out on, each is less than half of the one before: their sum is less than twice the first.
    let tail = S::lit(-2.0, 2.0) * inverse_factorial(2 * terms + k);
    (0..terms).rev().fold(tail, |sum, j| inverse_factorial::<S>(2 * j + k) - sum.scale(s))
}

/// `1 / n!`; the whole line beyond the table.
fn inverse_factorial<S: Scalar>(n: usize) -> S {
    let (lo, hi) = INVERSE_FACTORIALS.get(n).copied().unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    S::lit(lo, hi)
}

/// Lower and upper bounds of `1 / n!`.
const INVERSE_FACTORIALS: [(f64, f64); 53] = inverse_factorials();

const fn inverse_factorials() -> [(f64, f64); 53] {
    // 1/0!, 1/1!, 1/2! are exact; each further quotient is stepped outward.
    let mut table = [(1.0, 1.0); 53];
    table[2] = (0.5, 0.5);
    let (mut n, mut factorial) = (3, 2.0);
    while n < table.len() {
        factorial *= n as f64;
        table[n] = if n <= 22 {
            // n! is exact.
            ((1.0 / factorial).next_down(), (1.0 / factorial).next_up())
        } else {
            let (lo, hi) = table[n - 1];
            ((lo / n as f64).next_down(), (hi / n as f64).next_up())
        };
        n += 1;
    }
    table
}
