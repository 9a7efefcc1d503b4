//! Rotations of space near one: boxes of rotation vectors with a bound of their length.

use scalars::{Interval, Scalar};

use crate::triples::{add, squared};

/// Just above `pi`.
const ALL: f64 = 3.141_592_653_589_794;

/// Upper bound of the length of the vectors in a box.
pub(super) fn length(v: [Interval; 3]) -> f64 {
    squared(&v.map(|x| Interval::point(x.mag()))).sqrt().hi()
}

/// Rotation vectors with the length bound, as offsets of a set.
#[derive(Clone, Copy)]
pub(super) struct Offset {
    pub(super) vector: [Interval; 3],
    pub(super) radius: f64,
}

impl Offset {
    /// All rotations.
    pub(super) fn any() -> Self {
        Self { vector: [Interval::lit(-ALL, ALL); 3], radius: ALL }
    }

    /// No rotation.
    pub(super) fn none() -> Self {
        Self { vector: [Interval::EMPTY; 3], radius: 0.0 }
    }

    /// The box cut to the ball and the ball to the box.
    pub(super) fn new(vector: [Interval; 3], radius: f64) -> Self {
        if vector.iter().any(Interval::is_empty) {
            return Self::none();
        }
        let radius = radius.min(length(vector));
        if radius >= std::f64::consts::PI {
            return Self::any();
        }
        let ball = Interval::lit(-radius, radius);
        let vector = vector.map(|x| x.intersection(ball));
        Self { vector, radius }
    }

    /// The rotation vectors of quaternions (of any length) near the identity.
    pub(super) fn of_quaternion([real, x, y, z]: [Interval; 4]) -> Self {
        if [real, x, y, z].iter().any(Interval::is_empty) {
            return Self::none();
        }
        if real.lo() <= 0.0 {
            return Self::any();
        }
        let tangent = [x / real, y / real, z / real];
        let longest = Interval::point(length(tangent));
        let angle = longest.atan();
        // atan(n) / n falls from 1.
        let factor = if longest == Interval::ZERO { Interval::ONE } else { (angle / longest).hull(Interval::ONE) };
        let factor = factor.intersection(Interval::lit(0.0, 1.0));
        Self::new(tangent.map(|v| (v * factor).scale(2.0)), angle.scale(2.0).hi())
    }

    /// `log(exp(a) exp(b))`: `a + b` up to the first commutator.
    ///
    /// `c(r) = log(exp(a) exp(r b))` has `dc/dr = Jr(c)^-1 b` and `|c| <= |a| + |b| = t`; there `|Jr^-1 - I| <= t/2 + t^2 e(t)`, `e(t) <= e(pi) = 1 / pi^2`.
    /// The same with the roles of `a` and `b` exchanged.
    pub(super) fn then(self, b: Self) -> Self {
        let sum = Interval::point(self.radius) + Interval::point(b.radius);
        if sum.hi() >= std::f64::consts::PI {
            return if self.vector[0].is_empty() || b.vector[0].is_empty() { Self::none() } else { Self::any() };
        }
        let bend = bend(sum) * Interval::point(self.radius.min(b.radius));
        let vector = add(self.vector, b.vector).map(|x| x.inflate(bend.hi()));
        Self::new(vector, sum.hi())
    }
}

/// Bound of `|J^-1 - I|` for rotation vectors up to the length `t <= pi`.
pub(super) fn bend(t: Interval) -> Interval {
    t.scale(0.5) + t.sqr() * Interval::lit(0.1013, 0.1014)
}
