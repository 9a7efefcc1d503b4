//! Coefficient functions over intervals: rigorous ranges over boxes of angles.
//!
//! On `[0, 4.49]` (`[0, 2 pi)` for `psi`) every real and imaginary part rises up to one known angle and falls after it, so its range over a
//! box is read off its values at the two ends. Farther out the natural forms, which divide by an angle above 4.49, are tight enough.
//! Negative angles follow by symmetry: real parts are even, imaginary parts odd.
//! The values at the ends use the half-angle formulas of the `f64` version in interval arithmetic.

use scalars::{Interval, Scalar};

use super::Coeff;
use super::unit_angle::unit_angle;
use crate::{Complex, GroupError};

/// Up to here `sin t / t` falls (its first trough is at `tan t = t`, 4.493..).
const NEAR: f64 = 4.49;

/// A function on `[0, NEAR]` that rises up to an angle in `[from, to]`, where it is at most `value`, and falls after it.
struct Peak {
    from: f64,
    to: f64,
    value: f64,
}

/// Falls from the start.
const FALLS: Peak = Peak { from: 0.0, to: 0.0, value: f64::INFINITY };
/// `(1 - cos t) / t`: derivative zero at `tan(t/2) = t`, 2.33112237041442261.., value 0.724611353776708475...
const VERSINE: Peak = Peak { from: 2.331122370414422, to: 2.331122370414423, value: 0.7246113537767085 };
/// `(t - sin t) / t^2`: peak `1 / pi` at `pi`.
const SINE_GAP: Peak =
    Peak { from: std::f64::consts::PI, to: std::f64::consts::PI.next_up(), value: std::f64::consts::FRAC_1_PI };

impl Peak {
    /// Range over `[lo, hi]` of the function with the given values at `lo` and `hi`.
    fn range(&self, lo: f64, hi: f64, at_lo: Interval, at_hi: Interval) -> Interval {
        let ends = at_lo.hull(at_hi);
        if hi <= self.from || lo >= self.to { ends } else { ends.hull(Interval::point(self.value)) }
    }
}

/// Divisors `(2j + 4)(2j + 5)`: `t - sin t = t^3 / 6 (1 - t^2/20 (1 - t^2/42 (..)))`.
const SINE_GAP_DIVISORS: [f64; 11] = [20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0, 342.0, 420.0, 506.0, 600.0];

/// Divisors `(2j + 2)(2j + 5)`: `sin h / h - cos h = h^2 / 3 (1 - h^2/10 (1 - h^2/28 (..)))`.
const BESSEL_GAP_DIVISORS: [f64; 9] = [10.0, 28.0, 54.0, 88.0, 130.0, 180.0, 238.0, 304.0, 378.0];

/// Angles up to here take the series, above it the closed forms, which then lose less than a digit.
const SERIES: f64 = 2.0;

/// `1 - x/d_0 (1 - x/d_1 (..))` for `0 <= x <= d_0`: an alternating series of falling terms, so the part left out, as any
/// of its brackets, lies in `[0, 1]`.
fn alternating(x: Interval, divisors: &[f64]) -> Interval {
    let unit = Interval::ZERO.hull(Interval::ONE);
    divisors.iter().rev().fold(unit, |inner, &d| Interval::ONE - x / Interval::point(d) * inner)
}

/// `(sin h, cos h, sin h / h)` at `h = t / 2 > 0`.
fn half_angle(t: f64) -> (Interval, Interval, Interval) {
    let h = Interval::point(t).scale(0.5);
    let (sin, cos) = h.sin_cos();
    let q = if t < f64::EPSILON.sqrt() {
        // 1 - h^2/6 <= sin h / h <= 1 with h^2 < 2^-54.
        Interval::lit(1.0 - 0.5 * f64::EPSILON, 1.0)
    } else {
        sin / h
    };
    (sin, cos, q)
}

/// Real and imaginary parts of `phi_1(i t)` and `phi_2(i t)`: values or ranges.
type Phi = [Interval; 4];

/// Values at one angle `0 <= t <= NEAR`.
fn phi_at(t: f64) -> Phi {
    if t == 0.0 {
        return [Interval::ONE, Interval::ZERO, Interval::point(0.5), Interval::ZERO];
    }
    let (sin, cos, q) = half_angle(t);
    let sinc = q * cos;
    let angle = Interval::point(t);
    let gap = if t <= SERIES {
        angle * alternating(angle.sqr(), &SINE_GAP_DIVISORS) / Interval::point(6.0)
    } else {
        (Interval::ONE - sinc) / angle
    };
    [sinc, q * sin, q.sqr().scale(0.5), gap]
}

/// Ranges over angles `t >= NEAR`.
fn phi_far(t: Interval) -> Phi {
    let h = t.scale(0.5);
    let half_sin = h.sin();
    let sinc = t.sin() / t;
    [sinc, half_sin.sqr() / h, (half_sin / h).sqr().scale(0.5), (Interval::ONE - sinc) / t]
}

