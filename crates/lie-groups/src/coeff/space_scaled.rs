//! Functions of `Z = s I + W`, rotations of space that also scale, at a point: over `f64`, and over intervals with rigorous rounding.
//!
//! With `phi_1(Z) = a1 I + b1 W + c1 W^2` and `phi_2(Z) = a2 I + b2 W + c2 W^2`, `W^3 = -x W` turns `Z phi_1 = e^Z - I` and `Z phi_2 = phi_1 - I` into
//!
//! ```text
//! [s -x; 1 s] [b1; c1] = [e^s sin t / t - a1; e^s (1 - cos t) / t^2]      [s -x; 1 s] [b2; c2] = [b1 - a2; c1]
//! ```
//!
//! of determinant `s^2 + x`, solved where that is above 1; below, the power series is summed by Horner's rule in the basis `I, W, W^2`.

use scalars::Scalar;

use super::ScaledMaps;

/// Terms of the series; with `s^2 + x <= 1` the rest, spread over the basis, is below `1e-18`.
const TERMS: usize = 20;

/// `phi_1(s)` and `phi_2(s)` of a number.
pub(super) fn real_phi<S: Scalar>(s: f64) -> [S; 2] {
    let at = S::from_f64(s);
    if s.abs() > 1.0 {
        let phi1 = at.exp().add_f64(-1.0) / at;
        return [phi1, phi1.add_f64(-1.0) / at];
    }
    // phi_2 = (1 + s/3 (1 + s/4 (..))) / 2; every bracket is below 1.1.
    let sum = (0..TERMS).rev().fold(S::lit(-1.1, 1.1), |sum, j| (sum * at / S::from_f64((j + 3) as f64)).add_f64(1.0));
    let phi2 = sum.scale(0.5);
    [(phi2 * at).add_f64(1.0), phi2]
}

/// All functions at one point, `x >= 0`.
pub(super) fn at_point<S: Scalar>(s: f64, x: f64) -> ScaledMaps<S> {
    let (at, square) = (S::from_f64(s), S::from_f64(x));
    if s * s + x > 1.0 {
        return closed(at, square, real_phi(s));
    }
    // phi_2(Z) = (I + Z/3 (I + Z/4 (..))) / 2, with the derivatives of its coefficients by x. The brackets are means of e^(r Z), 0 <= r <= 1:
    // their coefficients are below 3.
    let tail = S::lit(-3.0, 3.0);
    let (mut a, mut b, mut c, mut b_x, mut c_x) = (tail, tail, tail, tail, tail);
    for j in (0..TERMS).rev() {
        let divisor = S::from_f64((j + 3) as f64);
        let (next_b, next_c) = (at * b + a - square * c, at * c + b);
        let (next_b_x, next_c_x) = (at * b_x - c - square * c_x, at * c_x + b_x);
        a = (at * a / divisor).add_f64(1.0);
        (b, c, b_x, c_x) = (next_b / divisor, next_c / divisor, next_b_x / divisor, next_c_x / divisor);
    }
    let [a, b, c, b_x, c_x] = [a, b, c, b_x, c_x].map(|v| v.scale(0.5));
    ScaledMaps {
        phi1: [(at * a).add_f64(1.0), at * b + a - square * c, at * c + b],
        phi2: [a, b, c],
        slope: [at * b_x - c - square * c_x, at * c_x + b_x],
    }
}

/// The closed forms, for `s^2 + x` away from 0, given `phi_1(s)` and `phi_2(s)`.
pub(super) fn closed<S: Scalar>(s: S, x: S, [a1, a2]: [S; 2]) -> ScaledMaps<S> {
    let grown = s.exp();
    let [sine, b, c, d] = [1, 2, 3, 4].map(|k| x.stumpff(k));
    let det = s.sqr() + x;
    // Solves [s -x; 1 s] y = (p, q).
    let solve = |p: S, q: S| [(s * p + x * q) / det, (s * q - p) / det];
    let [b1, c1] = solve(grown * sine - a1, grown * b);
    let [b2, c2] = solve(b1 - a2, c1);
    // The first system differentiated by x.
    let (sine_x, b_x) = ((c - b).scale(0.5), d - c.scale(0.5));
    let slope = solve(grown * sine_x + c1, grown * b_x);
    ScaledMaps { phi1: [a1, b1, c1], phi2: [a2, b2, c2], slope }
}
