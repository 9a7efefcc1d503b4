//! The few functions of an angle that a plane group needs beyond arithmetic.

mod float;
mod interval;
mod unit_angle;

use scalars::Scalar;

use crate::{Complex, GroupError};

/// A scalar with the coefficient functions of exponentials and Jacobians.
///
/// With `phi_k(z) = sum_j z^j / (j + k)!` the exponential of a plane group needs `e^z` and `phi_1`, its left Jacobian
/// `phi_1` and `phi_2`, and the inverses need `psi_1 = 1 / phi_1` and `psi_2 = (1 - psi_1) / z`. Rotation groups use them on the imaginary
/// axis `z = i theta`, where they read
///
/// | function | real part (even) | imaginary part (odd) |
/// |---|---|---|
/// | `e^(i t)` | `cos t` | `sin t` |
/// | `phi_1(i t)` | `sin t / t` | `(1 - cos t) / t` |
/// | `phi_2(i t)` | `(1 - cos t) / t^2` | `(t - sin t) / t^2` |
/// | `psi_1(i t)` | `(t/2) cot(t/2)` | `-t/2` |
/// | `psi_2(i t)` | `1/2` | `-(1 - (t/2) cot(t/2)) / t` |
///
/// None of them has a singularity at 0. A group whose frame also scales uses the same functions at `z = s + i theta`.
///
/// **Guarantee:** over `f64` at most a few units in the last place of error relative to the modulus, at every scale; over
/// `Interval` supersets of the range over the box, within a few units in the last place for a point.
/// **Source:** Iserles, Munthe-Kaas, Norsett, Zanna, Lie-group methods, Acta Numerica 2000 (the functions `phi_k`).
pub trait Coeff: Scalar {
    /// `(e^(i theta), phi_1(i theta))`, valid for every angle.
    fn exp_phi1(theta: Self) -> (Complex<Self>, Complex<Self>);

    /// `e^(i theta)`, valid for every angle.
    fn cis(theta: Self) -> Complex<Self>;

    /// `(phi_1(i theta), phi_2(i theta))`, valid for every angle.
    fn phi1_phi2(theta: Self) -> (Complex<Self>, Complex<Self>);

    /// `(psi_1(i theta), psi_2(i theta))` for `|theta| < 2 pi`.
    ///
    /// # Errors
    /// [`GroupError::FullTurn`] if the angle can reach the pole at `2 pi`, [`GroupError::NotFinite`] for NaN.
    fn psi1_psi2(theta: Self) -> Result<(Complex<Self>, Complex<Self>), GroupError>;

    /// Principal angle of a unit complex number, and `psi_1(i theta)` of it.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] for NaN, infinite, empty or unbounded parts; over intervals [`GroupError::HalfTurn`] if the box contains -1
    /// and [`GroupError::NotARotation`] if it is proven to miss the unit circle.
    fn log_psi1(unit: Complex<Self>) -> Result<(Self, Complex<Self>), GroupError>;

    /// Principal angle of a unit complex number: the first part of [`log_psi1`](Self::log_psi1), with the same errors.
    fn angle(unit: Complex<Self>) -> Result<Self, GroupError>;

    /// A product of unit complex numbers brought back to the unit circle to first order in the rounding error.
    ///
    /// Over `f64`: `z (3 - |z|^2) / 2`, which squares the deviation `|z| - 1`, so that products of any length stay within a few units
    /// in the last place of the circle. Over intervals: intersection with `[-1, 1]^2`.
    fn near_unit(z: Complex<Self>) -> Complex<Self>;

    /// The rotation nearest to `z`: `z / |z|` over `f64`, the part of the box in `[-1, 1]^2` over intervals.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] for NaN, infinite, empty or unbounded parts, [`GroupError::NotARotation`] for `z = 0` or a box proven to
    /// miss the unit circle.
    fn unit(z: Complex<Self>) -> Result<Complex<Self>, GroupError>;

    /// Errors unless the number is finite (over intervals: bounded and not empty).
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] with the given index.
    fn check_finite(self, index: usize) -> Result<(), GroupError>;
}
