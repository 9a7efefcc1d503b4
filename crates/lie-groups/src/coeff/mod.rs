//! The few functions of an angle that a plane group needs beyond arithmetic.

mod arc;
mod even;
mod float;
mod interval;
mod scaled;
mod scaled_float;
mod scaled_interval;
mod space;
mod space_float;
mod space_interval;
mod space_scaled;
mod spin_offset;
mod spin_set;

use std::fmt::Debug;

use scalars::Scalar;

pub use scaled::{BothSigns, ScaledCoeff};
pub use space::{ScaledMaps, SpaceCoeff};
pub use spin_set::SpinSet;

use crate::{Complex, GroupError, Turn};

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
/// None of them has a singularity at 0. Implemented for `f64` and `Interval`, and only for these. A group whose frame also scales uses the same functions at `z = s + i theta`: [`ScaledCoeff`].
///
/// **Guarantee:** over `f64` at most a few units in the last place of error relative to the modulus, at every scale; over
/// `Interval` supersets of the range over the box, within a few units in the last place for a point.
/// **Source:** Iserles, Munthe-Kaas, Norsett, Zanna, Lie-group methods, Acta Numerica 2000 (the functions `phi_k`).
pub trait Coeff: Scalar + ScaledCoeff + SpaceCoeff {
    /// What a rotation keeps beside its cosine and sine: nothing over `f64`, the range of its angle over `Interval`.
    type Arc: Copy + Debug + PartialEq;

    /// The rotation `e^(i theta)` and `phi_1(i theta)`, valid for every angle.
    fn exp_phi1(theta: Self) -> (Turn<Self>, Complex<Self>);

    /// The rotation `e^(i theta)`, valid for every angle.
    fn turn(theta: Self) -> Turn<Self>;

    /// `(phi_1(i theta), phi_2(i theta))`, valid for every angle.
    fn phi1_phi2(theta: Self) -> (Complex<Self>, Complex<Self>);

    /// `(psi_1(i theta), psi_2(i theta))` for `|theta| < 2 pi`.
    ///
    /// # Errors
    /// [`GroupError::FullTurn`] if the angle can reach the pole at `2 pi`, [`GroupError::NotFinite`] for NaN.
    fn psi1_psi2(theta: Self) -> Result<(Complex<Self>, Complex<Self>), GroupError>;

    /// Principal angle of a rotation, and `psi_1(i theta)` of it.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] for NaN, infinite, empty or unbounded rotations; over intervals [`GroupError::HalfTurn`] if the angle can
    /// reach `pi`.
    fn log_psi1(turn: &Turn<Self>) -> Result<(Self, Complex<Self>), GroupError>;

    /// Principal angle of a rotation: the first part of [`log_psi1`](Self::log_psi1), with the same errors.
    fn angle(turn: &Turn<Self>) -> Result<Self, GroupError>;

    /// Product of two rotations.
    ///
    /// Over `f64` the product `z` is brought back to the unit circle to first order, `z (3 - |z|^2) / 2`: this squares the deviation `|z| - 1`,
    /// so that products of any length stay within a few units in the last place of the circle. Over intervals angles add.
    fn product(a: &Turn<Self>, b: &Turn<Self>) -> Turn<Self>;

    /// Inverse rotation, exact.
    fn reverse(turn: &Turn<Self>) -> Turn<Self>;

    /// The rotation in the direction of `z`: `z / |z|` over `f64`, all rotations with cosine and sine in the box over intervals.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] for NaN, infinite, empty or unbounded parts, [`GroupError::NotARotation`] for `z = 0` or a box
    /// that misses the unit circle.
    fn direction(z: Complex<Self>) -> Result<Turn<Self>, GroupError>;

    /// Lower and upper bound: the number twice over `f64`.
    fn ends(self) -> (f64, f64);

    /// Errors unless the number is finite (over intervals: bounded and not empty).
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] with the given index.
    fn check_finite(self, index: usize) -> Result<(), GroupError>;
}
