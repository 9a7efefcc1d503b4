//! Coefficient functions over intervals: rigorous ranges over boxes of angles.
//!
//! Negative angles give conjugates. On `0 <= t <= 4.49` (`t < 2 pi` for `psi`) every real part falls, and every imaginary part rises up to one known
//! angle and falls after it, so the range over a box is read off the values at its two ends. Farther out the natural
//! forms, which divide by an angle above 4.49, are tight enough.
//! The values at the ends are built from the half angle, as those over `f64`, in interval arithmetic.

use scalars::{Interval, Scalar};

use super::{Coeff, arc};
use crate::{Complex, GroupError, Turn};

/// A coefficient function of `theta`, described on `t = |theta|`.
struct Curve {
    /// Value at one angle `0 <= t <= near`.
    at: fn(f64) -> Complex<Interval>,
    /// Up to here the real part falls and the imaginary part has one peak.
    near: f64,
    /// The peak of the imaginary part.
    peak: Peak,
    /// Range over angles `t >= near`.
    far: fn(Interval) -> Complex<Interval>,
}

/// Where a function that rises and then falls turns: an angle in `[from, to]`, the value there at most `value`.
struct Peak {
    from: f64,
    to: f64,
    value: f64,
}

/// `sin t / t` falls up to its first trough at `tan t = t`, 4.493.., the other parts of `phi_1` and `phi_2` up to `2 pi`, once past their peaks.
const NEAR: f64 = 4.49;

const PHI1: Curve = Curve {
    at: phi1_at,
    near: NEAR,
    // (1 - cos t) / t turns at tan(t/2) = t, 2.33112237041442261.., where it is 0.724611353776708475..
    peak: Peak { from: 2.331122370414422, to: 2.331122370414423, value: 0.7246113537767085 },
    far: phi1_far,
};

const PHI2: Curve = Curve {
    at: phi2_at,
    near: NEAR,
    // (t - sin t) / t^2 turns at pi, where it is 1 / pi; FRAC_1_PI lies above it.
    peak: Peak { from: std::f64::consts::PI, to: std::f64::consts::PI.next_up(), value: std::f64::consts::FRAC_1_PI },
    far: phi2_far,
};

/// `psi_1` and `psi_2` fall in both parts all the way to the pole, beyond which they are not asked for.
const PSI1: Curve = Curve { at: psi1_at, near: f64::INFINITY, peak: FALLS, far: nowhere };
const PSI2: Curve = Curve { at: psi2_at, near: f64::INFINITY, peak: FALLS, far: nowhere };
const FALLS: Peak = Peak { from: 0.0, to: 0.0, value: f64::INFINITY };

fn nowhere(_t: Interval) -> Complex<Interval> {
    Complex::new(Interval::ENTIRE, Interval::ENTIRE)
}

fn hull(a: Complex<Interval>, b: Complex<Interval>) -> Complex<Interval> {
    Complex::new(a.re.hull(b.re), a.im.hull(b.im))
}

impl Curve {
    /// Range over any box of angles; empty for the empty one.
    fn range(&self, theta: Interval) -> Complex<Interval> {
        if theta.is_empty() {
            Complex::new(theta, theta)
        } else if theta.lo() >= 0.0 {
            self.positive(theta)
        } else if theta.hi() <= 0.0 {
            self.positive(-theta).conj()
        } else {
            let left = self.positive(Interval::lit(0.0, -theta.lo()));
            hull(left.conj(), self.positive(Interval::lit(0.0, theta.hi())))
        }
    }

    /// Range over a box of angles `t >= 0`.
    fn positive(&self, t: Interval) -> Complex<Interval> {
        if t.lo() >= self.near {
            return (self.far)(t);
        }
        let (lo, hi) = (t.lo(), t.hi().min(self.near));
        let mut range = (self.at)(lo);
        if hi > lo {
            range = hull(range, (self.at)(hi));
        }
        if lo < self.peak.to && hi > self.peak.from {
            range.im = range.im.hull(Interval::point(self.peak.value));
        }
        if t.hi() > self.near {
            range = hull(range, (self.far)(Interval::lit(self.near, t.hi())));
        }
        range
    }
}

/// `(sin h, cos h, sin h / h)` at `h = t / 2 > 0`.
fn half_angle(t: f64) -> (Interval, Interval, Interval) {
    let h = Interval::point(t).scale(0.5);
    let (sin, cos) = h.sin_cos();
    // 1 - h^2/6 <= sin h / h <= 1, and h^2 < 2^-54 in the first case.
    let q = if t < f64::EPSILON.sqrt() { Interval::lit(1.0 - 0.5 * f64::EPSILON, 1.0) } else { sin / h };
    (sin, cos, q)
}

/// Up to this angle the two parts that cancel near 0 take their series; above it the closed forms lose less than a digit.
const SERIES: f64 = 2.0;

