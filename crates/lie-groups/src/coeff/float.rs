//! Coefficient functions over `f64`.
//!
//! All of them are products of five functions of the half angle `h = theta / 2`, none of which cancels near 0:
//! `sin h`, `cos h`, `q = sin h / h`, `g = (h - sin h) / h^2` and the spherical Bessel function `j = (sin h - h cos h) / h^2`:
//!
//! | function | real part | imaginary part |
//! |---|---|---|
//! | `e^(i theta)` | `cos^2 h - sin^2 h` | `2 sin h cos h` |
//! | `phi_1` | `q cos h` | `q sin h` |
//! | `phi_2` | `q^2 / 2` | `(g + q (g + j)) / 2` |
//! | `psi_1` | `cos h / q` | `-h` |
//! | `psi_2` | `1/2` | `-j / (2 q)` |
//!
//! Up to a half turn `g` and `j` come from their Taylor series, and from these `q = 1 - h g`, `cos h = q - h j`, `sin h = h q`: no
//! division, no call of the platform's sine, so the results are the same bits on every platform.

use super::Coeff;
use crate::{Complex, GroupError, Turn};

/// Number of terms of the two series. At `|h| = pi/2` the first term left out is below `(pi/2)^24 / 26! < 2e-22`.
pub(super) const TERMS: usize = 12;

/// Coefficients `(-1)^j / (2j + 3)!` of `g / h` in `h^2`.
pub(super) const SINE_GAP: [f64; TERMS] = series(false);

/// Coefficients `(-1)^j (2j + 2) / (2j + 3)!` of `j / h` in `h^2`.
pub(super) const BESSEL: [f64; TERMS] = series(true);

/// `(-1)^j w_j / (2j + 3)!` with `w_j = 2j + 2` or 1.
const fn series(weighted: bool) -> [f64; TERMS] {
    let mut c = [0.0; TERMS];
    let mut factorial: u128 = 6;
    let mut j = 0;
    while j < TERMS {
        let weight = if weighted { (2 * j + 2) as f64 } else { 1.0 };
        let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
        c[j] = sign * weight / factorial as f64;
        factorial *= ((2 * j + 4) * (2 * j + 5)) as u128;
        j += 1;
    }
    c
}

/// `sum_j c_j x^j` in two interleaved chains, which run in parallel.
#[inline]
pub(super) fn polynomial(c: &[f64; TERMS], x: f64) -> f64 {
    let x2 = x * x;
    let (mut even, mut odd) = (c[TERMS - 2], c[TERMS - 1]);
    for j in (0..TERMS - 2).step_by(2).rev() {
        even = even * x2 + c[j];
        odd = odd * x2 + c[j + 1];
    }
    even + x * odd
}

/// The five functions of the half angle that all coefficients are made of.
struct HalfAngle {
    sin: f64,
    cos: f64,
    /// `sin h / h`.
    q: f64,
    /// `(h - sin h) / h^2`.
    gap: f64,
    /// `(sin h - h cos h) / h^2`.
    bessel: f64,
}

impl HalfAngle {
    #[inline]
    fn of(theta: f64) -> Self {
        let h = 0.5 * theta;
        if theta.abs() <= std::f64::consts::PI {
            let x = h * h;
            let (gap, bessel) = (polynomial(&SINE_GAP, x), polynomial(&BESSEL, x));
            let q = 1.0 - x * gap;
            Self { sin: h * q, cos: q - x * bessel, q, gap: h * gap, bessel: h * bessel }
        } else {
            let (sin, cos) = h.sin_cos();
            let q = sin / h;
            Self { sin, cos, q, gap: (1.0 - q) / h, bessel: (q - cos) / h }
        }
    }

    #[inline]
    fn phi1(&self) -> Complex<f64> {
        Complex::new(self.q * self.cos, self.q * self.sin)
    }
}

