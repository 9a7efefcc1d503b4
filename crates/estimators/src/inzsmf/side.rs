//! Left- and right-invariant estimation errors.

use std::fmt::Debug;

use lie_groups::LieGroup;
use nalgebra::{SMatrix, SVector};

use crate::EstimatorError;

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Left {}
    impl Sealed for super::Right {}
}

/// The side on which the estimation error acts: [`Left`] or [`Right`].
///
/// With `X+ = X exp(xi) exp(w)` for the state and `Xhat exp(xi)` for the prediction, the error `eps` obeys
/// `eps+ = A eps + B w` before the correction, exactly in `eps` where `w = 0`.
pub trait ErrorSide: sealed::Sealed + Copy + Debug + Default + Send + Sync + 'static {
    /// Whether this is the left-invariant error.
    const IS_LEFT: bool;

    /// `A` for the motion `exp(xi)`.
    fn transition<G, const N: usize, const D: usize>(motion: &G) -> SMatrix<f64, N, N>
    where
        G: LieGroup<f64, N, D>;

    /// `B` at the estimate `at` of the end of the step.
    fn noise_map<G, const N: usize, const D: usize>(at: &G) -> SMatrix<f64, N, N>
    where
        G: LieGroup<f64, N, D>;

    /// The state with error `eps` from `estimate`; also how a correction is applied.
    fn apply<G, const N: usize, const D: usize>(estimate: &G, eps: &SVector<f64, N>) -> G
    where
        G: LieGroup<f64, N, D>;

    /// The error of `state` about `estimate`, the inverse of [`apply`](Self::apply): `log(Xhat^-1 X)` or `log(X Xhat^-1)`.
    ///
    /// # Errors
    /// Those of [`LieGroup::log`].
    fn error<G, const N: usize, const D: usize>(estimate: &G, state: &G) -> Result<SVector<f64, N>, EstimatorError>
    where
        G: LieGroup<f64, N, D>;

    /// Derivative of the error about the corrected estimate with respect to the error about the predicted one, at `correction`.
    fn transport<G, const N: usize, const D: usize>(correction: &SVector<f64, N>) -> SMatrix<f64, N, N>
    where
        G: LieGroup<f64, N, D>;

    /// Derivative of `X . p` with respect to the error (`D x N`).
    fn point_jacobian<G, const N: usize, const D: usize>(estimate: &G, p: &SVector<f64, D>) -> SMatrix<f64, D, N>
    where
        G: LieGroup<f64, N, D>;
}

/// The left-invariant error `exp(eps) = Xhat^-1 X`: coordinates of the body.
///
/// `A = Ad_exp(-xi)`, `B = I`; a correction is `Xhat exp(L z)`. (Paper 000 truncates `A` to `I - ad_xi`.)
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Left;

/// The right-invariant error `exp(eps) = X Xhat^-1`: coordinates of the world.
///
/// `A = I`, `B = Ad_Xhat` at the end of the step; a correction is `exp(L z) Xhat`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Right;

impl ErrorSide for Left {
    const IS_LEFT: bool = true;

    #[inline]
    fn transition<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(motion: &G) -> SMatrix<f64, N, N> {
        motion.inverse().adjoint()
    }

    #[inline]
    fn noise_map<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(_: &G) -> SMatrix<f64, N, N> {
        SMatrix::identity()
    }

    #[inline]
    fn apply<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(estimate: &G, eps: &SVector<f64, N>) -> G {
        estimate.compose(&G::exp(eps))
    }

    #[inline]
    fn error<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(
        estimate: &G,
        state: &G,
    ) -> Result<SVector<f64, N>, EstimatorError> {
        Ok(estimate.inverse().compose(state).log()?)
    }

    #[inline]
    fn transport<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(
        correction: &SVector<f64, N>,
    ) -> SMatrix<f64, N, N> {
        G::jr(correction)
    }

    #[inline]
    fn point_jacobian<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(
        estimate: &G,
        p: &SVector<f64, D>,
    ) -> SMatrix<f64, D, N> {
        estimate.act_linear() * G::act_jacobian(p)
    }
}

impl ErrorSide for Right {
    const IS_LEFT: bool = false;

    #[inline]
    fn transition<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(_: &G) -> SMatrix<f64, N, N> {
        SMatrix::identity()
    }

    #[inline]
    fn noise_map<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(at: &G) -> SMatrix<f64, N, N> {
        at.adjoint()
    }

    #[inline]
    fn apply<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(estimate: &G, eps: &SVector<f64, N>) -> G {
        G::exp(eps).compose(estimate)
    }

    #[inline]
    fn error<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(
        estimate: &G,
        state: &G,
    ) -> Result<SVector<f64, N>, EstimatorError> {
        Ok(state.compose(&estimate.inverse()).log()?)
    }

    #[inline]
    fn transport<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(
        correction: &SVector<f64, N>,
    ) -> SMatrix<f64, N, N> {
        G::jl(correction)
    }

    #[inline]
    fn point_jacobian<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(
        estimate: &G,
        p: &SVector<f64, D>,
    ) -> SMatrix<f64, D, N> {
        G::act_jacobian(&estimate.act(p))
    }
}
