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
    /// **Guarantee:** superset; the range to rounding for `k >= 3` and, for `k = 0, 1, 2`, where `s <= 20`.
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
        Self::raw(stumpff_at::<Self>(self.hi, k).lo, stumpff_at::<Self>(self.lo, k).hi)
    }
}

/// `C_k(s)` at a floating-point number, `k >= 1` if `s` is infinite.
pub(crate) fn stumpff_at<S: Scalar>(s: f64, k: usize) -> S {
    if s.is_infinite() {
        return if s > 0.0 { S::zero() } else { S::from_f64(f64::INFINITY) };
    }
    let series_limit = if k < 3 { 1.0 } else { 16.0 };
    if s.abs() <= series_limit {
        return series(s, k);
    }
    let theta = S::from_f64(s.abs()).sqrt();
    match k {
        0 => {
            if s > 0.0 {
                theta.cos()
            } else {
                theta.cosh()
            }
        }
        1 => {
            if s > 0.0 {
                theta.sin() / theta
            } else {
                theta.sinh() / theta
            }
        }
        2 => stumpff_at::<S>(0.25 * s, 1).sqr().scale(0.5),
        _ => (inverse_factorial::<S>(k - 2) - stumpff_at(s, k - 2)) / S::from_f64(s),
    }
}

/// Taylor series in nested form, `C_k = 1/k! (1 - s/((k+1)(k+2)) (1 - s/((k+3)(k+4)) (..)))`, for `|s| <= 16`.
fn series<S: Scalar>(s: f64, k: usize) -> S {
    let terms = if s.abs() <= 1.0 { 9 } else { 18 };
    // The ratio of successive terms left out is below 1/2, so the innermost factor lies in [-2, 2].
    let sum = (0..terms).rev().fold(S::lit(-2.0, 2.0), |sum, j| {
        let n = (k + 2 * j) as f64;
        S::one() - sum.scale(s) / S::from_f64((n + 1.0) * (n + 2.0))
    });
    sum * inverse_factorial(k)
}

/// `1 / k!`; the whole line where `k!` does not fit (`k > 20`).
fn inverse_factorial<S: Scalar>(k: usize) -> S {
    let factorial = (1..=k as i64).try_fold(1_i64, i64::checked_mul);
    S::ratio(1, factorial.unwrap_or(0))
}
