//! Reverse operations: from the range of a result to the ranges of its operands.
//!
//! Each function takes the range `z` of a result and the ranges of its operands, and returns the operand's range without points that
//! fit no result: a superset of `{ a in A : z = op(a, b) for some b in B, z in Z }`, empty if there is none.

use scalars::Interval;

use super::reverse_functions as functions;
use crate::tape::node::{Binary, Unary};

/// The numbers `>= 0`.
pub(super) fn nonnegative(z: Interval) -> Interval {
    z.intersection(from(0.0))
}

/// The numbers at or above `lo`, which is not NaN.
pub(super) fn from(lo: f64) -> Interval {
    Interval::new(lo, f64::INFINITY).unwrap_or(Interval::ENTIRE)
}

/// The numbers at or below `hi`, which is not NaN.
pub(super) fn up_to(hi: f64) -> Interval {
    Interval::new(f64::NEG_INFINITY, hi).unwrap_or(Interval::ENTIRE)
}

/// `[lo, hi]`; the whole line if these are no bounds.
pub(super) fn between(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap_or(Interval::ENTIRE)
}

/// Points of `a` whose absolute value, or that with the sign changed, lies in `roots`.
pub(super) fn both_signs(roots: Interval, a: Interval) -> Interval {
    a.intersection(roots).hull(a.intersection(-roots))
}

/// `a` of `z = op(a)`.
pub(super) fn unary(operation: Unary, z: Interval, a: Interval) -> Interval {
    match operation {
        Unary::Neg => a.intersection(-z),
        Unary::Sqr => both_signs(nonnegative(z).sqrt(), a),
        Unary::Recip => power(-1, z, a),
        Unary::Abs => both_signs(nonnegative(z), a),
        Unary::Sign => sign(z, a),
        Unary::Sqrt => a.intersection(nonnegative(z).sqr()),
        Unary::Exp => a.intersection(z.ln()),
        Unary::Ln => a.intersection(z.exp()),
        Unary::Sin => functions::sin(z, a),
        Unary::Cos => functions::cos(z, a),
        Unary::Tan => functions::tan(z, a),
        Unary::Asin => functions::asin(z, a),
        Unary::Acos => functions::acos(z, a),
        Unary::Atan => functions::atan(z, a),
        Unary::Sinh => functions::sinh(z, a),
        Unary::Cosh => functions::cosh(z, a),
        Unary::Tanh => functions::tanh(z, a),
    }
}

/// `a` of `z = op(a, b)`.
pub(super) fn first(operation: Binary, z: Interval, a: Interval, b: Interval) -> Interval {
    match operation {
        Binary::Add => a.intersection(z - b),
        Binary::Sub => a.intersection(z + b),
        Binary::Mul => factor(z, b, a),
        Binary::Div => a.intersection(z * b),
        Binary::Min => smaller(z, a, b),
        Binary::Max => -smaller(-z, -a, -b),
        Binary::Atan2 => functions::ordinate(z, a, b),
    }
}

/// `b` of `z = op(a, b)`.
pub(super) fn second(operation: Binary, z: Interval, a: Interval, b: Interval) -> Interval {
    match operation {
        Binary::Sub => b.intersection(a - z),
        Binary::Div => factor(a, z, b),
        Binary::Atan2 => functions::abscissa(z, a, b),
        Binary::Add | Binary::Mul | Binary::Min | Binary::Max => first(operation, z, b, a),
    }
}

/// `x` of `z = x b`: the quotient, in two pieces if `b` has zero inside.
///
/// **Source:** IEEE Std 1788-2015, section 10.5.5, `mulRev`.
pub(super) fn factor(z: Interval, b: Interval, x: Interval) -> Interval {
    if !b.contains(0.0) {
        return x.intersection(z / b);
    }
    if z.contains(0.0) {
        return if b.is_empty() || z.is_empty() { Interval::EMPTY } else { x };
    }
    // Here b is not zero. An empty piece stays empty.
    let positive = z / nonnegative(b);
    let negative = z / b.intersection(up_to(0.0));
    x.intersection(positive).hull(x.intersection(negative))
}

/// `a` of `z = min(a, b)`.
fn smaller(z: Interval, a: Interval, b: Interval) -> Interval {
    if z.is_empty() {
        return z;
    }
    let a = a.intersection(from(z.lo()));
    // Where b is above z, it is a that is the smaller.
    if b.lo() > z.hi() { a.intersection(up_to(z.hi())) } else { a }
}

/// `a` of `z = sign(a)`, where the sign of zero may be any number between -1 and 1.
fn sign(z: Interval, a: Interval) -> Interval {
    let z = z.intersection(between(-1.0, 1.0));
    if z.is_empty() {
        return z;
    }
    let a = if z.lo() > -1.0 { nonnegative(a) } else { a };
    if z.hi() < 1.0 { a.intersection(up_to(0.0)) } else { a }
}

/// `a` of `z = a^n`.
pub(super) fn power(n: i32, z: Interval, a: Interval) -> Interval {
    match n {
        0 => a,
        1 => a.intersection(z),
        _ if n % 2 == 0 => both_signs(positive_root(n, z), a),
        _ => a.intersection(positive_root(n, z)).hull(a.intersection(-positive_root(n, -z))),
    }
}

/// `{ a >= 0 : a^n in z }`, `n != 0`.
fn positive_root(n: i32, z: Interval) -> Interval {
    let z = nonnegative(z);
    let z = if n < 0 { z.recip() } else { z };
    match n.unsigned_abs() {
        1 => z,
        2 => z.sqrt(),
        degree => functions::root(z, degree),
    }
}

/// `a` of `z = k a`.
pub(super) fn scale(k: f64, z: Interval, a: Interval) -> Interval {
    factor(z, Interval::point(k), a)
}

/// `a` of `z = a + k`.
pub(super) fn shift(k: f64, z: Interval, a: Interval) -> Interval {
    a.intersection(z - Interval::point(k))
}
