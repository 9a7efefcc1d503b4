//! SE(2): rigid motions of the plane.

use nalgebra::{DMatrix, SMatrix, SVector};
use scalars::Scalar;

use crate::lie_group::checked_vee;
use crate::{Coeff, Complex, GroupError, LieGroup, SO2};

/// A rigid motion of the plane: a rotation `R` followed by a translation `x`.
///
/// - **Tangent:** `xi = (theta, u1, u2)`: angle in radians first, then the translational part `u`.
/// - **Storage:** the [`SO2`] of `R` and the translation `x`.
/// - **Acts on** points of `R^2`: `R p + x`.
/// - **Matrix:** `[R x; 0 1]`, `hat(xi) = [0 -theta u1; theta 0 u2; 0 0 0]`.
///
/// With the plane as complex numbers, `z = i theta` and the functions of [`Coeff`]:
///
/// | operation | formula |
/// |---|---|
/// | `exp xi` | `R = e^z`, `x = phi_1(z) u` |
/// | `log X` | `theta = arg R`, `u = psi_1(z) x` |
/// | `X Y` | `(R_X R_Y, x_X + R_X x_Y)` |
/// | `X^-1` | `(R^-1, -R^-1 x)` |
/// | `Ad_X` | `[1 0; -i x, R]` |
/// | `ad_xi` | `[0 0; -i u, z]` |
/// | `Jl(xi)` | `[1 0; -i phi_2(z) u, phi_1(z)]` |
/// | `Jl(xi)^-1` | `[1 0; i psi_2(z) u, psi_1(z)]` |
///
/// Over `f64` the rotation of every product is brought back to the unit circle to first order ([`Coeff::product`]); it does not
/// drift. Over `Interval` an element is the set of motions with an angle in an arc and a translation in a box, and every
/// operation returns a superset of the image of that set.
///
/// **Source:** paper 000, section II-B and IV (SE(2)); Sola, Deray, Atchuthan, A micro Lie theory, arXiv 1812.01537.
///
/// ```
/// use lie_groups::{LieGroup, SE2};
/// use nalgebra::Vector3;
/// use scalars::Interval;
///
/// // All poses after a step of 1 +- 0.01 m with a turn of 0 +- 0.05 rad: no division by the angle, valid across 0.
/// let step = Vector3::new(Interval::new(-0.05, 0.05)?, Interval::new(0.99, 1.01)?, Interval::ZERO);
/// let pose = SE2::exp(&step);
/// assert!(pose.translation()[1].subset_of(&Interval::new(-0.0253, 0.0253)?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SE2<S: Coeff> {
    rotation: SO2<S>,
    translation: Complex<S>,
}

impl<S: Coeff> SE2<S> {
    /// The motion `p -> R p + x`.
    #[inline]
    pub fn new(rotation: SO2<S>, translation: &SVector<S, 2>) -> Self {
        Self { rotation, translation: Complex::from_vector(translation) }
    }

    /// The pose with heading `theta_rad` at the position `(x1, x2)`.
    #[inline]
    pub fn from_pose(theta_rad: S, x1: S, x2: S) -> Self {
        Self { rotation: SO2::from_angle(theta_rad), translation: Complex::new(x1, x2) }
    }

    /// The rotation `R`.
    #[inline]
    pub fn rotation(&self) -> SO2<S> {
        self.rotation
    }

    /// The translation `x`: the position of a pose.
    #[inline]
    pub fn translation(&self) -> SVector<S, 2> {
        self.translation.to_vector()
    }
}

/// The matrix `[first 0; column, block]` of a Jacobian or adjoint.
#[inline]
fn block_lower<S: Scalar>(first: S, column: Complex<S>, block: Complex<S>) -> SMatrix<S, 3, 3> {
    let o = S::zero();
    SMatrix::<S, 3, 3>::new(first, o, o, column.re, block.re, -block.im, column.im, block.im, block.re)
}

/// The translational part `u` of a tangent vector.
#[inline]
fn translational<S: Scalar>(xi: &SVector<S, 3>) -> Complex<S> {
    Complex::new(xi[1], xi[2])
}

impl<S: Coeff> LieGroup<S, 3, 2> for SE2<S> {
    #[inline]
    fn identity() -> Self {
        Self { rotation: SO2::identity(), translation: Complex::new(S::zero(), S::zero()) }
    }

    #[inline]
    fn exp(xi: &SVector<S, 3>) -> Self {
        let (turn, phi1) = S::exp_phi1(xi[0]);
        Self { rotation: turn.into(), translation: phi1 * translational(xi) }
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, 3>, GroupError> {
        let (theta, psi1) = S::log_psi1(self.rotation.turn())?;
        self.translation.re.check_finite(2)?;
        self.translation.im.check_finite(3)?;
        let u = psi1 * self.translation;
        Ok(SVector::<S, 3>::new(theta, u.re, u.im))
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        let turned = self.rotation.unit() * other.translation;
        let translation = Complex::new(self.translation.re + turned.re, self.translation.im + turned.im);
        Self { rotation: self.rotation.compose(&other.rotation), translation }
    }

    #[inline]
    fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        let back = rotation.unit() * self.translation;
        Self { rotation, translation: Complex::new(-back.re, -back.im) }
    }

    #[inline]
    fn act(&self, p: &SVector<S, 2>) -> SVector<S, 2> {
        let turned = self.rotation.unit() * Complex::from_vector(p);
        SVector::<S, 2>::new(turned.re + self.translation.re, turned.im + self.translation.im)
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, 2, 2> {
        self.rotation.unit().to_matrix()
    }

    /// `[i p, I]`.
    #[inline]
    fn act_jacobian(p: &SVector<S, 2>) -> SMatrix<S, 2, 3> {
        SMatrix::<S, 2, 3>::new(-p[1], S::one(), S::zero(), p[0], S::zero(), S::one())
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, 3, 3> {
        // -i x
        block_lower(S::one(), Complex::new(self.translation.im, -self.translation.re), self.rotation.unit())
    }

    #[inline]
    fn ad(xi: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        block_lower(S::zero(), Complex::new(xi[2], -xi[1]), Complex::new(S::zero(), xi[0]))
    }

    #[inline]
    fn jl(xi: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let (phi1, phi2) = S::phi1_phi2(xi[0]);
        // -i phi_2, so that no product has to be turned afterwards.
        let column = Complex::new(phi2.im, -phi2.re) * translational(xi);
        block_lower(S::one(), column, phi1)
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, 3>) -> Result<SMatrix<S, 3, 3>, GroupError> {
        let (psi1, psi2) = S::psi1_psi2(xi[0])?;
        let column = psi2.times_i() * translational(xi);
        Ok(block_lower(S::one(), column, psi1))
    }

    fn hat(xi: &SVector<S, 3>) -> DMatrix<S> {
        let (theta, o) = (xi[0], S::zero());
        DMatrix::from_row_slice(3, 3, &[o, -theta, xi[1], theta, o, xi[2], o, o, o])
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, 3>, GroupError> {
        checked_vee(matrix, 3, |m| SVector::<S, 3>::new(m[(1, 0)], m[(0, 2)], m[(1, 2)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        let (unit, x) = (self.rotation.unit(), self.translation);
        let (o, l) = (S::zero(), S::one());
        DMatrix::from_row_slice(3, 3, &[unit.re, -unit.im, x.re, unit.im, unit.re, x.im, o, o, l])
    }
}
