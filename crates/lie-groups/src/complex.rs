//! Complex numbers as 2x2 matrices: the scalar arithmetic of all plane groups.

use std::ops::Mul;

use nalgebra::{SMatrix, SVector};
use scalars::Scalar;

/// The complex number `re + i im`, which acts on the plane as `[re -im; im re]`.
///
/// Rotations of the plane are the unit complex numbers, and every coefficient matrix of a plane group (`V`, the blocks of
/// the Jacobians) is a complex number, so products cost four multiplications and always commute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex<S> {
    /// Real part.
    pub re: S,
    /// Imaginary part.
    pub im: S,
}

impl<S: Scalar> Complex<S> {
    /// `re + i im`.
    #[inline]
    pub fn new(re: S, im: S) -> Self {
        Self { re, im }
    }

    /// The point `v` of the plane as `v_1 + i v_2`.
    #[inline]
    pub fn from_vector(v: &SVector<S, 2>) -> Self {
        Self::new(v[0], v[1])
    }

    /// The point `(re, im)` of the plane.
    #[inline]
    pub fn to_vector(self) -> SVector<S, 2> {
        SVector::<S, 2>::new(self.re, self.im)
    }

    /// The matrix `[re -im; im re]` of multiplication by this number.
    #[inline]
    pub fn to_matrix(self) -> SMatrix<S, 2, 2> {
        SMatrix::<S, 2, 2>::new(self.re, -self.im, self.im, self.re)
    }

    /// Complex conjugate `re - i im`: the inverse of a unit complex number.
    #[inline]
    pub fn conj(self) -> Self {
        Self::new(self.re, -self.im)
    }

    /// `i z`: a quarter turn to the left.
    #[inline]
    pub fn times_i(self) -> Self {
        Self::new(-self.im, self.re)
    }
}

impl<S: Scalar> Mul for Complex<S> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}
