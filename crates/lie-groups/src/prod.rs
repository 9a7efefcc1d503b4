//! Direct products of groups.

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::small::{part, put};
use crate::{Coeff, GroupError, LieGroup, Rn, SE2};

/// A pair of elements that know nothing of each other: `(a, b) (c, d) = (a c, b d)`.
///
/// - **Tangent:** the coordinates of the first factor, then those of the second; `N = NA + NB`, checked when the type is used.
/// - **Acts on** the points of the first factor; the second acts by itself, `product.second().act(..)`.
/// - **Matrix:** `[A 0; 0 B]`.
///
/// More factors by nesting. With [`Rn`] as the second factor it is the group of an "imperfect" invariant filter: biases and lever arms that are added, beside a pose.
///
/// ```
/// use lie_groups::{LieGroup, ImperfectSE2, Prod, Rn, SE2};
/// use nalgebra::Vector3;
///
/// // A pose with a scale factor and a lever arm that are merely added.
/// let state: ImperfectSE2<f64, 3, 6> = Prod::new(SE2::from_pose(0.1, 1.0, 2.0), Rn::new(Vector3::new(1.0, 0.5, 0.3)));
/// assert!(state.compose(&state.inverse()).log()?.norm() < 1e-15);
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prod<A, B, const NA: usize, const NB: usize, const DB: usize, const N: usize> {
    first: A,
    second: B,
}

/// SE(2) beside `M` coordinates that are added, `N = 3 + M`.
pub type ImperfectSE2<S, const M: usize, const N: usize> = Prod<SE2<S>, Rn<S, M>, 3, M, M, N>;

impl<A, B, const NA: usize, const NB: usize, const DB: usize, const N: usize> Prod<A, B, NA, NB, DB, N> {
    const SIZES: () = assert!(N == NA + NB, "the tangent of a product has NA + NB coordinates");

    /// The pair.
    #[inline]
    pub fn new(first: A, second: B) -> Self {
        let () = Self::SIZES;
        Self { first, second }
    }

    /// The first factor.
    #[inline]
    pub fn first(&self) -> &A {
        &self.first
    }

    /// The second factor.
    #[inline]
    pub fn second(&self) -> &B {
        &self.second
    }
}

/// `[a 0; 0 b]`.
#[inline]
fn diagonal<S: Coeff, const NA: usize, const NB: usize, const N: usize>(
    a: &SMatrix<S, NA, NA>,
    b: &SMatrix<S, NB, NB>,
) -> SMatrix<S, N, N> {
    let mut matrix = SMatrix::from_element(S::zero());
    put(&mut matrix, 0, 0, a);
    put(&mut matrix, NA, NA, b);
    matrix
}

fn dynamic_diagonal<S: Coeff>(a: &DMatrix<S>, b: &DMatrix<S>) -> DMatrix<S> {
    let (m, n) = (a.nrows(), b.nrows());
    DMatrix::from_fn(m + n, m + n, |row, col| match (row < m, col < m) {
        (true, true) => a[(row, col)],
        (false, false) => b[(row - m, col - m)],
        _ => S::zero(),
    })
}

/// The coordinates of an error of the second factor counted in those of the pair.
fn shifted(error: GroupError, by: usize) -> GroupError {
    match error {
        GroupError::NotFinite { index } => GroupError::NotFinite { index: index + by },
        other => other,
    }
}

impl<S, A, B, const NA: usize, const NB: usize, const DA: usize, const DB: usize, const N: usize> LieGroup<S, N, DA>
    for Prod<A, B, NA, NB, DB, N>
where
    S: Coeff,
    A: LieGroup<S, NA, DA>,
    B: LieGroup<S, NB, DB>,
{
    #[inline]
    fn identity() -> Self {
        Self::new(A::identity(), B::identity())
    }

    #[inline]
    fn exp(xi: &SVector<S, N>) -> Self {
        let () = Self::SIZES;
        Self::new(A::exp(&part(xi, 0)), B::exp(&part(xi, NA)))
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, N>, GroupError> {
        let first = self.first.log()?;
        let second = self.second.log().map_err(|error| shifted(error, NA))?;
        Ok(SVector::from_fn(|row, _| if row < NA { first[row] } else { second[row - NA] }))
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        Self { first: self.first.compose(&other.first), second: self.second.compose(&other.second) }
    }

    #[inline]
    fn inverse(&self) -> Self {
        Self { first: self.first.inverse(), second: self.second.inverse() }
    }

    #[inline]
    fn act(&self, p: &SVector<S, DA>) -> SVector<S, DA> {
        self.first.act(p)
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, DA, DA> {
        self.first.act_linear()
    }

    #[inline]
    fn act_jacobian(p: &SVector<S, DA>) -> SMatrix<S, DA, N> {
        let first = A::act_jacobian(p);
        SMatrix::from_fn(|row, col| if col < NA { first[(row, col)] } else { S::zero() })
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, N, N> {
        diagonal(&self.first.adjoint(), &self.second.adjoint())
    }

    #[inline]
    fn ad(xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        let () = Self::SIZES;
        diagonal(&A::ad(&part(xi, 0)), &B::ad(&part(xi, NA)))
    }

    #[inline]
    fn jl(xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        let () = Self::SIZES;
        diagonal(&A::jl(&part(xi, 0)), &B::jl(&part(xi, NA)))
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, N>) -> Result<SMatrix<S, N, N>, GroupError> {
        let () = Self::SIZES;
        let second = B::jl_inv(&part(xi, NA)).map_err(|error| shifted(error, NA))?;
        Ok(diagonal(&A::jl_inv(&part(xi, 0))?, &second))
    }

    fn hat(xi: &SVector<S, N>) -> DMatrix<S> {
        let () = Self::SIZES;
        dynamic_diagonal(&A::hat(&part(xi, 0)), &B::hat(&part(xi, NA)))
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, N>, GroupError> {
        let () = Self::SIZES;
        let zero = SVector::<S, N>::from_element(S::zero());
        let first_size = A::hat(&part(&zero, 0)).nrows();
        crate::lie_group::checked_vee(
            matrix,
            Self::hat(&zero).nrows(),
            |m| {
                let rest = m.nrows() - first_size;
                let first = A::vee(&m.view((0, 0), (first_size, first_size)).clone_owned());
                let second = B::vee(&m.view((first_size, first_size), (rest, rest)).clone_owned());
                // A block that breaks its pattern reads as 0, and the comparison that follows says where.
                let (first, second) = (first.unwrap_or(part(&zero, 0)), second.unwrap_or(part(&zero, NA)));
                SVector::from_fn(|row, _| if row < NA { first[row] } else { second[row - NA] })
            },
            Self::hat,
        )
    }

    fn matrix(&self) -> DMatrix<S> {
        dynamic_diagonal(&self.first.matrix(), &self.second.matrix())
    }
}