/// `z` brought back to the unit circle to first order.
#[inline]
fn near_unit(z: Complex<f64>) -> Turn<f64> {
    let scale = 1.5 - 0.5 * (z.re * z.re + z.im * z.im);
    Turn::new(Complex::new(z.re * scale, z.im * scale), ())
}

impl Coeff for f64 {
    type Arc = ();

    #[inline]
    fn exp_phi1(theta: f64) -> (Turn<f64>, Complex<f64>) {
        let half = HalfAngle::of(theta);
        let HalfAngle { sin, cos, .. } = half;
        (near_unit(Complex::new((cos - sin) * (cos + sin), 2.0 * sin * cos)), half.phi1())
    }

    #[inline]
    fn turn(theta: f64) -> Turn<f64> {
        Self::exp_phi1(theta).0
    }

    #[inline]
    fn phi1_phi2(theta: f64) -> (Complex<f64>, Complex<f64>) {
        let half = HalfAngle::of(theta);
        let HalfAngle { q, gap, bessel, .. } = half;
        (half.phi1(), Complex::new(0.5 * q * q, 0.5 * (gap + q * (gap + bessel))))
    }

    #[inline]
    fn psi1_psi2(theta: f64) -> Result<(Complex<f64>, Complex<f64>), GroupError> {
        theta.check_finite(0)?;
        // The f64 number TAU lies below 2 pi: up to it the pole is not reached.
        if theta.abs() > std::f64::consts::TAU {
            return Err(GroupError::FullTurn { theta_lo_rad: theta, theta_hi_rad: theta });
        }
        let HalfAngle { cos, q, bessel, .. } = HalfAngle::of(theta);
        let recip = 1.0 / q;
        Ok((Complex::new(cos * recip, -0.5 * theta), Complex::new(0.5, -0.5 * bessel * recip)))
    }

    #[inline]
    fn log_psi1(turn: &Turn<f64>) -> Result<(f64, Complex<f64>), GroupError> {
        let theta = Self::angle(turn)?;
        let Complex { re: cos, im: sin } = turn.unit();
        // cot(t/2) = (1 + cos t) / sin t = sin t / (1 - cos t): take the form whose sum does not cancel.
        let (num, den) = if cos >= 0.0 { (1.0 + cos, sin) } else { (sin, 1.0 - cos) };
        let cot = if den == 0.0 { 1.0 } else { theta * (0.5 * num) / den };
        Ok((theta, Complex::new(cot, -0.5 * theta)))
    }

    #[inline]
    fn angle(turn: &Turn<f64>) -> Result<f64, GroupError> {
        let Complex { re, im } = turn.unit();
        // The angle of an infinite direction would pass as a multiple of pi/4.
        if !(re.abs() + im.abs()).is_finite() {
            return Err(GroupError::NotFinite { index: 0 });
        }
        Ok(im.atan2(re))
    }

    #[inline]
    fn product(a: &Turn<f64>, b: &Turn<f64>) -> Turn<f64> {
        near_unit(a.unit() * b.unit())
    }

    #[inline]
    fn reverse(turn: &Turn<f64>) -> Turn<f64> {
        Turn::new(turn.unit().conj(), ())
    }

    #[inline]
    fn direction(z: Complex<f64>) -> Result<Turn<f64>, GroupError> {
        z.re.check_finite(0)?;
        z.im.check_finite(1)?;
        let largest = z.re.abs().max(z.im.abs());
        if largest == 0.0 {
            return Err(GroupError::NotARotation);
        }
        // Scaled first: the norm of subnormal or huge parts would lose digits or overflow.
        let (re, im) = (z.re / largest, z.im / largest);
        let norm = re.hypot(im);
        Ok(Turn::new(Complex::new(re / norm, im / norm), ()))
    }

    #[inline]
    fn check_finite(self, index: usize) -> Result<(), GroupError> {
        if self.is_finite() { Ok(()) } else { Err(GroupError::NotFinite { index }) }
    }

    #[inline]
    fn ends(self) -> (f64, f64) {
        (self, self)
    }
}
