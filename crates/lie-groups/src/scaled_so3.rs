//! SO(3) x R+: rotations of space with a scale.

use nalgebra::{DMatrix, SMatrix, SVector};
use scalars::Scalar;

use crate::frame_group::{JacobianParts, WithMaps};
use crate::lie_group::checked_vee;
use crate::small::{apply, negated, part, put, sum, times};
use crate::so3::{rodrigues, skew};
use crate::triples::{dot, squared};
use crate::{Coeff, FrameGroup, GroupError, LieGroup, RPlus, SO3, ScaledMaps};

/// A rotation of space by the vector `w` and a scaling by `e^s`.
///
/// - **Tangent:** `xi = (w1, w2, w3, s)`: rotation vector in radians, then the logarithm of the scale.
/// - **Storage:** an [`SO3`] and an [`RPlus`].
/// - **Acts on** points of `R^3`: `e^s R p`.
/// - **Matrix:** `e^s R`, `hat(xi) = W + s I`. `Ad = [R 0; 0 1]`, `Jl = [V(w) 0; 0 1]`.
/// - `V(xi) = phi_1(s I + W) = a I + b W + c W^2`, coefficients from [`SpaceCoeff::scaled_maps`](crate::SpaceCoeff::scaled_maps).
///
/// ```
/// use lie_groups::{LieGroup, RPlus, SO3, ScaledSO3};
/// use nalgebra::Vector3;
///
/// let frame = ScaledSO3::new(SO3::exp(&Vector3::new(0.0, 0.0, 1.0)), RPlus::from_scale(2.0)?);
/// assert!((frame.act(&Vector3::z()) - Vector3::new(0.0, 0.0, 2.0)).norm() < 1e-15);
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaledSO3<S: Coeff> {
    rotation: SO3<S>,
    scaling: RPlus<S>,
}

impl<S: Coeff> ScaledSO3<S> {
    /// The map `p -> scale R p`.
    #[inline]
    pub fn new(rotation: SO3<S>, scaling: RPlus<S>) -> Self {
        Self { rotation, scaling }
    }

    /// The rotation `R`.
    #[inline]
    pub fn rotation(&self) -> SO3<S> {
        self.rotation
    }

    /// The scaling `e^s`.
    #[inline]
    pub fn scaling(&self) -> RPlus<S> {
        self.scaling
    }
}

/// `[block 0; 0 last]`.
#[inline]
fn with_last<S: Scalar>(block: &SMatrix<S, 3, 3>, last: S) -> SMatrix<S, 4, 4> {
    let mut matrix = SMatrix::from_element(S::zero());
    put(&mut matrix, 0, 0, block);
    matrix[(3, 3)] = last;
    matrix
}

/// `[left, right]`.
#[inline]
fn beside<S: Scalar>(left: &SMatrix<S, 3, 3>, right: &SVector<S, 3>) -> SMatrix<S, 3, 4> {
    SMatrix::from_fn(|row, col| if col < 3 { left[(row, col)] } else { right[row] })
}

/// `a I + b W + c W^2`.
#[inline]
fn combined<S: Scalar>(w: &SVector<S, 3>, [a, b, c]: [S; 3]) -> SMatrix<S, 3, 3> {
    let mut matrix = rodrigues(w, b, c);
    for k in 0..3 {
        // The diagonal of rodrigues is 1 - c (..): written anew, so that no 1 is added and taken off.
        let others = w[(k + 1) % 3].sqr() + w[(k + 2) % 3].sqr();
        matrix[(k, k)] = a - c * others;
    }
    matrix
}

/// Coefficients of the inverse of `a I + b W + c W^2`, `x = |w|^2`.
#[inline]
fn inverted<S: Scalar>([a, b, c]: [S; 3], x: S) -> [S; 3] {
    let d = a - x * c;
    let det = d.sqr() + x * b.sqr();
    [a.recip(), -b / det, (b.sqr() - c * d) / (a * det)]
}

impl<S: Coeff> LieGroup<S, 4, 3> for ScaledSO3<S> {
    #[inline]
    fn identity() -> Self {
        Self { rotation: SO3::identity(), scaling: RPlus::identity() }
    }

