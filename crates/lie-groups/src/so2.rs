//! SO(2): rotations of the plane.

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::lie_group::checked_vee;
use crate::{Coeff, Complex, GroupError, LieGroup, Turn};

/// A rotation of the plane by the angle `theta`.
///
/// - **Tangent:** `xi = (theta)`, radians.
/// - **Storage:** a [`Turn`]: the unit complex number `cos theta + i sin theta`, over intervals with the range of the angle.
/// - **Acts on** points of `R^2`: `R p`.
/// - **Matrix:** `R = [cos -sin; sin cos]`, `hat(xi) = [0 -theta; theta 0]`.
/// - The group is commutative: `Ad = I`, `ad = 0`, `Jl = Jr = I`.
///
/// Over `f64` every product is brought back to the unit circle to first order ([`Coeff::product`]), so that the norm stays within
/// a few units in the last place of 1 after any number of products. Over `Interval` an element is the set of rotations by the angles
/// of an arc; arcs of products are sums of arcs, so nothing but rounding is lost however many there are.
///
/// ```
/// use lie_groups::{LieGroup, SO2};
/// use nalgebra::{Vector1, Vector2};
///
/// let turn = SO2::exp(&Vector1::new(0.5));
/// let back = turn.compose(&turn).inverse();
/// assert!((back.log()?[0] + 1.0).abs() < 1e-15);
/// assert!((turn.act(&Vector2::new(1.0, 0.0)) - Vector2::new(0.5_f64.cos(), 0.5_f64.sin())).norm() < 1e-15);
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SO2<S: Coeff> {
    turn: Turn<S>,
}

impl<S: Coeff> SO2<S> {
    /// Rotation by an angle in radians; any angle.
    #[inline]
    pub fn from_angle(theta_rad: S) -> Self {
        Self { turn: S::turn(theta_rad) }
    }

    /// Rotation with the direction `cos + i sin`; over `f64` it is scaled to length 1, over `Interval` it is the set of
    /// rotations whose cosine and sine lie in the box.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] (index 0 the cosine, 1 the sine), or [`GroupError::NotARotation`] for `(0, 0)` or a box that misses the unit circle.
    pub fn from_cos_sin(cos: S, sin: S) -> Result<Self, GroupError> {
        Ok(Self { turn: S::direction(Complex::new(cos, sin))? })
    }

    /// The rotation as the unit complex number `cos theta + i sin theta`.
    #[inline]
    pub fn unit(&self) -> Complex<S> {
        self.turn.unit()
    }

    /// Angle in `(-pi, pi)` radians; over `f64` a half turn gives `pi` or `-pi` by the sign of the sine.
    ///
    /// # Errors
    /// Those of [`LieGroup::log`].
    #[inline]
    pub fn angle(&self) -> Result<S, GroupError> {
        S::angle(&self.turn)
    }

    /// The rotation as stored.
    #[inline]
    pub fn turn(&self) -> &Turn<S> {
        &self.turn
    }
}

impl<S: Coeff> From<Turn<S>> for SO2<S> {
    #[inline]
    fn from(turn: Turn<S>) -> Self {
        Self { turn }
    }
}

impl<S: Coeff> LieGroup<S, 1, 2> for SO2<S> {
    #[inline]
    fn identity() -> Self {
        Self::from_angle(S::zero())
    }

    #[inline]
    fn exp(xi: &SVector<S, 1>) -> Self {
        Self::from_angle(xi[0])
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, 1>, GroupError> {
        Ok(SVector::<S, 1>::new(self.angle()?))
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        Self { turn: S::product(&self.turn, &other.turn) }
    }

    #[inline]
    fn inverse(&self) -> Self {
        Self { turn: S::reverse(&self.turn) }
    }

    #[inline]
    fn act(&self, p: &SVector<S, 2>) -> SVector<S, 2> {
        (self.unit() * Complex::from_vector(p)).to_vector()
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, 2, 2> {
        self.unit().to_matrix()
    }

    #[inline]
    fn act_jacobian(p: &SVector<S, 2>) -> SMatrix<S, 2, 1> {
        Complex::from_vector(p).times_i().to_vector()
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(S::one())
    }

    #[inline]
    fn ad(_xi: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(S::zero())
    }

    #[inline]
    fn jl(_xi: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(S::one())
    }

    /// The identity: on a commutative group the Jacobian is invertible at every angle.
    #[inline]
    fn jl_inv(xi: &SVector<S, 1>) -> Result<SMatrix<S, 1, 1>, GroupError> {
        xi[0].check_finite(0)?;
        Ok(SMatrix::<S, 1, 1>::new(S::one()))
    }

    fn hat(xi: &SVector<S, 1>) -> DMatrix<S> {
        let theta = xi[0];
        DMatrix::from_row_slice(2, 2, &[S::zero(), -theta, theta, S::zero()])
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, 1>, GroupError> {
        checked_vee(matrix, 2, |m| SVector::<S, 1>::new(m[(1, 0)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        let Complex { re: cos, im: sin } = self.unit();
        DMatrix::from_row_slice(2, 2, &[cos, -sin, sin, cos])
    }
}
