//! The functions of a rotation vector that the groups of space need beyond arithmetic.

use std::fmt::Debug;

use scalars::Scalar;

use crate::GroupError;

/// Coefficients of functions of `Z = s I + W` (`W = w x`, the cross product with a rotation vector) in the basis `I, W, W^2`.
#[derive(Clone, Copy, Debug)]
pub struct ScaledMaps<S> {
    /// `phi_1(Z) = a I + b W + c W^2`.
    pub phi1: [S; 3],
    /// `phi_2(Z)`, likewise.
    pub phi2: [S; 3],
    /// Derivatives of `b` and `c` of `phi_1` by `x = |w|^2`.
    pub slope: [S; 2],
}

/// A scalar with the coefficient functions of rotations of space: functions of the squared angle `x = |w|^2 = t^2`, smooth across 0.
///
/// | function | closed form | at 0 |
/// |---|---|---|
/// | `b` | `(1 - cos t) / t^2` | `1/2` |
/// | `c` | `(t - sin t) / t^3` | `1/6` |
/// | `beta = 2 db/dx` | `(t sin t + 2 cos t - 2) / t^4` | `-1/12` |
/// | `gamma = 2 dc/dx` | `(3 sin t - 2 t - t cos t) / t^5` | `-1/60` |
/// | `e` | `(1 - (t/2) cot(t/2)) / t^2` | `1/12` |
/// | `eta = 2 de/dx` | | `1/360` |
///
/// With them `V(w) = I + b W + c W^2` and `V(w)^-1 = I - W/2 + e W^2`; the others give the derivatives of both by `w`.
///
/// **Guarantee:** over `f64` a few units in the last place of relative error up to a full turn, beyond which the rounding of `t` counts as well; over
/// `Interval` supersets of the range.
/// **Source:** Barfoot, State Estimation for Robotics, sections 7.1.4 and 7.1.5.
pub trait SpaceCoeff: Scalar {
    /// A rotation of space as it is stored: a unit quaternion over `f64`, a [`SpinSet`](crate::SpinSet) over `Interval`.
    type Spin: Copy + Debug + PartialEq;

    /// The rotation by the vector `w`, for every `w`; over `f64` NaN where `|w|^2` overflows.
    fn spin(w: [Self; 3]) -> Self::Spin;

    /// The rotation by the vector `w` with `(b, c)` of it.
    fn spin_bc(w: [Self; 3]) -> (Self::Spin, [Self; 2]);

    /// Rotation vector of length below `pi`, and `e` of it.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] for NaN, infinite, empty rotations; over intervals [`GroupError::HalfTurn`] if the angle can reach `pi`.
    fn spin_log(spin: &Self::Spin) -> Result<([Self; 3], Self), GroupError>;

    /// Product of two rotations.
    ///
    /// Over `f64` the product is brought back to length 1 to first order, as for rotations of the plane. Over intervals see [`SpinSet`](crate::SpinSet).
    fn spin_product(a: &Self::Spin, b: &Self::Spin) -> Self::Spin;

    /// Inverse rotation.
    fn spin_reverse(spin: &Self::Spin) -> Self::Spin;

    /// Rotation matrix, by rows.
    fn spin_matrix(spin: &Self::Spin) -> [[Self; 3]; 3];

    /// `R v`.
    fn spin_act(spin: &Self::Spin, v: [Self; 3]) -> [Self; 3];

    /// `R^T v`.
    fn spin_act_inv(spin: &Self::Spin, v: [Self; 3]) -> [Self; 3];

    /// Unit quaternion `(w, x, y, z)`.
    fn spin_quaternion(spin: &Self::Spin) -> [Self; 4];

    /// The rotation of the direction of a quaternion `(w, x, y, z)`.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`], or [`GroupError::NotARotation`] for the zero quaternion.
    fn spin_from_quaternion(q: [Self; 4]) -> Result<Self::Spin, GroupError>;

    /// The rotation of a matrix, by rows; over intervals all rotations with their matrix in the box.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`], or [`GroupError::NotARotation`] if no quaternion comes out.
    fn spin_from_matrix(m: [[Self; 3]; 3]) -> Result<Self::Spin, GroupError>;

    /// `(b, c)`.
    fn bc(x: Self) -> [Self; 2];

    /// `(b, c, beta, gamma)`.
    fn bc_slopes(x: Self) -> [Self; 4];

    /// `(e, eta)` for `t < 2 pi`.
    ///
    /// # Errors
    /// [`GroupError::FullTurn`] if the angle can reach the pole at `2 pi`, [`GroupError::NotFinite`] for NaN.
    fn e_slope(x: Self) -> Result<[Self; 2], GroupError>;

    /// Functions of `s I + W`.
    fn scaled_maps(s: Self, x: Self) -> ScaledMaps<Self>;
}
