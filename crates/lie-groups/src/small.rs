//! Products of small matrices over any scalar, unrolled: what the generic groups are computed with.

use nalgebra::{SMatrix, SVector};
use scalars::Scalar;

/// `A v`.
#[inline]
pub(crate) fn apply<S: Scalar, const R: usize, const C: usize>(
    a: &SMatrix<S, R, C>,
    v: &SVector<S, C>,
) -> SVector<S, R> {
    SVector::from_fn(|row, _| (1..C).fold(a[(row, 0)] * v[0], |sum, k| sum + a[(row, k)] * v[k]))
}

/// `A B`.
#[inline]
pub(crate) fn times<S: Scalar, const R: usize, const K: usize, const C: usize>(
    a: &SMatrix<S, R, K>,
    b: &SMatrix<S, K, C>,
) -> SMatrix<S, R, C> {
    SMatrix::from_fn(|row, col| (1..K).fold(a[(row, 0)] * b[(0, col)], |sum, k| sum + a[(row, k)] * b[(k, col)]))
}

/// `-A`.
#[inline]
pub(crate) fn negated<S: Scalar, const R: usize, const C: usize>(a: &SMatrix<S, R, C>) -> SMatrix<S, R, C> {
    a.map(|x| -x)
}

/// `a + b`.
#[inline]
pub(crate) fn sum<S: Scalar, const R: usize, const C: usize>(
    a: &SMatrix<S, R, C>,
    b: &SMatrix<S, R, C>,
) -> SMatrix<S, R, C> {
    a.zip_map(b, |x, y| x + y)
}

/// Writes a block with its upper left entry at `(row, col)`.
#[inline]
pub(crate) fn put<S: Scalar, const N: usize, const R: usize, const C: usize>(
    target: &mut SMatrix<S, N, N>,
    row: usize,
    col: usize,
    block: &SMatrix<S, R, C>,
) {
    for c in 0..C {
        for r in 0..R {
            target[(row + r, col + c)] = block[(r, c)];
        }
    }
}

/// `LENGTH` coordinates from `start` on.
#[inline]
pub(crate) fn part<S: Scalar, const N: usize, const LENGTH: usize>(
    v: &SVector<S, N>,
    start: usize,
) -> SVector<S, LENGTH> {
    SVector::from_fn(|row, _| v[start + row])
}
