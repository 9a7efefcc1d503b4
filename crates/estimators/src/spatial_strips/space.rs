//! Vectors and matrices of space and their enclosures, and small rotations.

use lie_groups::{Enclose, LieGroup, SO3};
use nalgebra::{SMatrix, SVector};
use scalars::Interval;
use scalars::rounding::{add_up, mul_up, sqrt_up};

use crate::EstimatorError;

pub(super) type Vector = [f64; 3];

/// A box of vectors.
pub(super) type Region = [Interval; 3];

/// Row by row.
pub(super) type Matrix = [[f64; 3]; 3];

/// An interval matrix, row by row.
pub(super) type Block = [[Interval; 3]; 3];

/// The longest rotation vectors that are followed.
pub(super) const LONGEST: f64 = 3.5;

/// Holds a rotation vector of every rotation.
pub(super) fn any_turn() -> Region {
    [Interval::PI.hull(-Interval::PI); 3]
}

/// The axes of space.
pub(super) const AXES: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// `a x b`, rounded.
#[inline]
pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `|a|_1`, rounded.
#[inline]
pub(super) fn norm1(a: Vector) -> f64 {
    a[0].abs() + a[1].abs() + a[2].abs()
}

/// Upper bound of `|a|`.
pub(super) fn length_up(a: Vector) -> f64 {
    sqrt_up(a.iter().fold(0.0, |sum, x| add_up(sum, mul_up(*x, *x))))
}

/// Upper bound of the lengths of the vectors of a box.
pub(super) fn largest_length(a: &Region) -> f64 {
    length_up(a.map(|side| side.mag()))
}

/// Upper bound of the distance of a vector of the box from its middle.
pub(super) fn radius(a: &Region) -> f64 {
    length_up(a.map(|side| side.rad()))
}

pub(super) fn middle(a: &Region) -> Vector {
    a.map(|side| side.mid())
}

pub(super) fn point(a: Vector) -> Region {
    a.map(Interval::point)
}

pub(super) fn sum(a: &Region, b: &Region) -> Region {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn hull(a: &Region, b: &Region) -> Region {
    [a[0].hull(b[0]), a[1].hull(b[1]), a[2].hull(b[2])]
}

/// Encloses `a'b`.
pub(super) fn inner(a: &Region, b: &Region) -> Interval {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Encloses `M v`.
pub(super) fn apply(m: &Block, v: &Region) -> Region {
    m.map(|row| inner(&row, v))
}

pub(super) fn transposed(m: &Block) -> Block {
    core::array::from_fn(|row| core::array::from_fn(|col| m[col][row]))
}

/// Encloses `A B`.
pub(super) fn product(a: &Block, b: &Block) -> Block {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| inner(&row, &column)))
}

pub(super) fn middle_of(m: &Block) -> Matrix {
    m.map(|row| middle(&row))
}

/// The largest radius of an entry.
pub(super) fn largest_radius(m: &Block) -> f64 {
    m.as_flattened().iter().fold(0.0, |most, entry| entry.rad().max(most))
}

fn vector(a: &Region) -> SVector<Interval, 3> {
    SVector::from(*a)
}

fn block(m: &SMatrix<Interval, 3, 3>) -> Block {
    core::array::from_fn(|row| core::array::from_fn(|col| m[(row, col)]))
}

/// The rotation matrix of a set of rotations.
pub(super) fn matrix(rotation: &SO3<Interval>) -> Block {
    block(&rotation.rotation_matrix())
}

/// The rotation matrix of an element, which is exactly a rotation: that of the direction of its quaternion.
pub(super) fn matrix_of(rotation: &SO3<f64>) -> Block {
    matrix(&rotation.enclose())
}

/// Encloses the rotations by the vectors of a box.
pub(super) fn exp(turn: &Region) -> SO3<Interval> {
    SO3::exp(&vector(turn))
}

