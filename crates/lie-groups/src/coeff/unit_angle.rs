//! The angles of the unit complex numbers in a box.

use scalars::Interval;

use super::Coeff;
use crate::{Complex, GroupError};

/// Principal angles of `{ z : |z| = 1, Re z in unit.re, Im z in unit.im }`.
///
/// In one quadrant both `acos` of the real part and `asin` of the imaginary part give the angle, each well conditioned where the other is not. The
/// answer is the hull over the quadrants of their intersection; no point of the box off the circle widens it.
pub(super) fn unit_angle(unit: Complex<Interval>) -> Result<Interval, GroupError> {
    unit.re.check_finite(0)?;
    unit.im.check_finite(1)?;
    let (cos, sin) = (unit.re, unit.im);
    if cos.lo() <= -1.0 && sin.contains(0.0) {
        return Err(GroupError::HalfTurn { cos_lo: cos.lo(), cos_hi: cos.hi(), sin_lo: sin.lo(), sin_hi: sin.hi() });
    }
    let theta = upper_half(cos, sin).hull(-upper_half(cos, -sin));
    if theta.is_empty() { Err(GroupError::NotARotation) } else { Ok(theta) }
}

/// Angles in `[0, pi]` of the unit complex numbers in the box.
fn upper_half(cos: Interval, sin: Interval) -> Interval {
    right_quadrant(cos, sin).hull(Interval::PI - right_quadrant(-cos, sin))
}

/// Angles in `[0, pi/2]` of the unit complex numbers in the box.
fn right_quadrant(cos: Interval, sin: Interval) -> Interval {
    if cos.hi() < 0.0 || sin.hi() < 0.0 {
        return Interval::EMPTY;
    }
    let unit = Interval::ZERO.hull(Interval::ONE);
    cos.intersection(unit).acos().intersection(sin.intersection(unit).asin())
}
