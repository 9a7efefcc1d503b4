//! The even functions of half an angle, or half a log-scale, that the coefficients of several groups are made of.

use super::float::{BESSEL, SINE_GAP, polynomial};

/// The even functions of one coordinate; `square` is `h^2`, or `-a^2` for the hyperbolic ones.
pub(super) struct Even {
    pub(super) square: f64,
    /// `sin h / h`, `sinh a / a`.
    pub(super) q: f64,
    /// `cos h`, `cosh a`.
    pub(super) cos: f64,
    /// `(1 - q) / square`.
    pub(super) gap: f64,
    /// `(q - cos) / square`.
    pub(super) bessel: f64,
}

impl Even {
    #[inline]
    pub(super) fn series(square: f64) -> Self {
        let (gap, bessel) = (polynomial(&SINE_GAP, square), polynomial(&BESSEL, square));
        let q = 1.0 - square * gap;
        Self { square, q, cos: q - square * bessel, gap, bessel }
    }

    pub(super) fn closed(square: f64, q: f64, cos: f64) -> Self {
        Self { square, q, cos, gap: (1.0 - q) / square, bessel: (q - cos) / square }
    }

    #[inline]
    pub(super) fn circular(h: f64) -> Self {
        if h.abs() <= std::f64::consts::FRAC_PI_2 {
            Self::series(h * h)
        } else {
            let (sin, cos) = h.sin_cos();
            Self::closed(h * h, sin / h, cos)
        }
    }

    #[inline]
    pub(super) fn hyperbolic(a: f64) -> Self {
        if a.abs() <= std::f64::consts::FRAC_PI_2 {
            Self::series(-a * a)
        } else {
            Self::closed(-a * a, a.sinh() / a, a.cosh())
        }
    }
}