/// The rotation by a vector, rounded.
pub(super) fn exp_of(turn: Vector) -> SO3<f64> {
    SO3::exp(&SVector::from(turn))
}

/// Upper bound of the angle of `rotation`, a product that is the identity but for rounding.
pub(super) fn slip(rotation: &SO3<Interval>) -> Result<f64, EstimatorError> {
    let turn = rotation.log()?;
    Ok(largest_length(&[turn[0], turn[1], turn[2]]))
}

/// Encloses the rotation vectors of `exp(-c) exp(c + d)` over a box of `d`: `J_r(c) d` up to `0.113 |c| |d|^2`.
///
/// The mirror image of what the page on these strips derives, (14) and (15) there, for `|d| <= 1`.
/// Longer `d` are given all rotation vectors: every rotation has one no longer than `pi`.
pub(super) fn rest(center: Vector, d: &Region) -> Result<Region, EstimatorError> {
    if center == [0.0; 3] {
        return Ok(*d);
    }
    let reach = largest_length(d);
    if reach.is_nan() || reach > 1.0 {
        return Ok(any_turn());
    }
    let slope = block(&SO3::jr(&vector(&point(center))));
    let bent = mul_up(BENT, mul_up(length_up(center), mul_up(reach, reach)));
    let ball = Interval::ZERO.inflate(reach);
    Ok(apply(&slope, d).map(|side| side.inflate(bent).intersection(ball)))
}

/// What a rotation vector is bent by, see [`rest`].
const BENT: f64 = 0.113;

/// Encloses the rotation vectors of `exp(r) exp(-c)` over a box of `r`: the mirror image of [`rest`].
pub(super) fn recentered(turn: &Region, center: Vector) -> Result<Region, EstimatorError> {
    // (exp(r) exp(-c))^-1 = exp(c) exp(-r) = exp(-(-c)) exp(-c + (c - r)).
    let d: Region = core::array::from_fn(|k| Interval::point(center[k]) - turn[k]);
    Ok(rest(center.map(|c| -c), &d)?.map(|side| -side))
}

/// Encloses the rotation vectors of `exp(y) exp(x)` over a box of `y`, the inverse of [`recentered`]; none where they may be longer than 3.5 or `y` is too
/// long.
///
/// With `exp(y) exp(x) = exp(x + d)`, `y = J_l(x) d` up to `0.113 |x| |d|^2`, and `|d| <= 2 |y|` for vectors up to 3.5, as in [`turned_on`].
pub(super) fn turned_before(y: &Region, x: Vector) -> Result<Option<Region>, EstimatorError> {
    let (reach, length) = (mul_up(2.0, largest_length(y)), length_up(x));
    if !(reach <= 1.0 && add_up(reach, length) < LONGEST) {
        return Ok(None);
    }
    let bent = mul_up(BENT, mul_up(length, mul_up(reach, reach)));
    let back = block(&SO3::jl_inv(&vector(&point(x)))?);
    Ok(Some(sum(&point(x), &apply(&back, &y.map(|side| side.inflate(bent))))))
}

/// Encloses the rotation vectors of `exp(r) exp(d)` over boxes; none where the vectors may be longer than 3.5.
///
/// Along `exp(r) exp(t d)` the vector moves by `J_r(g)^-1 d`. For vectors up to 3.5 that is shorter than `2 |d|`: the norm of the inverse is
/// `(|g|/2) / sin(|g|/2)`, below 1.79. So the way stays within `2 |d|` of the box, and the mean of the slopes over that box is what it moves by.
pub(super) fn turned_on(turn: &Region, d: &Region) -> Result<Option<Region>, EstimatorError> {
    let reach = mul_up(2.0, largest_length(d));
    let way = turn.map(|side| side.inflate(reach));
    let longest = largest_length(&way);
    if longest.is_nan() || longest >= LONGEST {
        return Ok(None);
    }
    let slope = block(&SO3::jr_inv(&vector(&way))?);
    Ok(Some(sum(turn, &apply(&slope, d))))
}
