//! Vectors of the plane as complex numbers, and their enclosures.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up, sqrt_up};

/// `a + i b`.
pub(super) type Vector = [f64; 2];

/// A box of vectors.
pub(super) type Region = [Interval; 2];

/// `Re(conj(a) b)`, rounded.
#[inline]
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// `Im(conj(a) b)`, rounded.
#[inline]
pub(super) fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// `|a|_1`, rounded.
#[inline]
pub(super) fn norm1(a: Vector) -> f64 {
    a[0].abs() + a[1].abs()
}

/// Upper bound of `|a|`.
pub(super) fn modulus_up(a: Vector) -> f64 {
    sqrt_up(add_up(mul_up(a[0], a[0]), mul_up(a[1], a[1])))
}

/// Upper bound of `max |a|` over a box.
pub(super) fn largest_modulus(a: &Region) -> f64 {
    modulus_up([a[0].mag(), a[1].mag()])
}

/// Encloses `a b`.
pub(super) fn product(a: &Region, b: &Region) -> Region {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// Encloses `conj(a) b`.
pub(super) fn conjugate_product(a: &Region, b: &Region) -> Region {
    [a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]]
}

/// Encloses `a + b`.
pub(super) fn sum(a: &Region, b: &Region) -> Region {
    [a[0] + b[0], a[1] + b[1]]
}

/// Encloses `a - b`.
pub(super) fn difference(a: &Region, b: &Region) -> Region {
    [a[0] - b[0], a[1] - b[1]]
}

/// Encloses `Re(conj(a) b)`.
pub(super) fn inner(a: &Region, b: &Region) -> Interval {
    a[0] * b[0] + a[1] * b[1]
}

/// The point box of a vector.
pub(super) fn point(a: Vector) -> Region {
    a.map(Interval::point)
}

/// Encloses `e^{i angle}`.
pub(super) fn unit(angle: Interval) -> Region {
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}

/// The middle of a box.
pub(super) fn middle(a: &Region) -> Vector {
    [a[0].mid(), a[1].mid()]
}

/// Upper bound of the distance of a point of the box from its middle.
pub(super) fn radius(a: &Region) -> f64 {
    modulus_up([a[0].rad(), a[1].rad()])
}
