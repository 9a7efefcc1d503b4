//! `phi_k(s + i theta)` over intervals: rigorous ranges over boxes.
//!
//! A box is cut into pieces of half-width 1/4 at most; on each the centred form
//!
//! ```text
//! f(z) in f(z0) + f'([z]) ([z] - z0)
//! ```
//!
//! is evaluated. The derivatives of `phi_k(z) = int_0^1 e^(t z) (1 - t)^(k-1) / (k-1)! dt` are bounded by
//! `|phi_k^(m)| <= e^max(0, s) m! / (m + k)!`, so `phi_k'([z])` is the value at the centre and a ball around it; `phi_k' = phi_k - k phi_(k+1)`.
//! `psi_1' = -phi_1' psi_1^2` and `psi_2' = psi_1' phi_2 + psi_1 phi_2'` follow by the product rule.

use scalars::{Interval, Scalar};

use super::ScaledCoeff;
use super::scaled::BothSigns;
use crate::{Coeff, Complex, GroupError};

type Range = Complex<Interval>;

const ENTIRE: Range = Complex { re: Interval::ENTIRE, im: Interval::ENTIRE };
const EMPTY: Range = Complex { re: Interval::EMPTY, im: Interval::EMPTY };

/// Half-width of a piece, and the greatest number of pieces a side.
const PIECE: f64 = 0.25;
const MOST_PIECES: f64 = 16.0;

/// Terms of the series; for `|z| <= 1` the rest is below `1.1 / 21!`.
const TERMS: usize = 18;

fn add(a: Range, b: Range) -> Range {
    Complex::new(a.re + b.re, a.im + b.im)
}

fn scaled(a: Range, k: f64) -> Range {
    Complex::new(a.re.scale(k), a.im.scale(k))
}

fn hull(a: Range, b: Range) -> Range {
    Complex::new(a.re.hull(b.re), a.im.hull(b.im))
}

fn inflated(a: Range, radius: f64) -> Range {
    Complex::new(a.re.inflate(radius), a.im.inflate(radius))
}

/// `a / b`; the plane if `b` can be 0.
fn quotient(a: Range, b: Range) -> Range {
    let norm = b.re.sqr() + b.im.sqr();
    let product = a * b.conj();
    Complex::new(product.re / norm, product.im / norm)
}

/// `phi_1, phi_2, phi_3` at one point.
fn at_point(s: f64, theta: f64) -> [Range; 3] {
    let z = Complex::new(Interval::point(s), Interval::point(theta));
    let one = Interval::ONE;
    if s * s + theta * theta <= 1.0 {
        // phi_3 = (1 + z/4 (1 + z/5 (..))) / 3!; with |z| <= 1 every bracket is below 1.1 in modulus from z/22 on.
        let tail = Interval::lit(-1.1, 1.1);
        let mut sum = Complex::new(tail, tail);
        for j in (0..TERMS).rev() {
            let factor = one / Interval::point((j + 4) as f64);
            let product = sum * z;
            sum = Complex::new((product.re * factor).add_f64(1.0), product.im * factor);
        }
        let sixth = Interval::ratio(1, 6);
        let phi3 = Complex::new(sum.re * sixth, sum.im * sixth);
        let product = phi3 * z;
        let phi2 = Complex::new(product.re.add_f64(0.5), product.im);
        let product = phi2 * z;
        return [Complex::new(product.re.add_f64(1.0), product.im), phi2, phi3];
    }
    let (sin, cos) = z.im.sin_cos();
    let grown = z.re.exp();
    let phi1 = quotient(Complex::new((grown * cos).add_f64(-1.0), grown * sin), z);
    let phi2 = quotient(Complex::new(phi1.re.add_f64(-1.0), phi1.im), z);
    let phi3 = quotient(Complex::new(phi2.re.add_f64(-0.5), phi2.im), z);
    [phi1, phi2, phi3]
}

/// A piece of a box: its centre, the box around it, and what bounds the functions there.
struct Piece {
    offset: Range,
    /// `phi_1` and `phi_2` at the centre.
    center: [Range; 2],
    /// `phi_1'` and `phi_2'` over the piece.
    slope: [Range; 2],
}

impl Piece {
    fn new(s: Interval, theta: Interval) -> Self {
        let (s0, theta0) = (s.mid(), theta.mid());
        let offset = Complex::new(s.add_f64(-s0), theta.add_f64(-theta0));
        let [phi1, phi2, phi3] = at_point(s0, theta0);
        if offset == (Complex { re: Interval::ZERO, im: Interval::ZERO }) {
            return Self { offset, center: [phi1, phi2], slope: [EMPTY, EMPTY] };
        }
        let growth = Interval::ZERO.hull(s).exp();
        let radius = (offset.re.abs().sqr() + offset.im.abs().sqr()).sqrt();
        // |phi_1''| <= e^max(0, s) / 3, |phi_2''| <= e^max(0, s) / 12.
        let ball = growth * radius;
        let slope1 = inflated(add(phi1, scaled(phi2, -1.0)), (ball / Interval::point(3.0)).hi());
        let slope2 = inflated(add(phi2, scaled(phi3, -2.0)), (ball / Interval::point(12.0)).hi());
        Self { offset, center: [phi1, phi2], slope: [slope1, slope2] }
    }

