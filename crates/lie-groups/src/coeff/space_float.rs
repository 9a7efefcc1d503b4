//! Rotations of space over `f64`: unit quaternions, and their coefficients from the even functions of half the angle.
//!
//! With `X = (t/2)^2`, `q = sin h / h`, `G = (1 - q) / X`, `J = (q - cos h) / X`, `K = (3 J - q) / X`, `L = (2 G - J) / X`:
//!
//! ```text
//! b = q^2 / 2    c = (G + q (G + J)) / 4    beta = -q J / 4    gamma = -(L (1 + q) + J (G + J) + q K) / 16
//! e = J / (4 q)  eta = (J^2 / q^2 - K / q) / 16
//! ```
//!
//! All are sums of terms of one sign up to a half turn, except `eta`, which loses a digit at most. None needs a square root of `t^2`.

use super::even::Even;
use super::float::TERMS;
use super::{ScaledMaps, SpaceCoeff, space_scaled};
use crate::triples::{conjugate, cross, quaternion_product, squared};
use crate::{Coeff, GroupError};

/// `(-1)^m w_m / (2m + 5)!` with `w_m = (2m + 2)(2m + 4)` or `2m + 2`: the series of `K` and `L`.
const fn series(weighted: bool) -> [f64; TERMS] {
    let mut c = [0.0; TERMS];
    let mut factorial: u128 = 120;
    let mut m = 0;
    while m < TERMS {
        let weight = ((2 * m + 2) * if weighted { 2 * m + 4 } else { 1 }) as f64;
        let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
        c[m] = sign * weight / factorial as f64;
        factorial *= ((2 * m + 6) * (2 * m + 7)) as u128;
        m += 1;
    }
    c
}

const K: [f64; TERMS] = series(true);
const L: [f64; TERMS] = series(false);

/// `pi^2`, up to which the series serve.
const HALF_TURN: f64 = 9.869_604_401_089_358;

/// The functions of half the angle, from `x = t^2`.
#[inline]
fn half(x: f64) -> Even {
    let square = 0.25 * x;
    if x <= HALF_TURN {
        Even::series(square)
    } else {
        let h = square.sqrt();
        let (sin, cos) = h.sin_cos();
        Even::closed(square, sin / h, cos)
    }
}

#[inline]
fn k_of(half: &Even) -> f64 {
    if 4.0 * half.square <= HALF_TURN {
        super::float::polynomial(&K, half.square)
    } else {
        (3.0 * half.bessel - half.q) / half.square
    }
}

#[inline]
fn l_of(half: &Even) -> f64 {
    if 4.0 * half.square <= HALF_TURN {
        super::float::polynomial(&L, half.square)
    } else {
        (2.0 * half.gap - half.bessel) / half.square
    }
}

#[inline]
fn bc_of(half: &Even) -> [f64; 2] {
    let Even { q, gap, bessel, .. } = *half;
    [0.5 * q * q, 0.25 * (gap + q * (gap + bessel))]
}

/// `v + 2 q_w (q x v) + 2 q x (q x v)`.
#[inline]
fn turned(real: f64, vector: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    let double = cross(vector, v).map(|x| 2.0 * x);
    let twice = cross(vector, double);
    std::array::from_fn(|k| v[k] + real * double[k] + twice[k])
}

/// `q` brought back to length 1 to first order.
#[inline]
fn near_unit(q: [f64; 4]) -> [f64; 4] {
    let norm = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    let scale = 1.5 - 0.5 * norm;
    q.map(|x| x * scale)
}

/// Quaternion of a rotation matrix, not scaled: of the four formulas the one with the largest divisor.
pub(super) fn quaternion_of(m: &[[f64; 3]; 3]) -> [f64; 4] {
    let trace = m[0][0] + m[1][1] + m[2][2];
    let diagonal = [trace, m[0][0], m[1][1], m[2][2]];
    let largest = (0..4).fold(0, |best, k| if diagonal[k] > diagonal[best] { k } else { best });
    let odd = |i: usize, j: usize| m[i][j] - m[j][i];
    let even = |i: usize, j: usize| m[i][j] + m[j][i];
    match largest {
        0 => [1.0 + trace, odd(2, 1), odd(0, 2), odd(1, 0)],
        1 => [odd(2, 1), 1.0 + m[0][0] - m[1][1] - m[2][2], even(0, 1), even(0, 2)],
        2 => [odd(0, 2), even(0, 1), 1.0 - m[0][0] + m[1][1] - m[2][2], even(1, 2)],
        _ => [odd(1, 0), even(0, 2), even(1, 2), 1.0 - m[0][0] - m[1][1] + m[2][2]],
    }
}

