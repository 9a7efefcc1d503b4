//! Coefficient functions over `f64`.
//!
//! Everything is built from the sine and cosine of the half angle `h = theta / 2` and `q = sin h / h`, because in these
//! no formula cancels near 0: `sin t / t = q cos h`, `(1 - cos t) / t = q sin h`, `(1 - cos t) / t^2 = q^2 / 2`,
//! `(t/2) cot(t/2) = cos h / q`. Two functions remain that cancel; they are entire (up to the factor `q`) and come from their Taylor series.

use super::Coeff;
use crate::{Complex, GroupError};

/// `(t - sin t) / t^3 = sum_j (-t^2)^j / (2j + 3)!` for `|t| <= pi`.
///
/// The first omitted term is below `pi^28 / 31! < 1e-19`.
#[inline]
fn sine_gap(x: f64) -> f64 {
    const C: [f64; 14] = series_coefficients(false);
    even_odd(&C, x)
}

/// `(sin h / h - cos h) / h^2 = sum_j (-h^2)^j (2j + 2) / (2j + 3)!` for `|h| <= pi / 2`.
///
/// The first omitted term is below `(pi/2)^28 30 / 31! < 1e-26`.
#[inline]
fn bessel_gap(x: f64) -> f64 {
    const C: [f64; 14] = series_coefficients(true);
    even_odd(&C, x)
}

/// Signed coefficients `(-1)^j w_j / (2j + 3)!` with `w_j = 2j + 2` or 1, each correctly rounded up to one ulp.
const fn series_coefficients(weighted: bool) -> [f64; 14] {
    let mut c = [0.0; 14];
    // (2j + 3)! as an integer is exact in u128 up to 33!.
    let mut factorial: u128 = 6;
    let mut j = 0;
    while j < 14 {
        let weight = if weighted { (2 * j + 2) as f64 } else { 1.0 };
        let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
        c[j] = sign * weight / factorial as f64;
        factorial *= ((2 * j + 4) * (2 * j + 5)) as u128;
        j += 1;
    }
    c
}

/// `sum_j c_j x^j`, as two interleaved Horner chains in `x^2` so that they run in parallel.
#[inline]
fn even_odd(c: &[f64; 14], x: f64) -> f64 {
    let x2 = x * x;
    let mut even = c[12];
    let mut odd = c[13];
    let mut j = 12;
    while j > 0 {
        j -= 2;
        even = even * x2 + c[j];
        odd = odd * x2 + c[j + 1];
    }
    even + x * odd
}

/// `(sin h, cos h, sin h / h)` of the half angle `h = theta / 2`.
#[inline]
fn half_angle(theta: f64) -> (f64, f64, f64) {
    let h = 0.5 * theta;
    let (sin, cos) = h.sin_cos();
    let q = if h == 0.0 { 1.0 } else { sin / h };
    (sin, cos, q)
}

impl Coeff for f64 {
    #[inline]
    fn exp_phi1(theta: f64) -> (Complex<f64>, Complex<f64>) {
        let (sin, cos, q) = half_angle(theta);
        let twice_sin = 2.0 * sin;
        (Complex::new(1.0 - twice_sin * sin, twice_sin * cos), Complex::new(q * cos, q * sin))
    }

    #[inline]
    fn phi1_phi2(theta: f64) -> (Complex<f64>, Complex<f64>) {
        let (sin, cos, q) = half_angle(theta);
        let phi1 = Complex::new(q * cos, q * sin);
        let gap =
            if theta.abs() <= std::f64::consts::PI { theta * sine_gap(theta * theta) } else { (1.0 - phi1.re) / theta };
        (phi1, Complex::new(0.5 * q * q, gap))
    }

    #[inline]
    fn psi1_psi2(theta: f64) -> Result<(Complex<f64>, Complex<f64>), GroupError> {
        theta.check_finite(0)?;
        // The f64 number TAU lies below 2 pi: up to it the pole is not reached.
        if theta.abs() > std::f64::consts::TAU {
            return Err(GroupError::FullTurn { theta_lo_rad: theta, theta_hi_rad: theta });
        }
        let h = 0.5 * theta;
        let (_, cos, q) = half_angle(theta);
        let (cot, gap) = if theta.abs() <= std::f64::consts::PI {
            let half_recip = 0.5 / q;
            (2.0 * cos * half_recip, h * bessel_gap(h * h) * half_recip)
        } else {
            let cot = cos / q;
            (cot, (1.0 - cot) / theta)
        };
        Ok((Complex::new(cot, -h), Complex::new(0.5, -gap)))
    }

    #[inline]
    fn log_psi1(unit: Complex<f64>) -> Result<(f64, Complex<f64>), GroupError> {
        let theta = Self::angle(unit)?;
        // cot(t/2) = (1 + cos t) / sin t = sin t / (1 - cos t): take the form whose sum does not cancel.
        let (num, den) = if unit.re >= 0.0 { (1.0 + unit.re, unit.im) } else { (unit.im, 1.0 - unit.re) };
        let h = 0.5 * theta;
        let cot = if den == 0.0 { 1.0 } else { theta * (0.5 * num) / den };
        Ok((theta, Complex::new(cot, -h)))
    }

    #[inline]
    fn angle(unit: Complex<f64>) -> Result<f64, GroupError> {
        let theta = unit.im.atan2(unit.re);
        // Finite cosine and sine give a finite angle; an infinite one would pass as a multiple of pi/4.
        if !(unit.re.abs() + unit.im.abs()).is_finite() {
            unit.re.check_finite(0)?;
            unit.im.check_finite(1)?;
        }
        Ok(theta)
    }

    #[inline]
    fn near_unit(z: Complex<f64>) -> Complex<f64> {
        let scale = 1.5 - 0.5 * (z.re * z.re + z.im * z.im);
        Complex::new(z.re * scale, z.im * scale)
    }

    #[inline]
    fn unit(z: Complex<f64>) -> Result<Complex<f64>, GroupError> {
        z.re.check_finite(0)?;
        z.im.check_finite(1)?;
        let largest = z.re.abs().max(z.im.abs());
        if largest == 0.0 {
            return Err(GroupError::NotARotation);
        }
        // Scaled first: the norm of subnormal or huge parts would lose digits or overflow.
        let (re, im) = (z.re / largest, z.im / largest);
        let norm = re.hypot(im);
        Ok(Complex::new(re / norm, im / norm))
    }

    #[inline]
    fn check_finite(self, index: usize) -> Result<(), GroupError> {
        if self.is_finite() { Ok(()) } else { Err(GroupError::NotFinite { index }) }
    }
}
