//! The trait every group implements.

use std::fmt::Debug;

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::{Coeff, GroupError};

/// A matrix Lie group of dimension `N` acting on `R^D` by affine maps.
///
/// `N` is the dimension of the tangent space, `D` that of the space acted on. The conventions (tangent order, Jacobians,
/// adjoint) are those of the [crate](crate); the laws that every implementation satisfies are the ones named at each method.
pub trait LieGroup<S: Coeff, const N: usize, const D: usize>: Copy + Debug + PartialEq {
    /// Neutral element `I`.
    fn identity() -> Self;

    /// Exponential `exp(xi) = expm(hat(xi))`; `exp((s + t) xi) = exp(s xi) exp(t xi)`.
    fn exp(xi: &SVector<S, N>) -> Self;

    /// Principal logarithm: the `xi` with `exp(xi) = X` and rotation angle in `(-pi, pi)`; over `f64` a half turn is told as `pi`
    /// or `-pi` by the sign of its sine.
    ///
    /// # Errors
    /// [`GroupError::HalfTurn`] over intervals if the rotation can reach `pi`; [`GroupError::NotFinite`] for NaN, infinite, empty
    /// or unbounded elements.
    fn log(&self) -> Result<SVector<S, N>, GroupError>;

    /// Product `X Y`.
    #[must_use]
    fn compose(&self, other: &Self) -> Self;

    /// Inverse `X^-1`, with `X X^-1 = I`.
    #[must_use]
    fn inverse(&self) -> Self;

    /// Action `X . p` on a point; `(X Y) . p = X . (Y . p)`.
    fn act(&self, p: &SVector<S, D>) -> SVector<S, D>;

    /// Linear part (`D x D`) of the affine map `p -> X . p`.
    fn act_linear(&self) -> SMatrix<S, D, D>;

    /// Derivative (`D x N`) of `exp(eps) . p` with respect to `eps` at 0.
    fn act_jacobian(p: &SVector<S, D>) -> SMatrix<S, D, N>;

    /// Adjoint `Ad_X` (`N x N`): `X exp(xi) X^-1 = exp(Ad_X xi)`.
    fn adjoint(&self) -> SMatrix<S, N, N>;

    /// Adjoint of the algebra, `ad_xi` (`N x N`): `ad_xi eta = [xi, eta]`, and `Ad_exp(xi) = expm(ad_xi)`.
    fn ad(xi: &SVector<S, N>) -> SMatrix<S, N, N>;

    /// Left Jacobian `Jl(xi) = phi_1(ad_xi)` (`N x N`): `exp(xi + d) = exp(Jl(xi) d) exp(xi)` to first order in `d`.
    fn jl(xi: &SVector<S, N>) -> SMatrix<S, N, N>;

    /// Inverse of the left Jacobian, for rotation angles below `2 pi`.
    ///
    /// # Errors
    /// [`GroupError::FullTurn`] if the angle can reach `2 pi`, [`GroupError::NotFinite`] if it is NaN, empty or unbounded.
    fn jl_inv(xi: &SVector<S, N>) -> Result<SMatrix<S, N, N>, GroupError>;

    /// Right Jacobian `Jr(xi) = Jl(-xi)`: `exp(xi + d) = exp(xi) exp(Jr(xi) d)` to first order in `d`.
    #[inline]
    fn jr(xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        Self::jl(&xi.map(|v| -v))
    }

    /// Inverse of the right Jacobian, for rotation angles below `2 pi`.
    ///
    /// # Errors
    /// Those of [`jl_inv`](Self::jl_inv).
    #[inline]
    fn jr_inv(xi: &SVector<S, N>) -> Result<SMatrix<S, N, N>, GroupError> {
        Self::jl_inv(&xi.map(|v| -v))
    }

    /// Matrix `hat(xi)` of a tangent vector in the Lie algebra.
    fn hat(xi: &SVector<S, N>) -> DMatrix<S>;

    /// Tangent vector of a matrix of the Lie algebra: the inverse of [`hat`](Self::hat).
    ///
    /// # Errors
    /// [`GroupError::Shape`] for a matrix of the wrong shape, [`GroupError::NotInAlgebra`] unless `hat(vee(M)) = M` exactly.
    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, N>, GroupError>;

    /// Faithful matrix form: `matrix(X Y) = matrix(X) matrix(Y)`, `matrix(exp(xi)) = expm(hat(xi))`.
    fn matrix(&self) -> DMatrix<S>;

    /// The point at `t` of the one-parameter curve from `a` (`t = 0`) to `b` (`t = 1`): `a exp(t log(a^-1 b))`.
    ///
    /// # Errors
    /// Those of [`log`](Self::log) for `a^-1 b`.
    #[inline]
    fn interpolate(a: &Self, b: &Self, t: S) -> Result<Self, GroupError> {
        let step = a.inverse().compose(b).log()?;
        Ok(a.compose(&Self::exp(&step.map(|v| v * t))))
    }
}

/// Shared body of the `vee` methods: checks the shape, reads the vector, compares `hat` of it with the matrix.
pub(crate) fn checked_vee<S: Coeff, const N: usize>(
    matrix: &DMatrix<S>,
    size: usize,
    read: impl Fn(&DMatrix<S>) -> SVector<S, N>,
    hat: impl Fn(&SVector<S, N>) -> DMatrix<S>,
) -> Result<SVector<S, N>, GroupError> {
    let (found_rows, found_cols) = matrix.shape();
    if (found_rows, found_cols) != (size, size) {
        return Err(GroupError::Shape { expected: size, found_rows, found_cols });
    }
    let xi = read(matrix);
    let rebuilt = hat(&xi);
    for col in 0..size {
        for row in 0..size {
            if rebuilt[(row, col)] != matrix[(row, col)] {
                return Err(GroupError::NotInAlgebra { row, col });
            }
        }
    }
    Ok(xi)
}
