//! SO(3): rotations of space.

use nalgebra::{DMatrix, SMatrix, SVector};
use scalars::Scalar;

use crate::frame_group::{JacobianParts, WithMaps};
use crate::lie_group::checked_vee;
use crate::triples::{dot, squared};
use crate::{Coeff, FrameGroup, GroupError, LieGroup};

/// A rotation of space by the vector `w`: about its direction by its length.
///
/// - **Tangent:** `xi = (w1, w2, w3)`, radians.
/// - **Storage:** over `f64` a unit quaternion (products of any length stay within a few units in the last place of length 1), over `Interval` a
///   [`SpinSet`](crate::SpinSet): the rotations `exp(d) R_0` with `d` in a box and a ball, of which the ball does not wrap.
/// - **Acts on** points of `R^3`: `R p`.
/// - **Matrix:** `R`, `hat(w) = W` with `W v = w x v`.
///
/// | operation | formula, `t = |w|`, coefficients of [`SpaceCoeff`](crate::SpaceCoeff) |
/// |---|---|
/// | `exp w` | quaternion `(cos(t/2), sin(t/2)/t w)` |
/// | `Ad_R`, `ad_w` | `R`, `W` |
/// | `Jl(w) = V(w)` | `I + b W + c W^2` |
/// | `Jl(w)^-1` | `I - W/2 + e W^2` |
///
/// **Source:** Sola, Deray, Atchuthan, A micro Lie theory, arXiv 1812.01537.
///
/// ```
/// use lie_groups::{LieGroup, SO3};
/// use nalgebra::Vector3;
///
/// let turn = SO3::exp(&Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
/// assert!((turn.act(&Vector3::x()) - Vector3::y()).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SO3<S: Coeff> {
    spin: S::Spin,
}

/// `v x`: the matrix of the cross product.
#[inline]
pub(crate) fn skew<S: Scalar>(v: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
    let o = S::zero();
    SMatrix::<S, 3, 3>::new(o, -v[2], v[1], v[2], o, -v[0], -v[1], v[0], o)
}

/// `I + b W + c W^2`.
#[inline]
pub(crate) fn rodrigues<S: Scalar>(w: &SVector<S, 3>, b: S, c: S) -> SMatrix<S, 3, 3> {
    let one = S::one();
    let (xx, yy, zz) = (w[0].sqr(), w[1].sqr(), w[2].sqr());
    let (bx, by, bz) = (b * w[0], b * w[1], b * w[2]);
    let (cx, cy) = (c * w[0], c * w[1]);
    let (xy, xz, yz) = (cx * w[1], cx * w[2], cy * w[2]);
    SMatrix::<S, 3, 3>::new(
        one - c * (yy + zz),
        xy - bz,
        xz + by,
        xy + bz,
        one - c * (xx + zz),
        yz - bx,
        xz - by,
        yz + bx,
        one - c * (xx + yy),
    )
}

impl<S: Coeff> SO3<S> {
    /// The rotation of the direction of a quaternion `(w, x, y, z)`; over `f64` scaled to length 1, over `Interval` all rotations of directions in the box.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`], or [`GroupError::NotARotation`] for the zero quaternion.
    pub fn from_quaternion(w: S, x: S, y: S, z: S) -> Result<Self, GroupError> {
        Ok(Self { spin: S::spin_from_quaternion([w, x, y, z])? })
    }

    /// The rotation of a matrix; over `f64` the nearest to it to first order, over `Interval` all rotations with their matrix in the box.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`], or [`GroupError::NotARotation`] if the matrix is too far from a rotation to have a quaternion.
    pub fn from_matrix(m: &SMatrix<S, 3, 3>) -> Result<Self, GroupError> {
        let rows = std::array::from_fn(|row| std::array::from_fn(|col| m[(row, col)]));
        Ok(Self { spin: S::spin_from_matrix(rows)? })
    }

    /// Unit quaternion `(w, x, y, z)`.
    #[inline]
    pub fn quaternion(&self) -> [S; 4] {
        S::spin_quaternion(&self.spin)
    }

    /// The rotation as stored.
    #[inline]
    pub fn spin(&self) -> &S::Spin {
        &self.spin
    }

    /// A rotation from its storage.
    #[inline]
    pub(crate) fn from_spin(spin: S::Spin) -> Self {
        Self { spin }
    }

    /// Rotation matrix.
    #[inline]
    pub fn rotation_matrix(&self) -> SMatrix<S, 3, 3> {
        let rows = S::spin_matrix(&self.spin);
        SMatrix::from_fn(|row, col| rows[row][col])
    }
}

#[inline]
fn array<S: Scalar>(v: &SVector<S, 3>) -> [S; 3] {
    [v[0], v[1], v[2]]
}

#[inline]
fn vector<S: Scalar>([x, y, z]: [S; 3]) -> SVector<S, 3> {
    SVector::<S, 3>::new(x, y, z)
}

impl<S: Coeff> LieGroup<S, 3, 3> for SO3<S> {
    #[inline]
    fn identity() -> Self {
        Self { spin: S::spin([S::zero(); 3]) }
    }

