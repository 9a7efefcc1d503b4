//! Sets of rotations of space: a ball and a box around one rotation.

use scalars::{Interval, Scalar};

use super::SpaceCoeff;
use super::space_float::quaternion_of;
use super::spin_offset::{Offset, bend, length};
use crate::triples::{Rows, add, apply, conjugate, cross, quaternion_product, squared, transposed};
use crate::{Coeff, GroupError};

/// The rotations `exp(d) R_0` with `d` in a box and of length at most a radius.
///
/// `R_0` is the rotation of an `f64` quaternion (of the exact direction of it), `d` a rotation vector in fixed coordinates.
///
/// Why both: the *box* is what a small set needs, but a product turns it by a rotation, and a box around a turned box is wider by up to
/// `|cos| + |sin|` each time. The *ball* does not care: lengths of rotation vectors add under products whatever the directions, so after any number
/// of products the set is at most as large as the sum of the radii, as arcs are in the plane. What it costs: a set longer in one direction
/// than in the others is taken for a ball of its largest half-diagonal (up to `sqrt(3)` for a cube) once the box has grown past it.
///
/// **Guarantee:** every operation returns a superset of the exact results; a radius from `pi` on means all rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinSet {
    center: [f64; 4],
    offset: [Interval; 3],
    radius: f64,
}

type Matrix = Rows<Interval>;

/// `v + f w x v + g w x (w x v)`, the factors and `w` intervals.
fn rodrigues(w: [Interval; 3], [f, g]: [Interval; 2], v: [Interval; 3]) -> [Interval; 3] {
    let once = cross(w, v);
    let twice = cross(w, once);
    std::array::from_fn(|k| v[k] + f * once[k] + g * twice[k])
}

fn points(q: &[f64; 4]) -> [Interval; 4] {
    q.map(Interval::point)
}

/// Unit quaternion of the exact rotation by `w`.
fn exact_quaternion(w: [f64; 3]) -> [Interval; 4] {
    let w = w.map(Interval::point);
    let quarter = squared(&w).scale(0.25);
    let (cos, half_sinc) = (quarter.stumpff(0), quarter.stumpff(1).scale(0.5));
    [cos, half_sinc * w[0], half_sinc * w[1], half_sinc * w[2]]
}

impl SpinSet {
    fn new(center: [f64; 4], offset: Offset) -> Self {
        Self { center, offset: offset.vector, radius: offset.radius }
    }

    fn offset(&self) -> Offset {
        Offset { vector: self.offset, radius: self.radius }
    }

    /// The one rotation of the direction of a quaternion, exactly.
    pub(crate) fn point(center: [f64; 4]) -> Self {
        Self { center, offset: [Interval::ZERO; 3], radius: 0.0 }
    }

    /// All rotations.
    pub(super) fn all() -> Self {
        Self::new([1.0, 0.0, 0.0, 0.0], Offset::any())
    }

    /// The quaternion of `R_0`.
    pub fn center(&self) -> [f64; 4] {
        self.center
    }

    /// Box of the rotation vectors `d`.
    pub fn box_offset(&self) -> [Interval; 3] {
        self.offset
    }

    /// Largest angle between a member and `R_0`.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// `exp(w)` for the vectors of a box: with `w = w_0 + d`, `log(exp(w) exp(-w_0))` lies within `|d|` and is `Jl(w) d` up to curvature.
    pub(super) fn exp(w: [Interval; 3]) -> Self {
        if w.iter().any(Interval::is_empty) {
            return Self::new([1.0, 0.0, 0.0, 0.0], Offset::none());
        }
        if !w.iter().all(|x| x.is_bounded() && x.mag() < 1e100) {
            return Self::all();
        }
        let middle = w.map(|x| x.mid());
        let center = f64::spin(middle);
        let rounding =
            Offset::of_quaternion(quaternion_product(&exact_quaternion(middle), &points(&conjugate(&center))));
        let d: [Interval; 3] = std::array::from_fn(|k| w[k].add_f64(-middle[k]));
        let reach = length(d);
        let moved = if reach == 0.0 {
            Offset { vector: d, radius: 0.0 }
        } else if reach < std::f64::consts::PI {
            let image = rodrigues(w, Interval::bc(squared(&w)), d);
            let error = bend(Interval::point(reach)) * Interval::point(reach);
            Offset::new(image.map(|x| x.inflate(error.hi())), reach)
        } else {
            Offset::any()
        };
        Self::new(center, moved.then(rounding))
    }

