//! What a group needs to be the frame of a two-frame group.

use nalgebra::{SMatrix, SVector};

use crate::small::{negated, times};
use crate::{Coeff, Complex, GroupError, LieGroup, SO2};

/// A frame with the maps that carry vectors along: `(g, V(w), V(-w))` of an exponential, `(w, V(w)^-1, V(-w)^-1)` of a logarithm.
pub type WithMaps<T, S, const D: usize> = (T, SMatrix<S, D, D>, SMatrix<S, D, D>);

/// Parts of a left Jacobian: `Jl(w)` (`DG x DG`), `V(w)` (`D x D`) and what the coupling blocks need; or the inverses of them.
pub type JacobianParts<S, T, const D: usize, const DG: usize> = (SMatrix<S, DG, DG>, SMatrix<S, D, D>, T);

/// A group of dimension `DG` acting linearly on `R^D`: rotations, or rotations with a scale.
///
/// `g * v` is the action ([`LieGroup::act`]), `w*` the matrix of an algebra element, `B(v)` the matrix with `B(v) w = w* v`
/// ([`LieGroup::act_jacobian`]), and `V(w) = phi_1(w*)`. From these a [`TwoFrame`](crate::TwoFrame) is built; the trait is implemented by
/// [`SO2`], [`ScaledSO2`](crate::ScaledSO2), [`SO3`](crate::SO3) and [`ScaledSO3`](crate::ScaledSO3).
///
/// **Source:** the coupling block `Q(w, u) = d_w [V(w) u] - B(V(w) u) Jl(w)` is block (2, 1) of `phi_1(ad)`; Barfoot, State Estimation for
/// Robotics, section 7.1 for SE(3).
pub trait FrameGroup<S: Coeff, const D: usize, const DG: usize>: LieGroup<S, DG, D> {
    /// What [`coupling`](Self::coupling) needs beside the vector.
    type Slopes: Copy;

    /// What [`coupling_inv`](Self::coupling_inv) needs beside the vector.
    type InverseSlopes: Copy;

    /// `g^-1 * v`.
    fn act_inv(&self, v: &SVector<S, D>) -> SVector<S, D>;

    /// The matrix `w*` (`D x D`) of the action of an algebra element.
    fn rep(w: &SVector<S, DG>) -> SMatrix<S, D, D>;

    /// `(exp w, V(w), V(-w))`.
    fn exp_maps(w: &SVector<S, DG>) -> WithMaps<Self, S, D>;

    /// `(log g, V(w)^-1, V(-w)^-1)` at `w = log g`.
    ///
    /// # Errors
    /// Those of [`LieGroup::log`].
    fn log_maps(&self) -> Result<WithMaps<SVector<S, DG>, S, D>, GroupError>;

    /// `Jl(w)`, `V(w)` and what `Q` needs.
    fn jl_parts(w: &SVector<S, DG>) -> JacobianParts<S, Self::Slopes, D, DG>;

    /// `Q(w, u)` (`D x DG`): the block of the left Jacobian that couples a vector to the frame.
    fn coupling(slopes: &Self::Slopes, u: &SVector<S, D>) -> SMatrix<S, D, DG>;

    /// `Jl(w)^-1`, `V(w)^-1` and what `Q^-1` needs.
    ///
    /// # Errors
    /// Those of [`LieGroup::jl_inv`].
    fn jl_inv_parts(w: &SVector<S, DG>) -> Result<JacobianParts<S, Self::InverseSlopes, D, DG>, GroupError>;

    /// `-V(w)^-1 Q(w, u) Jl(w)^-1` (`D x DG`): the coupling block of the inverse left Jacobian.
    fn coupling_inv(slopes: &Self::InverseSlopes, u: &SVector<S, D>) -> SMatrix<S, D, DG>;

    /// `-B(v) Ad_g` (`D x DG`): the coupling block of the adjoint.
    #[inline]
    fn coupling_adjoint(&self, v: &SVector<S, D>) -> SMatrix<S, D, DG> {
        negated(&times(&Self::act_jacobian(v), &self.adjoint()))
    }
}

impl<S: Coeff> FrameGroup<S, 2, 1> for SO2<S> {
    /// `phi_2(i theta)`.
    type Slopes = Complex<S>;

    /// `psi_2(i theta)`.
    type InverseSlopes = Complex<S>;

    #[inline]
    fn act_inv(&self, v: &SVector<S, 2>) -> SVector<S, 2> {
        (self.unit().conj() * Complex::from_vector(v)).to_vector()
    }

    #[inline]
    fn rep(w: &SVector<S, 1>) -> SMatrix<S, 2, 2> {
        Complex::new(S::zero(), w[0]).to_matrix()
    }

    #[inline]
    fn exp_maps(w: &SVector<S, 1>) -> WithMaps<Self, S, 2> {
        let (turn, phi1) = S::exp_phi1(w[0]);
        (turn.into(), phi1.to_matrix(), phi1.conj().to_matrix())
    }

    #[inline]
    fn log_maps(&self) -> Result<WithMaps<SVector<S, 1>, S, 2>, GroupError> {
        let (theta, psi1) = S::log_psi1(self.turn())?;
        Ok((SVector::<S, 1>::new(theta), psi1.to_matrix(), psi1.conj().to_matrix()))
    }

    #[inline]
    fn jl_parts(w: &SVector<S, 1>) -> JacobianParts<S, Complex<S>, 2, 1> {
        let (phi1, phi2) = S::phi1_phi2(w[0]);
        (Self::jl(w), phi1.to_matrix(), phi2)
    }

    /// `-i phi_2 u`.
    #[inline]
    fn coupling(phi2: &Complex<S>, u: &SVector<S, 2>) -> SMatrix<S, 2, 1> {
        (Complex::new(phi2.im, -phi2.re) * Complex::from_vector(u)).to_vector()
    }

    #[inline]
    fn jl_inv_parts(w: &SVector<S, 1>) -> Result<JacobianParts<S, Complex<S>, 2, 1>, GroupError> {
        let (psi1, psi2) = S::psi1_psi2(w[0])?;
        Ok((Self::jl(w), psi1.to_matrix(), psi2))
    }

    /// `i psi_2 u`.
    #[inline]
    fn coupling_inv(psi2: &Complex<S>, u: &SVector<S, 2>) -> SMatrix<S, 2, 1> {
        (psi2.times_i() * Complex::from_vector(u)).to_vector()
    }

    #[inline]
    fn coupling_adjoint(&self, v: &SVector<S, 2>) -> SMatrix<S, 2, 1> {
        SVector::<S, 2>::new(v[1], -v[0])
    }
}
