//! Triples and quaternions `(w, x, y, z)` over any scalar, unrolled.

use std::ops::Index;

use scalars::Scalar;

/// Three rows of three.
pub(crate) type Rows<S> = [[S; 3]; 3];

/// `|v|^2`.
#[inline]
pub(crate) fn squared<S: Scalar>(v: &impl Index<usize, Output = S>) -> S {
    v[0].sqr() + v[1].sqr() + v[2].sqr()
}

/// `a . b`.
#[inline]
pub(crate) fn dot<S: Scalar>(a: &impl Index<usize, Output = S>, b: &impl Index<usize, Output = S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a + b`.
#[inline]
pub(crate) fn add<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

/// `a x b`.
#[inline]
pub(crate) fn cross<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `M v`.
#[inline]
pub(crate) fn apply<S: Scalar>(m: &Rows<S>, v: [S; 3]) -> [S; 3] {
    m.map(|row| dot(&row, &v))
}

/// `M^T`.
#[inline]
pub(crate) fn transposed<S: Scalar>(m: &Rows<S>) -> Rows<S> {
    std::array::from_fn(|row| std::array::from_fn(|col| m[col][row]))
}

/// Product of quaternions.
#[inline]
pub(crate) fn quaternion_product<S: Scalar>(a: &[S; 4], b: &[S; 4]) -> [S; 4] {
    let ([aw, ax, ay, az], [bw, bx, by, bz]) = (*a, *b);
    [
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    ]
}

/// Conjugate of a quaternion: the inverse of one of length 1.
#[inline]
pub(crate) fn conjugate<S: Scalar>(q: &[S; 4]) -> [S; 4] {
    let [w, x, y, z] = *q;
    [w, -x, -y, -z]
}
