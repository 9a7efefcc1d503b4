//! `phi_k(s + i theta)` over `f64`.
//!
//! With `y = z / 2 = a + i h` and the even function `sinhc(y) = sinh(y) / y`:
//!
//! ```text
//! phi_1(z) = e^y sinhc(y),    phi_1(-z) = e^-y sinhc(y),    phi_2(z) = (phi_1(y) sinhc(y) + (sinhc(y) - 1) / y) / 2
//! ```
//!
//! `sinhc(y)` is put together from the real functions `q = sin h / h`, `G = (1 - q) / h^2`, `J = (q - cos h) / h^2` of both coordinates
//! (with `a^2` in place of `-h^2` for `a`), in which the weights `a^2 / |y|^2` and `h^2 / |y|^2` are the only quotients: nothing cancels and no
//! series in two variables is needed.

use super::ScaledCoeff;
use super::even::Even;
use super::scaled::BothSigns;
use crate::{Coeff, Complex, GroupError};

/// Below this `|y|^2` the constant and linear terms of the functions are all that `f64` sees.
const TINY: f64 = 1e-140;

/// `sinhc(y)` with its parts.
struct HalfPoint {
    a: f64,
    h: f64,
    scale: Even,
    turn: Even,
    /// `1 / |y|^2`, or 0 if that would overflow.
    recip: f64,
    /// `e^a` and `e^-a`.
    exp: (f64, f64),
    sinhc: Complex<f64>,
}

impl HalfPoint {
    #[inline]
    fn of(s: f64, theta: f64) -> Self {
        let (a, h) = (0.5 * s, 0.5 * theta);
        let (scale, turn) = (Even::hyperbolic(a), Even::circular(h));
        let (aa, hh) = (-scale.square, turn.square);
        let norm = aa + hh;
        let recip = if norm < TINY { 0.0 } else { 1.0 / norm };
        let re = scale.q * turn.q + aa * hh * recip * (turn.q * scale.bessel - scale.q * turn.bessel);
        let im = a * h * recip * (aa * scale.bessel * turn.q + hh * turn.bessel * scale.q);
        let large = scale.cos + a.abs() * scale.q;
        let small = 1.0 / large;
        let exp = if a >= 0.0 { (large, small) } else { (small, large) };
        Self { a, h, scale, turn, recip, exp, sinhc: Complex::new(re, im) }
    }

    /// `e^(i h)`.
    #[inline]
    fn unit(&self) -> Complex<f64> {
        Complex::new(self.turn.cos, self.h * self.turn.q)
    }

    #[inline]
    fn phi1(&self) -> Complex<f64> {
        let product = self.unit() * self.sinhc;
        Complex::new(self.exp.0 * product.re, self.exp.0 * product.im)
    }

    #[inline]
    fn phi1_back(&self) -> Complex<f64> {
        let product = self.unit().conj() * self.sinhc;
        Complex::new(self.exp.1 * product.re, self.exp.1 * product.im)
    }

    #[inline]
    fn phi2(&self) -> Complex<f64> {
        let Self { a, h, ref scale, ref turn, recip, sinhc, .. } = *self;
        if recip == 0.0 {
            return Complex::new(0.5 + a / 3.0, h / 3.0);
        }
        if a < -1.0 {
            // The two terms below cancel where e^a is small; phi_2 = (phi_1 - 1) / z does not.
            let phi1 = self.phi1();
            return Complex::new(phi1.re - 1.0, phi1.im) * Complex::new(0.5 * a * recip, -0.5 * h * recip);
        }
        let (aa, hh) = (-scale.square, turn.square);
        // (e^y - 1) / y, the difference without cancellation.
        let grown = a * scale.q + aa * (scale.gap + scale.bessel);
        let rise = Complex::new(grown * turn.cos - hh * (turn.gap + turn.bessel), self.exp.0 * h * turn.q);
        let phi1_y = rise * Complex::new(a * recip, -h * recip);
        // (sinhc(y) - 1) / y, likewise.
        let rest = aa * scale.gap - hh * turn.gap - aa * hh * scale.gap * turn.gap
            + aa * hh * recip * (turn.q * scale.bessel - scale.q * turn.bessel);
        let bend = Complex::new(rest, sinhc.im) * Complex::new(a * recip, -h * recip);
        let product = phi1_y * sinhc;
        Complex::new(0.5 * (product.re + bend.re), 0.5 * (product.im + bend.im))
    }
}

#[inline]
fn reciprocal(z: Complex<f64>) -> Complex<f64> {
    let scale = 1.0 / (z.re * z.re + z.im * z.im);
    Complex::new(z.re * scale, -z.im * scale)
}

#[inline]
fn check(s: f64, theta: f64) -> Result<(), GroupError> {
    theta.check_finite(0)?;
    s.check_finite(1)?;
    // The f64 number TAU lies below 2 pi: up to it the pole is not reached.
    if theta.abs() > std::f64::consts::TAU {
        return Err(GroupError::FullTurn { theta_lo_rad: theta, theta_hi_rad: theta });
    }
    Ok(())
}

impl ScaledCoeff for f64 {
    #[inline]
    fn scaled_phi1(s: f64, theta: f64) -> BothSigns<f64> {
        let half = HalfPoint::of(s, theta);
        (half.phi1(), half.phi1_back())
    }

    #[inline]
    fn scaled_phi1_phi2(s: f64, theta: f64) -> (Complex<f64>, Complex<f64>) {
        let half = HalfPoint::of(s, theta);
        (half.phi1(), half.phi2())
    }

    #[inline]
    fn scaled_psi1(s: f64, theta: f64) -> Result<BothSigns<f64>, GroupError> {
        check(s, theta)?;
        let half = HalfPoint::of(s, theta);
        Ok((reciprocal(half.phi1()), reciprocal(half.phi1_back())))
    }

    #[inline]
    fn scaled_psi1_psi2(s: f64, theta: f64) -> Result<(Complex<f64>, Complex<f64>), GroupError> {
        check(s, theta)?;
        let half = HalfPoint::of(s, theta);
        let psi1 = reciprocal(half.phi1());
        Ok((psi1, half.phi2() * psi1))
    }
}
