//! R^n: the vector space as a group under addition.

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::lie_group::checked_vee;
use crate::{Coeff, GroupError, LieGroup};

/// A translation of `R^N` by the vector `x`.
///
/// - **Tangent:** `xi = x`, the `N` coordinates.
/// - **Storage:** the vector.
/// - **Acts on** points of `R^N`: `p + x`.
/// - **Matrix:** `[I x; 0 1]`, `hat(xi) = [0 x; 0 0]`, both of size `N + 1`.
/// - `exp` and `log` are the identity map; the group is commutative: `Ad = I`, `ad = 0`, `Jl = Jr = I`.
///
/// It lets one filter or one integrator serve vector spaces and groups alike.
///
/// ```
/// use lie_groups::{LieGroup, Rn};
/// use nalgebra::Vector3;
///
/// let a = Rn::new(Vector3::new(1.0, 2.0, 3.0));
/// let half = Rn::interpolate(&Rn::identity(), &a, 0.5)?;
/// assert_eq!(half.vector(), Vector3::new(0.5, 1.0, 1.5));
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rn<S: Coeff, const N: usize> {
    vector: SVector<S, N>,
}

impl<S: Coeff, const N: usize> Rn<S, N> {
    /// The translation by `x`.
    #[inline]
    pub fn new(x: SVector<S, N>) -> Self {
        Self { vector: x }
    }

    /// The vector `x`.
    #[inline]
    pub fn vector(&self) -> SVector<S, N> {
        self.vector
    }
}

/// The identity matrix, for scalars that nalgebra knows nothing of.
#[inline]
fn identity_matrix<S: Coeff, const N: usize>() -> SMatrix<S, N, N> {
    SMatrix::from_fn(|row, col| if row == col { S::one() } else { S::zero() })
}

impl<S: Coeff, const N: usize> LieGroup<S, N, N> for Rn<S, N> {
    #[inline]
    fn identity() -> Self {
        Self { vector: SVector::from_element(S::zero()) }
    }

    #[inline]
    fn exp(xi: &SVector<S, N>) -> Self {
        Self { vector: *xi }
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, N>, GroupError> {
        for (index, x) in self.vector.iter().enumerate() {
            x.check_finite(index)?;
        }
        Ok(self.vector)
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        Self { vector: self.vector.zip_map(&other.vector, |a, b| a + b) }
    }

    #[inline]
    fn inverse(&self) -> Self {
        Self { vector: self.vector.map(|v| -v) }
    }

    #[inline]
    fn act(&self, p: &SVector<S, N>) -> SVector<S, N> {
        self.vector.zip_map(p, |a, b| a + b)
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, N, N> {
        identity_matrix()
    }

    #[inline]
    fn act_jacobian(_p: &SVector<S, N>) -> SMatrix<S, N, N> {
        identity_matrix()
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, N, N> {
        identity_matrix()
    }

    #[inline]
    fn ad(_xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        SMatrix::from_element(S::zero())
    }

    #[inline]
    fn jl(_xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        identity_matrix()
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, N>) -> Result<SMatrix<S, N, N>, GroupError> {
        for (index, x) in xi.iter().enumerate() {
            x.check_finite(index)?;
        }
        Ok(identity_matrix())
    }

    fn hat(xi: &SVector<S, N>) -> DMatrix<S> {
        DMatrix::from_fn(N + 1, N + 1, |row, col| if col == N && row < N { xi[row] } else { S::zero() })
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, N>, GroupError> {
        checked_vee(matrix, N + 1, |m| SVector::from_fn(|row, _| m[(row, N)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        DMatrix::from_fn(N + 1, N + 1, |row, col| match (row, col) {
            (row, col) if row == col => S::one(),
            (row, col) if row < N && col == N => self.vector[row],
            _ => S::zero(),
        })
    }
}