    /// Rotation vectors, by `log(exp(d) exp(w_0)) = w_0 + int Jl(w)^-1 d` along the way.
    pub(super) fn log(&self) -> Result<[Interval; 3], GroupError> {
        if self.offset[0].is_empty() || !self.center.iter().all(|x| x.is_finite()) {
            return Err(GroupError::NotFinite { index: 0 });
        }
        let (start, _) = f64::spin_log(&self.center)?;
        let sign = if self.center[0] < 0.0 { -1.0 } else { 1.0 };
        let stored = points(&self.center.map(|x| sign * x));
        let [w, x, y, z] = exact_quaternion(start);
        let rounding = Offset::of_quaternion(quaternion_product(&stored, &[w, -x, -y, -z]));
        let total = self.offset().then(rounding);
        let start = start.map(Interval::point);
        let longest = squared(&start).sqrt() + Interval::point(total.radius);
        if longest.hi() >= std::f64::consts::PI {
            let from = (squared(&start).sqrt() - Interval::point(total.radius)).lo().max(0.0);
            return Err(GroupError::HalfTurn { theta_lo_rad: from, theta_hi_rad: longest.hi() });
        }
        // |Jl^-1| = (t/2) / sin(t/2) <= pi/2 on the way: a first box, then two steps of the integral over what is known.
        let ball = Interval::lit(-1.571 * total.radius, 1.571 * total.radius);
        let largest = Interval::lit(0.0, longest.hi()).sqr();
        let step = |way: [Interval; 3]| -> Result<[Interval; 3], GroupError> {
            let [e, _] = Interval::e_slope(squared(&way).intersection(largest))?;
            Ok(rodrigues(way, [Interval::point(-0.5), e], total.vector))
        };
        let first = step(start.map(|x| x + ball))?;
        let way = std::array::from_fn(|k| start[k] + first[k].hull(Interval::ZERO));
        let bound = Interval::lit(-longest.hi(), longest.hi());
        Ok(add(start, step(way)?).map(|x| x.intersection(bound)))
    }

    pub(super) fn product(&self, other: &Self) -> Self {
        let center = f64::spin_product(&self.center, &other.center);
        let exact = quaternion_product(&points(&self.center), &points(&other.center));
        let rounding = Offset::of_quaternion(quaternion_product(&exact, &points(&conjugate(&center))));
        let turned = Offset::new(apply(&center_matrix(&self.center), other.offset), other.radius);
        Self::new(center, self.offset().then(turned.then(rounding)))
    }

    pub(super) fn reverse(&self) -> Self {
        let turned = apply(&transposed(&center_matrix(&self.center)), self.offset);
        Self::new(conjugate(&self.center), Offset::new(turned.map(|x| -x), self.radius))
    }

    /// `exp(d) R_0` as an interval matrix.
    pub(super) fn matrix(&self) -> Matrix {
        let middle = center_matrix(&self.center);
        if self.radius == 0.0 && !self.offset[0].is_empty() {
            return middle;
        }
        let x = squared(&self.offset).intersection(Interval::point(self.radius).sqr().hull(Interval::ZERO));
        let factors = [x.stumpff(1), x.stumpff(2)];
        let unit = Interval::lit(-1.0, 1.0);
        let turned =
            transposed(&middle).map(|column| rodrigues(self.offset, factors, column).map(|v| v.intersection(unit)));
        transposed(&turned)
    }