    #[inline]
    fn exp(xi: &SVector<S, 4>) -> Self {
        Self { rotation: SO3::exp(&part(xi, 0)), scaling: RPlus::from_log(xi[3]) }
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, 4>, GroupError> {
        let (w, s) = (self.rotation.log()?, self.scaling.log_scale());
        s.check_finite(3)?;
        Ok(SVector::<S, 4>::new(w[0], w[1], w[2], s))
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
    fn act(&self, p: &SVector<S, 3>) -> SVector<S, 3> {
        let scale = self.scaling.scale();
        self.rotation.act(p).map(|v| scale * v)
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, 3, 3> {
        let scale = self.scaling.scale();
        self.rotation.rotation_matrix().map(|v| scale * v)
    }

    /// `[-P, p]`.
    #[inline]
    fn act_jacobian(p: &SVector<S, 3>) -> SMatrix<S, 3, 4> {
        beside(&SO3::act_jacobian(p), p)
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, 4, 4> {
        with_last(&self.rotation.rotation_matrix(), S::one())
    }

    #[inline]
    fn ad(xi: &SVector<S, 4>) -> SMatrix<S, 4, 4> {
        with_last(&skew(&part(xi, 0)), S::zero())
    }

    #[inline]
    fn jl(xi: &SVector<S, 4>) -> SMatrix<S, 4, 4> {
        with_last(&SO3::jl(&part(xi, 0)), S::one())
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, 4>) -> Result<SMatrix<S, 4, 4>, GroupError> {
        xi[3].check_finite(3)?;
        Ok(with_last(&SO3::jl_inv(&part(xi, 0))?, S::one()))
    }

    fn hat(xi: &SVector<S, 4>) -> DMatrix<S> {
        let w = Self::rep(xi);
        DMatrix::from_fn(3, 3, |row, col| w[(row, col)])
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, 4>, GroupError> {
        checked_vee(matrix, 3, |m| SVector::<S, 4>::new(m[(2, 1)], m[(0, 2)], m[(1, 0)], m[(0, 0)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        let r = self.act_linear();
        DMatrix::from_fn(3, 3, |row, col| r[(row, col)])
    }
}

/// What the coupling blocks need: the rotation vector and its `Jl`, the functions of `s I + W`.
#[derive(Clone, Copy, Debug)]
pub struct ScaledSlopes<S> {
    w: SVector<S, 3>,
    jl: SMatrix<S, 3, 3>,
    v: SMatrix<S, 3, 3>,
    maps: ScaledMaps<S>,
}

/// The same with the inverses of `Jl` and `V`.
#[derive(Clone, Copy, Debug)]
pub struct ScaledInverseSlopes<S> {
    forth: ScaledSlopes<S>,
    jl_inv: SMatrix<S, 4, 4>,
    v_inv: SMatrix<S, 3, 3>,
}

impl<S: Coeff> FrameGroup<S, 3, 4> for ScaledSO3<S> {
    type Slopes = ScaledSlopes<S>;
    type InverseSlopes = ScaledInverseSlopes<S>;

    #[inline]
    fn act_inv(&self, v: &SVector<S, 3>) -> SVector<S, 3> {
        let scale = self.scaling.scale();
        self.rotation.act_inv(v).map(|x| x / scale)
    }

    #[inline]
    fn rep(xi: &SVector<S, 4>) -> SMatrix<S, 3, 3> {
        let mut matrix = skew(&part(xi, 0));
        for k in 0..3 {
            matrix[(k, k)] = xi[3];
        }
        matrix
    }

    #[inline]
    fn exp_maps(xi: &SVector<S, 4>) -> WithMaps<Self, S, 3> {
        let (w, s) = (part(xi, 0), xi[3]);
        let x = squared(&w);
        let forth = combined(&w, S::scaled_maps(s, x).phi1);
        let back = combined(&negated(&w), S::scaled_maps(-s, x).phi1);
        (Self::exp(xi), forth, back)
    }

    #[inline]
    fn log_maps(&self) -> Result<WithMaps<SVector<S, 4>, S, 3>, GroupError> {
        let xi = self.log()?;
        let (w, s) = (part(&xi, 0), xi[3]);
        let x = squared(&w);
        let forth = combined(&w, inverted(S::scaled_maps(s, x).phi1, x));
        let back = combined(&negated(&w), inverted(S::scaled_maps(-s, x).phi1, x));
        Ok((xi, forth, back))
    }

    #[inline]
    fn jl_parts(xi: &SVector<S, 4>) -> JacobianParts<S, ScaledSlopes<S>, 3, 4> {
        let w = part(xi, 0);
        let maps = S::scaled_maps(xi[3], squared(&w));
        let (jl, v) = (SO3::jl(&w), combined(&w, maps.phi1));
        (with_last(&jl, S::one()), v, ScaledSlopes { w, jl, v, maps })
    }

    /// `[d_w (V u) + (V u) x Jl(w), -phi_2 u]`.
    #[inline]
    fn coupling(slopes: &ScaledSlopes<S>, u: &SVector<S, 3>) -> SMatrix<S, 3, 4> {
        let ScaledSlopes { w, jl, v, maps } = slopes;
        let ([_, b, c], [b_x, c_x]) = (maps.phi1, maps.slope);
        let along = dot(w, u);
        let normal = apply(&skew(w), u);
        let twice = apply(&skew(w), &normal);
        // V u = a u + b w x u + c w x (w x u), where d (w x (w x u)) = (w . u) I + w u^T - 2 u w^T.
        let slope = SVector::<S, 3>::from_fn(|k, _| (b_x * normal[k] + c_x * twice[k] - c * u[k]).scale(2.0));
        let odd = skew(&u.map(|x| -(b * x)));
        let derivative = SMatrix::<S, 3, 3>::from_fn(|row, col| {
            let outer = c * w[row] * u[col] + slope[row] * w[col];
            if row == col { outer + c * along } else { outer + odd[(row, col)] }
        });
        let moved = sum(&derivative, &times(&skew(&apply(v, u)), jl));
        beside(&moved, &negated(&apply(&combined(w, maps.phi2), u)))
    }

    #[inline]
    fn jl_inv_parts(xi: &SVector<S, 4>) -> Result<JacobianParts<S, ScaledInverseSlopes<S>, 3, 4>, GroupError> {
        let jl_inv = Self::jl_inv(xi)?;
        let (_, _, forth) = Self::jl_parts(xi);
        let v_inv = combined(&forth.w, inverted(forth.maps.phi1, squared(&forth.w)));
        Ok((jl_inv, v_inv, ScaledInverseSlopes { forth, jl_inv, v_inv }))
    }

    #[inline]
    fn coupling_inv(slopes: &ScaledInverseSlopes<S>, u: &SVector<S, 3>) -> SMatrix<S, 3, 4> {
        let forth = Self::coupling(&slopes.forth, u);
        negated(&times(&times(&slopes.v_inv, &forth), &slopes.jl_inv))
    }
}
