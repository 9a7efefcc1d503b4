//! The functions `phi_k`, `psi_k` of a frame of the plane that turns and scales: at `z = s + i theta`.

use scalars::Scalar;

use crate::{Complex, GroupError};

/// A number and its counterpart at `-z`: `(f(z), f(-z))`. Fixed-frame vectors need the first, body-frame vectors the second.
pub type BothSigns<S> = (Complex<S>, Complex<S>);

/// A scalar with the coefficient functions of a plane group whose frame also scales.
///
/// `phi_k(z) = sum_j z^j / (j + k)!` and `psi_1 = 1 / phi_1`, `psi_2 = phi_2 / phi_1 = (1 - psi_1) / z` at `z = s + i theta`,
/// `s` the logarithm of the scale. On `s = 0` they are the functions of [`Coeff`](crate::Coeff).
///
/// **Guarantee:** over `f64` a few units in the last place of error relative to the modulus, at every scale of `z` and without
/// a threshold below a half turn; over `Interval` supersets of the range over the box, to first order as wide as it.
pub trait ScaledCoeff: Scalar {
    /// `phi_1(z)` and `phi_1(-z)`, for every `z`.
    fn scaled_phi1(s: Self, theta: Self) -> BothSigns<Self>;

    /// `phi_1(z)` and `phi_2(z)`, for every `z`.
    fn scaled_phi1_phi2(s: Self, theta: Self) -> (Complex<Self>, Complex<Self>);

    /// `psi_1(z)` and `psi_1(-z)` for `|theta| < 2 pi`.
    ///
    /// # Errors
    /// [`GroupError::FullTurn`] if the angle can reach the pole at `2 pi`, [`GroupError::NotFinite`] (0 for `theta`, 1 for `s`).
    fn scaled_psi1(s: Self, theta: Self) -> Result<BothSigns<Self>, GroupError>;

    /// `psi_1(z)` and `psi_2(z)` for `|theta| < 2 pi`.
    ///
    /// # Errors
    /// Those of [`scaled_psi1`](Self::scaled_psi1).
    fn scaled_psi1_psi2(s: Self, theta: Self) -> Result<(Complex<Self>, Complex<Self>), GroupError>;
}