    /// Unit quaternions of the members, of the sign of the stored one.
    pub(super) fn quaternion(&self) -> [Interval; 4] {
        let x = squared(&self.offset).intersection(Interval::point(self.radius).sqr().hull(Interval::ZERO)).scale(0.25);
        let half_sinc = x.stumpff(1).scale(0.5);
        let [dx, dy, dz] = self.offset.map(|d| half_sinc * d);
        let center = points(&self.center);
        let norm = (center.iter().fold(Interval::ZERO, |sum, q| sum + q.sqr())).sqrt();
        quaternion_product(&[x.stumpff(0), dx, dy, dz], &center.map(|q| q / norm))
    }

    /// The rotations of all directions in a box of quaternions.
    pub(super) fn from_quaternion(q: [Interval; 4]) -> Result<Self, GroupError> {
        for (index, x) in q.iter().enumerate() {
            x.check_finite(index)?;
        }
        let Ok(center) = f64::spin_from_quaternion(q.map(|x| x.mid())) else {
            return if q.iter().all(|x| *x == Interval::ZERO) {
                Err(GroupError::NotARotation)
            } else {
                Ok(Self::all())
            };
        };
        Ok(Self::new(center, Offset::of_quaternion(quaternion_product(&q, &points(&conjugate(&center))))))
    }

    /// The rotations with their matrix in a box: relative to the middle one, the skew part is `sin t / t d`, the trace `1 + 2 cos t`.
    pub(super) fn from_matrix(m: Matrix) -> Result<Self, GroupError> {
        for (index, x) in m.iter().flatten().enumerate() {
            x.check_finite(index)?;
        }
        let center = f64::spin_from_quaternion(quaternion_of(&m.map(|row| row.map(|x| x.mid()))))?;
        let middle = center_matrix(&center);
        let relative: Matrix = m.map(|row| apply(&middle, row));
        let unit = Interval::lit(-1.0, 1.0);
        let trace = relative[0][0] + relative[1][1] + relative[2][2];
        let cos = trace.add_f64(-1.0).scale(0.5).intersection(unit);
        let odd = |i: usize, j: usize| (relative[i][j] - relative[j][i]).scale(0.5).intersection(unit);
        let skew = [odd(2, 1), odd(0, 2), odd(1, 0)];
        if cos.is_empty() || skew.iter().any(Interval::is_empty) {
            return Err(GroupError::NotARotation);
        }
        let by_cos = cos.acos();
        let sine = Interval::lit(0.0, length(skew).min(1.0));
        let offset = if cos.lo() > 0.0 {
            let angle = sine.asin();
            let angle = Interval::lit(0.0, angle.hi().min(by_cos.hi()));
            // t / sin t rises from 1.
            let sinc = angle.sqr().stumpff(1);
            Offset::new(skew.map(|v| v / sinc), angle.hi())
        } else {
            let range = Interval::lit(-by_cos.hi(), by_cos.hi());
            Offset::new([range; 3], by_cos.hi())
        };
        Ok(Self::new(center, offset))
    }
}

/// Matrix of the exact direction of a quaternion, up to rounding.
fn center_matrix(q: &[f64; 4]) -> Matrix {
    let [w, x, y, z] = points(q);
    let (ww, xx, yy, zz) = (w.sqr(), x.sqr(), y.sqr(), z.sqr());
    let norm = ww + xx + yy + zz;
    let twice = |v: Interval| v.scale(2.0) / norm;
    let unit = Interval::lit(-1.0, 1.0);
    let one_minus = |v: Interval| (Interval::ONE - twice(v)).intersection(unit);
    [
        [one_minus(yy + zz), twice(x * y - w * z), twice(x * z + w * y)],
        [twice(x * y + w * z), one_minus(xx + zz), twice(y * z - w * x)],
        [twice(x * z - w * y), twice(y * z + w * x), one_minus(xx + yy)],
    ]
}