    fn is_point(&self) -> bool {
        self.slope[0].re.is_empty()
    }

    /// `f(z0) + f'([z]) ([z] - z0)`.
    fn centered(&self, center: Range, slope: Range) -> Range {
        if self.is_point() { center } else { add(center, slope * self.offset) }
    }

    fn phi(&self) -> [Range; 2] {
        [self.centered(self.center[0], self.slope[0]), self.centered(self.center[1], self.slope[1])]
    }

    fn psi(&self) -> [Range; 2] {
        let one = Complex::new(Interval::ONE, Interval::ZERO);
        let psi1 = quotient(one, self.center[0]);
        let psi2 = psi1 * self.center[1];
        if self.is_point() {
            return [psi1, psi2];
        }
        let [phi1_over, phi2_over] = self.phi();
        let psi1_over = quotient(one, phi1_over);
        let slope1 = scaled(self.slope[0] * psi1_over * psi1_over, -1.0);
        let slope2 = add(slope1 * phi2_over, psi1_over * self.slope[1]);
        [self.centered(psi1, slope1), self.centered(psi2, slope2)]
    }
}

/// The parts of an interval, `PIECE` wide to either side unless that were too many.
fn parts(x: Interval) -> impl Iterator<Item = Interval> {
    let count = (x.rad() / PIECE).ceil().clamp(1.0, MOST_PIECES);
    let (lo, hi) = (x.lo(), x.hi());
    let cut = move |k: f64| {
        if k <= 0.0 {
            lo
        } else if k >= count {
            hi
        } else {
            (lo + (hi - lo) * (k / count)).clamp(lo, hi)
        }
    };
    (0..count as usize).map(move |k| Interval::lit(cut(k as f64), cut(k as f64 + 1.0)))
}

/// Hull of two functions over the pieces of a box.
fn over(s: Interval, theta: Interval, f: impl Fn(&Piece) -> [Range; 2]) -> [Range; 2] {
    if s.is_empty() || theta.is_empty() {
        return [EMPTY; 2];
    }
    if !(s.is_bounded() && theta.is_bounded() && (s.hi() - s.lo()).is_finite() && (theta.hi() - theta.lo()).is_finite())
    {
        return [ENTIRE; 2];
    }
    let mut ranges = [EMPTY; 2];
    for s_part in parts(s) {
        for theta_part in parts(theta) {
            let found = f(&Piece::new(s_part, theta_part));
            ranges = [hull(ranges[0], found[0]), hull(ranges[1], found[1])];
        }
    }
    ranges
}

/// `phi_1` and `phi_2`, cut to `|phi_k| <= e^max(0, s) / k!`.
fn phi(s: Interval, theta: Interval) -> [Range; 2] {
    let [phi1, phi2] = over(s, theta, Piece::phi);
    let growth = Interval::ZERO.hull(s).exp().hi();
    let disc = Interval::lit(-growth, growth);
    let cut = |z: Range, disc: Interval| {
        if z.re.is_empty() { z } else { Complex::new(z.re.intersection(disc), z.im.intersection(disc)) }
    };
    [cut(phi1, disc), cut(phi2, disc.scale(0.5))]
}

fn check(s: Interval, theta: Interval) -> Result<(), GroupError> {
    theta.check_finite(0)?;
    s.check_finite(1)?;
    if theta.mag() > std::f64::consts::TAU {
        return Err(GroupError::FullTurn { theta_lo_rad: theta.lo(), theta_hi_rad: theta.hi() });
    }
    Ok(())
}

impl ScaledCoeff for Interval {
    fn scaled_phi1(s: Interval, theta: Interval) -> BothSigns<Interval> {
        (phi(s, theta)[0], phi(-s, -theta)[0])
    }

    fn scaled_phi1_phi2(s: Interval, theta: Interval) -> (Range, Range) {
        phi(s, theta).into()
    }

    fn scaled_psi1(s: Interval, theta: Interval) -> Result<BothSigns<Interval>, GroupError> {
        check(s, theta)?;
        Ok((over(s, theta, Piece::psi)[0], over(-s, -theta, Piece::psi)[0]))
    }

    fn scaled_psi1_psi2(s: Interval, theta: Interval) -> Result<(Range, Range), GroupError> {
        check(s, theta)?;
        Ok(over(s, theta, Piece::psi).into())
    }
}
