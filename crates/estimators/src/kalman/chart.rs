//! [`Chart`]: what the error of an estimate is, on a vector space or on a group.

use std::fmt::Debug;
use std::marker::PhantomData;

use lie_groups::LieGroup;
use nalgebra::{SMatrix, SVector};

use crate::error::check_finite;
use crate::{ErrorSide, EstimatorError};

/// Coordinates of the states around a point, `N` numbers that are 0 at the point itself: the error convention of a filter.
///
/// [`Flat`] is `R^N`, [`OnGroup`] a Lie group with the left- or the right-invariant error. Implemented by hand for other manifolds.
pub trait Chart<const N: usize>: Copy + Debug + PartialEq + 'static {
    /// A state.
    type Point: Copy + Debug + PartialEq;

    /// Whether the space is flat: means are weighted sums, and [`transport`](Self::transport) is the identity.
    const FLAT: bool;

    /// The state with the coordinates `error` around `point`.
    fn shift(point: &Self::Point, error: &SVector<f64, N>) -> Self::Point;

    /// The coordinates of `state` around `point`: the inverse of [`shift`](Self::shift).
    ///
    /// # Errors
    /// A state that is not finite, or that the coordinates do not reach.
    fn difference(state: &Self::Point, point: &Self::Point) -> Result<SVector<f64, N>, EstimatorError>;

    /// Derivative (`N x N`) of the coordinates around the shifted point by those around the point, at the shifted point.
    fn transport(shift: &SVector<f64, N>) -> SMatrix<f64, N, N>;

    /// `Ok` if the state is finite.
    ///
    /// # Errors
    /// [`EstimatorError::NotFinite`].
    fn check(point: &Self::Point) -> Result<(), EstimatorError>;
}

/// `R^N`: the error is `x - xhat`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Flat;

impl<const N: usize> Chart<N> for Flat {
    type Point = SVector<f64, N>;
    const FLAT: bool = true;

    #[inline]
    fn shift(point: &SVector<f64, N>, error: &SVector<f64, N>) -> SVector<f64, N> {
        point + error
    }

    #[inline]
    fn difference(state: &SVector<f64, N>, point: &SVector<f64, N>) -> Result<SVector<f64, N>, EstimatorError> {
        Ok(state - point)
    }

    #[inline]
    fn transport(_: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        SMatrix::identity()
    }

    #[inline]
    fn check(point: &SVector<f64, N>) -> Result<(), EstimatorError> {
        check_finite("estimate", point.as_slice())
    }
}

/// A Lie group `G` of dimension `N` acting on `R^D`, with the error of a side: `exp(eps) = Xhat^-1 X` for [`Left`](crate::Left),
/// `X Xhat^-1` for [`Right`](crate::Right).
///
/// Angles are never averaged or subtracted: what is, are logarithms of group elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OnGroup<G, Side, const D: usize>(PhantomData<(G, Side)>);

impl<G, Side, const N: usize, const D: usize> Chart<N> for OnGroup<G, Side, D>
where
    G: LieGroup<f64, N, D> + 'static,
    Side: ErrorSide + PartialEq,
{
    type Point = G;
    const FLAT: bool = false;

    #[inline]
    fn shift(point: &G, error: &SVector<f64, N>) -> G {
        Side::apply(point, error)
    }

    #[inline]
    fn difference(state: &G, point: &G) -> Result<SVector<f64, N>, EstimatorError> {
        Side::error(point, state)
    }

    #[inline]
    fn transport(shift: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        Side::transport::<G, N, D>(shift)
    }

    fn check(point: &G) -> Result<(), EstimatorError> {
        crate::inzsmf::check_element(point)
    }
}