/// Ranges over `0 <= t`.
fn phi_positive(t: Interval) -> Phi {
    if t.lo() >= NEAR {
        return phi_far(t);
    }
    let (lo, hi) = (t.lo(), t.hi().min(NEAR));
    let at_lo = phi_at(lo);
    let at_hi = if lo == hi { at_lo } else { phi_at(hi) };
    let near = std::array::from_fn(|k| [FALLS, VERSINE, FALLS, SINE_GAP][k].range(lo, hi, at_lo[k], at_hi[k]));
    if t.hi() <= NEAR {
        return near;
    }
    let far = phi_far(Interval::lit(NEAR, t.hi()));
    std::array::from_fn(|k| near[k].hull(far[k]))
}

/// Range over any angles of functions given over `t >= 0`, the even ones and odd ones taking turns.
fn by_symmetry<const K: usize>(t: Interval, positive: impl Fn(Interval) -> [Interval; K]) -> [Interval; K] {
    let mirror = |values: [Interval; K]| std::array::from_fn(|k| if k % 2 == 0 { values[k] } else { -values[k] });
    if t.is_empty() {
        [Interval::EMPTY; K]
    } else if t.lo() >= 0.0 {
        positive(t)
    } else if t.hi() <= 0.0 {
        mirror(positive(-t))
    } else {
        let right = positive(Interval::lit(0.0, t.hi()));
        let left = mirror(positive(Interval::lit(0.0, -t.lo())));
        std::array::from_fn(|k| left[k].hull(right[k]))
    }
}

/// `(t/2) cot(t/2)` and `(1 - (t/2) cot(t/2)) / t` at `0 <= t < 2 pi`.
fn psi_at(t: f64) -> [Interval; 2] {
    if t == 0.0 {
        return [Interval::ONE, Interval::ZERO];
    }
    let (_, cos, q) = half_angle(t);
    let cot = cos / q;
    let angle = Interval::point(t);
    let gap = if t <= SERIES {
        angle * alternating(angle.sqr().scale(0.25), &BESSEL_GAP_DIVISORS) / q.scale(12.0)
    } else {
        (Interval::ONE - cot) / angle
    };
    [cot, gap]
}

/// Ranges over `0 <= t < 2 pi`, where the first function falls and the second one rises.
fn psi_positive(t: Interval) -> [Interval; 2] {
    let at_lo = psi_at(t.lo());
    let at_hi = if t.lo() == t.hi() { at_lo } else { psi_at(t.hi()) };
    std::array::from_fn(|k| at_lo[k].hull(at_hi[k]))
}

impl Coeff for Interval {
    fn exp_phi1(theta: Interval) -> (Complex<Interval>, Complex<Interval>) {
        let [sinc, versine, ..] = by_symmetry(theta, phi_positive);
        let unit = if theta == Self::ZERO { Complex::new(Self::ONE, Self::ZERO) } else { Self::cis(theta) };
        (unit, Complex::new(sinc, versine))
    }

    fn phi1_phi2(theta: Interval) -> (Complex<Interval>, Complex<Interval>) {
        let [sinc, versine, half, gap] = by_symmetry(theta, phi_positive);
        (Complex::new(sinc, versine), Complex::new(half, gap))
    }

    fn psi1_psi2(theta: Interval) -> Result<(Complex<Interval>, Complex<Interval>), GroupError> {
        theta.check_finite(0)?;
        // The f64 number TAU lies below 2 pi: up to it the pole is not reached.
        if theta.mag() > std::f64::consts::TAU {
            return Err(GroupError::FullTurn { theta_lo_rad: theta.lo(), theta_hi_rad: theta.hi() });
        }
        let [cot, gap] = by_symmetry(theta, psi_positive);
        Ok((Complex::new(cot, theta.scale(-0.5)), Complex::new(Interval::point(0.5), -gap)))
    }

    fn log_psi1(unit: Complex<Interval>) -> Result<(Interval, Complex<Interval>), GroupError> {
        let theta = unit_angle(unit)?;
        let [cot, _] = by_symmetry(theta, psi_positive);
        Ok((theta, Complex::new(cot, theta.scale(-0.5))))
    }

    fn angle(unit: Complex<Interval>) -> Result<Interval, GroupError> {
        unit_angle(unit)
    }

    fn near_unit(z: Complex<Interval>) -> Complex<Interval> {
        let unit = Interval::lit(-1.0, 1.0);
        Complex::new(z.re.intersection(unit), z.im.intersection(unit))
    }

    fn unit(z: Complex<Interval>) -> Result<Complex<Interval>, GroupError> {
        z.re.check_finite(0)?;
        z.im.check_finite(1)?;
        if (z.re.sqr() + z.im.sqr()).contains(1.0) { Ok(Self::near_unit(z)) } else { Err(GroupError::NotARotation) }
    }

    fn check_finite(self, index: usize) -> Result<(), GroupError> {
        if self.is_bounded() { Ok(()) } else { Err(GroupError::NotFinite { index }) }
    }
}
