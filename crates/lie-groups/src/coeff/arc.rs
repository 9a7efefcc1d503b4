//! Sets of rotations as arcs of the unit circle: ranges of angles.

use scalars::Interval;

use super::Coeff;
use crate::{Complex, GroupError, Turn};

/// The rotations by the angles of `arc`.
pub(super) fn turn(arc: Interval) -> Turn<Interval> {
    if arc == Interval::ZERO {
        return Turn::new(Complex::new(Interval::ONE, Interval::ZERO), arc);
    }
    let (sin, cos) = arc.sin_cos();
    Turn::new(Complex::new(cos, sin), arc)
}

/// Products of the rotations of two arcs: angles add up. The sum is brought back by whole turns to a middle in `[-pi, pi]`.
pub(super) fn compose(a: Interval, b: Interval) -> Turn<Interval> {
    turn(wrapped(a + b))
}

/// The arc moved by whole turns so that its middle lies in `[-pi, pi]` (up to rounding); unchanged if it already does.
fn wrapped(arc: Interval) -> Interval {
    let middle = arc.mid();
    if middle.abs() <= std::f64::consts::PI || !arc.is_bounded() {
        return arc;
    }
    let turns = (middle / std::f64::consts::TAU).round();
    arc - Interval::PI.scale(2.0 * turns)
}

/// The angles of an arc as numbers in `(-pi, pi)`.
pub(super) fn principal(arc: Interval) -> Result<Interval, GroupError> {
    arc.check_finite(0)?;
    let theta = wrapped(arc);
    // The f64 number PI lies below pi: up to it the half turn is not reached.
    if theta.mag() <= std::f64::consts::PI {
        Ok(theta)
    } else {
        Err(GroupError::HalfTurn { theta_lo_rad: theta.lo(), theta_hi_rad: theta.hi() })
    }
}

/// The rotations whose cosine and sine lie in the box `z`, which must meet the unit circle.
pub(super) fn in_box(z: Complex<Interval>) -> Result<Turn<Interval>, GroupError> {
    z.re.check_finite(0)?;
    z.im.check_finite(1)?;
    let across_half_turn = z.re.lo() <= -1.0 && z.im.contains(0.0);
    let across_zero = z.re.hi() >= 1.0 && z.im.contains(0.0);
    let arc = match (across_half_turn, across_zero) {
        (false, _) => angles(z),
        (true, false) => Interval::PI + angles(Complex::new(-z.re, -z.im)),
        (true, true) => Interval::PI.hull(-Interval::PI),
    };
    // What the arc says of cosine and sine cuts off the part of the box far from the circle.
    let unit = turn(arc).unit();
    let unit = Complex::new(unit.re.intersection(z.re), unit.im.intersection(z.im));
    if unit.re.is_empty() || unit.im.is_empty() {
        return Err(GroupError::NotARotation);
    }
    Ok(Turn::new(unit, arc))
}

/// Principal angles of the unit complex numbers in a box without -1.
///
/// In one quadrant both `acos` of the real part and `asin` of the imaginary part give the angle, each well conditioned where the other is
/// not. The answer is the hull over the quadrants of their intersection; no point of the box off the circle widens it.
fn angles(z: Complex<Interval>) -> Interval {
    upper_half(z.re, z.im).hull(-upper_half(z.re, -z.im))
}

/// Angles in `[0, pi]` of the unit complex numbers in the box.
fn upper_half(cos: Interval, sin: Interval) -> Interval {
    right_quadrant(cos, sin).hull(Interval::PI - right_quadrant(-cos, sin))
}

/// Angles in `[0, pi/2]` of the unit complex numbers in the box.
fn right_quadrant(cos: Interval, sin: Interval) -> Interval {
    let unit = Interval::ZERO.hull(Interval::ONE);
    let (cos, sin) = (cos.intersection(unit), sin.intersection(unit));
    if cos.is_empty() || sin.is_empty() {
        return Interval::EMPTY;
    }
    cos.acos().intersection(sin.asin())
}