    #[inline]
    fn exp(xi: &SVector<S, 3>) -> Self {
        Self { spin: S::spin(array(xi)) }
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, 3>, GroupError> {
        Ok(vector(S::spin_log(&self.spin)?.0))
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        Self { spin: S::spin_product(&self.spin, &other.spin) }
    }

    #[inline]
    fn inverse(&self) -> Self {
        Self { spin: S::spin_reverse(&self.spin) }
    }

    #[inline]
    fn act(&self, p: &SVector<S, 3>) -> SVector<S, 3> {
        vector(S::spin_act(&self.spin, array(p)))
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, 3, 3> {
        self.rotation_matrix()
    }

    /// `-P`, the matrix of `w -> w x p`.
    #[inline]
    fn act_jacobian(p: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        skew(&p.map(|v| -v))
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, 3, 3> {
        self.rotation_matrix()
    }

    #[inline]
    fn ad(xi: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        skew(xi)
    }

    #[inline]
    fn jl(xi: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let [b, c] = S::bc(squared(xi));
        rodrigues(xi, b, c)
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, 3>) -> Result<SMatrix<S, 3, 3>, GroupError> {
        let [e, _] = S::e_slope(squared(xi))?;
        Ok(rodrigues(xi, S::from_f64(-0.5), e))
    }

    fn hat(xi: &SVector<S, 3>) -> DMatrix<S> {
        let w = skew(xi);
        DMatrix::from_fn(3, 3, |row, col| w[(row, col)])
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, 3>, GroupError> {
        checked_vee(matrix, 3, |m| SVector::<S, 3>::new(m[(2, 1)], m[(0, 2)], m[(1, 0)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        let r = self.rotation_matrix();
        DMatrix::from_fn(3, 3, |row, col| r[(row, col)])
    }
}

/// What the coupling block of the rotation vector `w` needs: `w` and `(b, c, beta, gamma)`.
pub type SpinSlopes<S> = (SVector<S, 3>, [S; 4]);

/// What its inverse needs: `w` and `(e, eta)`.
pub type SpinInverseSlopes<S> = (SVector<S, 3>, [S; 2]);

impl<S: Coeff> FrameGroup<S, 3, 3> for SO3<S> {
    type Slopes = SpinSlopes<S>;
    type InverseSlopes = SpinInverseSlopes<S>;

    #[inline]
    fn act_inv(&self, v: &SVector<S, 3>) -> SVector<S, 3> {
        vector(S::spin_act_inv(&self.spin, array(v)))
    }

    #[inline]
    fn rep(w: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        skew(w)
    }

    #[inline]
    fn exp_maps(w: &SVector<S, 3>) -> WithMaps<Self, S, 3> {
        let (spin, [b, c]) = S::spin_bc(array(w));
        let v = rodrigues(w, b, c);
        (Self { spin }, v, v.transpose())
    }

    #[inline]
    fn log_maps(&self) -> Result<WithMaps<SVector<S, 3>, S, 3>, GroupError> {
        let (w, e) = S::spin_log(&self.spin)?;
        let w = vector(w);
        let inverse = rodrigues(&w, S::from_f64(-0.5), e);
        Ok((w, inverse, inverse.transpose()))
    }

    #[inline]
    fn jl_parts(w: &SVector<S, 3>) -> JacobianParts<S, SpinSlopes<S>, 3, 3> {
        let coefficients = S::bc_slopes(squared(w));
        let v = rodrigues(w, coefficients[0], coefficients[1]);
        (v, v, (*w, coefficients))
    }

    /// The derivative of `V(w + eps u)`, since `ad` of SE(3) is `W` over dual numbers:
    /// `b U + c (u w^T + w u^T) + (w . u) (beta W + gamma w w^T + (c - b) I)`.
    #[inline]
    fn coupling((w, [b, c, beta, gamma]): &SpinSlopes<S>, u: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let along = dot(w, u);
        let (turn, stretch, diagonal) = (along * *beta, along * *gamma, along * (*c - *b));
        // The antisymmetric part is the cross product with this vector.
        let odd = skew(&SVector::<S, 3>::from_fn(|k, _| *b * u[k] + turn * w[k]));
        // c (u w^T + w u^T) + stretch w w^T = m w^T + w m^T.
        let half = stretch.scale(0.5);
        let m = SVector::<S, 3>::from_fn(|k, _| *c * u[k] + half * w[k]);
        SMatrix::from_fn(|row, col| {
            let even = m[row] * w[col] + w[row] * m[col];
            if row == col { even + diagonal } else { even + odd[(row, col)] }
        })
    }

    #[inline]
    fn jl_inv_parts(w: &SVector<S, 3>) -> Result<JacobianParts<S, SpinInverseSlopes<S>, 3, 3>, GroupError> {
        let [e, eta] = S::e_slope(squared(w))?;
        let inverse = rodrigues(w, S::from_f64(-0.5), e);
        Ok((inverse, inverse, (*w, [e, eta])))
    }

    /// The derivative of `V(w + eps u)^-1`: `-U/2 + e (W U + U W) + eta (w . u) W^2`,
    /// `W U + U W = u w^T + w u^T - 2 (w . u) I`.
    #[inline]
    fn coupling_inv((w, [e, eta]): &SpinInverseSlopes<S>, u: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let along = dot(w, u);
        let stretch = along * *eta;
        let half = stretch.scale(0.5);
        let odd = skew(&u.map(|x| x.scale(-0.5)));
        let m = SVector::<S, 3>::from_fn(|k, _| *e * u[k] + half * w[k]);
        let diagonal = along * e.scale(2.0) + stretch * squared(w);
        SMatrix::from_fn(|row, col| {
            let even = m[row] * w[col] + w[row] * m[col];
            if row == col { even - diagonal } else { even + odd[(row, col)] }
        })
    }
}