/// `1 - x/d_0 (1 - x/d_1 (..))` for `0 <= x <= d_0`: an alternating series of falling terms, so the part left out, as any
/// of its brackets, lies in `[0, 1]`.
fn alternating(x: Interval, divisors: &[f64]) -> Interval {
    let unit = Interval::ZERO.hull(Interval::ONE);
    divisors.iter().rev().fold(unit, |inner, &d| Interval::ONE - x / Interval::point(d) * inner)
}

fn phi1_at(t: f64) -> Complex<Interval> {
    if t == 0.0 {
        return Complex::new(Interval::ONE, Interval::ZERO);
    }
    let (sin, cos, q) = half_angle(t);
    Complex::new(q * cos, q * sin)
}

fn phi1_far(t: Interval) -> Complex<Interval> {
    let h = t.scale(0.5);
    Complex::new(t.sin() / t, h.sin().sqr() / h)
}

fn phi2_at(t: f64) -> Complex<Interval> {
    // t - sin t = t^3 / 6 (1 - t^2/20 (1 - t^2/42 (..))), divisors (2j + 4)(2j + 5).
    const DIVISORS: [f64; 11] = [20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0, 342.0, 420.0, 506.0, 600.0];
    if t == 0.0 {
        return Complex::new(Interval::point(0.5), Interval::ZERO);
    }
    let (_, cos, q) = half_angle(t);
    let angle = Interval::point(t);
    let gap = if t <= SERIES {
        angle * alternating(angle.sqr(), &DIVISORS) / Interval::point(6.0)
    } else {
        (Interval::ONE - q * cos) / angle
    };
    Complex::new(q.sqr().scale(0.5), gap)
}

fn phi2_far(t: Interval) -> Complex<Interval> {
    let h = t.scale(0.5);
    Complex::new((h.sin() / h).sqr().scale(0.5), (Interval::ONE - t.sin() / t) / t)
}

fn psi1_at(t: f64) -> Complex<Interval> {
    let imaginary = Interval::point(t).scale(-0.5);
    if t == 0.0 {
        return Complex::new(Interval::ONE, imaginary);
    }
    let (_, cos, q) = half_angle(t);
    Complex::new(cos / q, imaginary)
}

fn psi2_at(t: f64) -> Complex<Interval> {
    // sin h - h cos h = h^3 / 3 (1 - h^2/10 (1 - h^2/28 (..))), divisors (2j + 2)(2j + 5).
    const DIVISORS: [f64; 9] = [10.0, 28.0, 54.0, 88.0, 130.0, 180.0, 238.0, 304.0, 378.0];
    let half = Interval::point(0.5);
    if t == 0.0 {
        return Complex::new(half, Interval::ZERO);
    }
    let (_, cos, q) = half_angle(t);
    let angle = Interval::point(t);
    let gap = if t <= SERIES {
        angle * alternating(angle.sqr().scale(0.25), &DIVISORS) / q.scale(12.0)
    } else {
        (Interval::ONE - cos / q) / angle
    };
    Complex::new(half, -gap)
}

impl Coeff for Interval {
    type Arc = Interval;

    fn exp_phi1(theta: Interval) -> (Turn<Interval>, Complex<Interval>) {
        (arc::turn(theta), PHI1.range(theta))
    }

    fn turn(theta: Interval) -> Turn<Interval> {
        arc::turn(theta)
    }

    fn phi1_phi2(theta: Interval) -> (Complex<Interval>, Complex<Interval>) {
        (PHI1.range(theta), PHI2.range(theta))
    }

    fn psi1_psi2(theta: Interval) -> Result<(Complex<Interval>, Complex<Interval>), GroupError> {
        theta.check_finite(0)?;
        // The f64 number TAU lies below 2 pi: up to it the pole is not reached.
        if theta.mag() > std::f64::consts::TAU {
            return Err(GroupError::FullTurn { theta_lo_rad: theta.lo(), theta_hi_rad: theta.hi() });
        }
        Ok((PSI1.range(theta), PSI2.range(theta)))
    }

    fn log_psi1(turn: &Turn<Interval>) -> Result<(Interval, Complex<Interval>), GroupError> {
        let theta = arc::principal(turn.arc())?;
        Ok((theta, PSI1.range(theta)))
    }

    fn angle(turn: &Turn<Interval>) -> Result<Interval, GroupError> {
        arc::principal(turn.arc())
    }

    fn product(a: &Turn<Interval>, b: &Turn<Interval>) -> Turn<Interval> {
        arc::compose(a.arc(), b.arc())
    }

    fn reverse(turn: &Turn<Interval>) -> Turn<Interval> {
        Turn::new(turn.unit().conj(), -turn.arc())
    }

    fn direction(z: Complex<Interval>) -> Result<Turn<Interval>, GroupError> {
        arc::in_box(z)
    }

    fn check_finite(self, index: usize) -> Result<(), GroupError> {
        if self.is_bounded() { Ok(()) } else { Err(GroupError::NotFinite { index }) }
    }

    fn ends(self) -> (f64, f64) {
        (self.lo(), self.hi())
    }
}
