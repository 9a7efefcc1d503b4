//! Exponential, logarithm and hyperbolic functions.
//!
//! Values come from `pxfm`, whose results are found (not proven) to be within half a unit in the last place; every bound is
//! moved two units outward. Bounds that a function cannot pass (`e^x >= 0`, `|tanh x| <= 1`) are kept.

use crate::Interval;
use crate::rounding::{larger, smaller, step_down, step_down_nonzero, step_up, step_up_nonzero};

/// Two steps down from a value of `pxfm`; exact zeros stay zero, NaN passes.
#[inline]
pub(crate) fn below(c: f64) -> f64 {
    step_down_nonzero(step_down_nonzero(c))
}

/// Two steps up from a value of `pxfm`; exact zeros stay zero, NaN passes.
#[inline]
pub(crate) fn above(c: f64) -> f64 {
    step_up_nonzero(step_up_nonzero(c))
}

impl Interval {
    /// Image under an increasing function whose zeros are exact, from its values to nearest.
    #[inline]
    pub(crate) fn increasing(self, f: impl Fn(f64) -> f64) -> Self {
        if self.is_empty() {
            return self;
        }
        Self::raw(below(f(self.lo)), above(f(self.hi)))
    }

    /// `{ e^x }`.
    ///
    /// ```
    /// use scalars::Interval;
    /// let e = Interval::ONE.exp();
    /// assert!(e.contains(std::f64::consts::E) && e.width() < 4e-15);
    /// ```
    #[must_use]
    pub fn exp(self) -> Self {
        if self.is_empty() {
            return self;
        }
        // A zero here is an underflow, never exact.
        Self::raw(larger(0.0, below(pxfm::f_exp(self.lo))), step_up(step_up(pxfm::f_exp(self.hi))))
    }

    /// `{ ln(x) : x > 0 }`; empty if no member is positive.
    #[must_use]
    pub fn ln(self) -> Self {
        if self.hi > 0.0 {
            let lo = if self.lo > 0.0 { below(pxfm::f_log(self.lo)) } else { f64::NEG_INFINITY };
            return Self::raw(lo, above(pxfm::f_log(self.hi)));
        }
        Self::EMPTY
    }

    /// `{ sinh(x) }`.
    #[must_use]
    pub fn sinh(self) -> Self {
        self.increasing(pxfm::f_sinh)
    }

    /// `{ cosh(x) }`.
    #[must_use]
    pub fn cosh(self) -> Self {
        let y = self.abs().increasing(pxfm::f_cosh);
        Self::raw(larger(1.0, y.lo), y.hi)
    }

    /// `{ tanh(x) }`.
    #[must_use]
    pub fn tanh(self) -> Self {
        let y = self.increasing(pxfm::f_tanh);
        Self::raw(larger(-1.0, y.lo), smaller(1.0, y.hi))
    }
}

/// Bounds of a value of `pxfm` whose zeros are underflows.
#[inline]
pub(crate) fn around(c: f64) -> Interval {
    Interval::raw(step_down(step_down(c)), step_up(step_up(c)))
}