impl SpaceCoeff for f64 {
    /// `(w, x, y, z)`.
    type Spin = [f64; 4];

    #[inline]
    fn spin(w: [f64; 3]) -> [f64; 4] {
        Self::spin_bc(w).0
    }

    #[inline]
    fn spin_bc(w: [f64; 3]) -> ([f64; 4], [f64; 2]) {
        let half = half(squared(&w));
        let k = 0.5 * half.q;
        ([half.cos, k * w[0], k * w[1], k * w[2]], bc_of(&half))
    }

    #[inline]
    fn spin_log(spin: &[f64; 4]) -> Result<([f64; 3], f64), GroupError> {
        let [real, x, y, z] = *spin;
        let sine = squared(&[x, y, z]).sqrt();
        if !(real.abs() + sine).is_finite() {
            return Err(GroupError::NotFinite { index: 0 });
        }
        // q and -q are one rotation: the half with a positive real part has the angle below pi.
        let h = sine.atan2(real.abs());
        let factor = if sine > 0.0 { 2.0 * h / sine } else { 2.0 / real.abs() };
        let factor = if real < 0.0 { -factor } else { factor };
        let half = Even::series(h * h);
        Ok(([factor * x, factor * y, factor * z], 0.25 * half.bessel / half.q))
    }

    #[inline]
    fn spin_product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
        near_unit(quaternion_product(a, b))
    }

    #[inline]
    fn spin_reverse(spin: &[f64; 4]) -> [f64; 4] {
        conjugate(spin)
    }

    #[inline]
    fn spin_matrix(spin: &[f64; 4]) -> [[f64; 3]; 3] {
        let [w, x, y, z] = *spin;
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, yy, zz) = (x * x2, y * y2, z * z2);
        let (xy, xz, yz) = (x * y2, x * z2, y * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        [[1.0 - (yy + zz), xy - wz, xz + wy], [xy + wz, 1.0 - (xx + zz), yz - wx], [xz - wy, yz + wx, 1.0 - (xx + yy)]]
    }

    #[inline]
    fn spin_act(spin: &[f64; 4], v: [f64; 3]) -> [f64; 3] {
        let [w, x, y, z] = *spin;
        turned(w, [x, y, z], v)
    }

    #[inline]
    fn spin_act_inv(spin: &[f64; 4], v: [f64; 3]) -> [f64; 3] {
        let [w, x, y, z] = *spin;
        turned(-w, [x, y, z], v)
    }

    #[inline]
    fn spin_quaternion(spin: &[f64; 4]) -> [f64; 4] {
        *spin
    }

    fn spin_from_quaternion(q: [f64; 4]) -> Result<[f64; 4], GroupError> {
        for (index, x) in q.iter().enumerate() {
            x.check_finite(index)?;
        }
        let largest = q.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if largest == 0.0 {
            return Err(GroupError::NotARotation);
        }
        // Scaled first: the norm of subnormal or huge parts would lose digits or overflow.
        let q = q.map(|x| x / largest);
        let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        Ok(q.map(|x| x / norm))
    }

    fn spin_from_matrix(m: [[f64; 3]; 3]) -> Result<[f64; 4], GroupError> {
        for (index, x) in m.iter().flatten().enumerate() {
            x.check_finite(index)?;
        }
        Self::spin_from_quaternion(quaternion_of(&m))
    }

    #[inline]
    fn bc(x: f64) -> [f64; 2] {
        bc_of(&half(x))
    }

    #[inline]
    fn bc_slopes(x: f64) -> [f64; 4] {
        let half = half(x);
        let [b, c] = bc_of(&half);
        let Even { q, gap, bessel, .. } = half;
        let gamma = l_of(&half) * (1.0 + q) + bessel * (gap + bessel) + q * k_of(&half);
        [b, c, -0.25 * q * bessel, -0.0625 * gamma]
    }

    #[inline]
    fn e_slope(x: f64) -> Result<[f64; 2], GroupError> {
        x.check_finite(0)?;
        let half = half(x);
        if x > std::f64::consts::TAU * std::f64::consts::TAU {
            let theta = x.sqrt();
            return Err(GroupError::FullTurn { theta_lo_rad: theta, theta_hi_rad: theta });
        }
        let recip = 1.0 / half.q;
        let ratio = half.bessel * recip;
        Ok([0.25 * ratio, 0.0625 * (ratio * ratio - k_of(&half) * recip)])
    }

    fn scaled_maps(s: f64, x: f64) -> ScaledMaps<f64> {
        space_scaled::at_point(s, x)
    }
}
