//! SO(2) x R+: rotations of the plane with a scale.

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::frame_group::{JacobianParts, WithMaps};
use crate::lie_group::checked_vee;
use crate::{Coeff, Complex, FrameGroup, GroupError, LieGroup, RPlus, SO2};

/// A rotation of the plane by `theta` and a scaling by `e^s`: multiplication by the complex number `e^z`, `z = s + i theta`.
///
/// - **Tangent:** `xi = (theta, s)`: angle in radians, then the logarithm of the scale.
/// - **Storage:** an [`SO2`] and an [`RPlus`].
/// - **Acts on** points of `R^2`: `e^s R p`.
/// - **Matrix:** `e^s R`, `hat(xi) = [s -theta; theta s]`. The group is commutative: `Ad = I`, `ad = 0`, `Jl = Jr = I`.
///
/// ```
/// use lie_groups::{LieGroup, ScaledSO2};
/// use nalgebra::Vector2;
///
/// let frame = ScaledSO2::exp(&Vector2::new(std::f64::consts::FRAC_PI_2, 2.0_f64.ln()));
/// assert!((frame.act(&Vector2::new(1.0, 0.0)) - Vector2::new(0.0, 2.0)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaledSO2<S: Coeff> {
    rotation: SO2<S>,
    scaling: RPlus<S>,
}

impl<S: Coeff> ScaledSO2<S> {
    /// The map `p -> scale R p`.
    #[inline]
    pub fn new(rotation: SO2<S>, scaling: RPlus<S>) -> Self {
        Self { rotation, scaling }
    }

    /// The rotation `R`.
    #[inline]
    pub fn rotation(&self) -> SO2<S> {
        self.rotation
    }

    /// The scaling `e^s`.
    #[inline]
    pub fn scaling(&self) -> RPlus<S> {
        self.scaling
    }

    /// `e^z` as a complex number.
    #[inline]
    pub fn complex(&self) -> Complex<S> {
        let (unit, scale) = (self.rotation.unit(), self.scaling.scale());
        Complex::new(scale * unit.re, scale * unit.im)
    }
}

fn identity<S: Coeff>() -> SMatrix<S, 2, 2> {
    Complex::new(S::one(), S::zero()).to_matrix()
}

/// The matrix `[f i u, f u]` of `w -> f (w* u)`.
#[inline]
fn columns<S: Coeff>(f: Complex<S>, u: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
    let product = f * Complex::from_vector(u);
    SMatrix::<S, 2, 2>::new(-product.im, product.re, product.re, product.im)
}

impl<S: Coeff> LieGroup<S, 2, 2> for ScaledSO2<S> {
    #[inline]
    fn identity() -> Self {
        Self { rotation: SO2::identity(), scaling: RPlus::identity() }
    }

    #[inline]
    fn exp(xi: &SVector<S, 2>) -> Self {
        Self { rotation: SO2::from_angle(xi[0]), scaling: RPlus::from_log(xi[1]) }
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, 2>, GroupError> {
        let s = self.scaling.log_scale();
        s.check_finite(1)?;
        Ok(SVector::<S, 2>::new(self.rotation.angle()?, s))
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        Self { rotation: self.rotation.compose(&other.rotation), scaling: self.scaling.compose(&other.scaling) }
    }

    #[inline]
    fn inverse(&self) -> Self {
        Self { rotation: self.rotation.inverse(), scaling: self.scaling.inverse() }
    }

    #[inline]
    fn act(&self, p: &SVector<S, 2>) -> SVector<S, 2> {
        (self.complex() * Complex::from_vector(p)).to_vector()
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, 2, 2> {
        self.complex().to_matrix()
    }

    /// `[i p, p]`.
    #[inline]
    fn act_jacobian(p: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::<S, 2, 2>::new(-p[1], p[0], p[0], p[1])
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, 2, 2> {
        identity()
    }

    #[inline]
    fn ad(_xi: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_element(S::zero())
    }

    #[inline]
    fn jl(_xi: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        identity()
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, 2>) -> Result<SMatrix<S, 2, 2>, GroupError> {
        xi[0].check_finite(0)?;
        xi[1].check_finite(1)?;
        Ok(identity())
    }

    fn hat(xi: &SVector<S, 2>) -> DMatrix<S> {
        let (theta, s) = (xi[0], xi[1]);
        DMatrix::from_row_slice(2, 2, &[s, -theta, theta, s])
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, 2>, GroupError> {
        checked_vee(matrix, 2, |m| SVector::<S, 2>::new(m[(1, 0)], m[(0, 0)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        let z = self.complex();
        DMatrix::from_row_slice(2, 2, &[z.re, -z.im, z.im, z.re])
    }
}

impl<S: Coeff> FrameGroup<S, 2, 2> for ScaledSO2<S> {
    /// `phi_2(z)`.
    type Slopes = Complex<S>;

    /// `psi_2(z)`.
    type InverseSlopes = Complex<S>;

    #[inline]
    fn act_inv(&self, v: &SVector<S, 2>) -> SVector<S, 2> {
        let turned = self.rotation.act_inv(v);
        let scale = self.scaling.scale();
        SVector::<S, 2>::new(turned[0] / scale, turned[1] / scale)
    }

    #[inline]
    fn rep(w: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        Complex::new(w[1], w[0]).to_matrix()
    }

    #[inline]
    fn exp_maps(w: &SVector<S, 2>) -> WithMaps<Self, S, 2> {
        let (forth, back) = S::scaled_phi1(w[1], w[0]);
        (Self::exp(w), forth.to_matrix(), back.to_matrix())
    }

    #[inline]
    fn log_maps(&self) -> Result<WithMaps<SVector<S, 2>, S, 2>, GroupError> {
        let w = self.log()?;
        let (forth, back) = S::scaled_psi1(w[1], w[0])?;
        Ok((w, forth.to_matrix(), back.to_matrix()))
    }

    #[inline]
    fn jl_parts(w: &SVector<S, 2>) -> JacobianParts<S, Complex<S>, 2, 2> {
        let (phi1, phi2) = S::scaled_phi1_phi2(w[1], w[0]);
        (identity(), phi1.to_matrix(), phi2)
    }

    /// `-phi_2 [i u, u]`.
    #[inline]
    fn coupling(phi2: &Complex<S>, u: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        columns(Complex::new(-phi2.re, -phi2.im), u)
    }

    #[inline]
    fn jl_inv_parts(w: &SVector<S, 2>) -> Result<JacobianParts<S, Complex<S>, 2, 2>, GroupError> {
        let (psi1, psi2) = S::scaled_psi1_psi2(w[1], w[0])?;
        Ok((identity(), psi1.to_matrix(), psi2))
    }

    /// `psi_2 [i u, u]`.
    #[inline]
    fn coupling_inv(psi2: &Complex<S>, u: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        columns(*psi2, u)
    }

    #[inline]
    fn coupling_adjoint(&self, v: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::<S, 2, 2>::new(v[1], -v[0], -v[0], -v[1])
    }
}
