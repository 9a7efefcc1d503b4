//! Outward rounding: the few bounds on floating-point errors that the proofs of this crate rest on.
//!
//! Arithmetic rounds to nearest, so the exact result of one operation lies within one step of the computed one; no
//! rounding mode is ever changed. Sources: Rump, *Error estimation of floating-point summation and dot product*, 2012;
//! Ogita, Rump, Oishi, *Accurate sum and dot product*, 2005.

/// Unit roundoff `u = 2^-53`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Far above the sum of all underflow errors of `2^48` products (each at most `2^-1075`).
pub(crate) const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// Upper bound of the relative error `gamma_k = k u / (1 - k u)` of `k` roundings, for `k <= 2^25`.
///
/// It is `(k + 2) u`: the surplus `2 u` covers the denominator, and the `k` roundings (and the few of the evaluation
/// itself) of a sum of moduli by which the factor is multiplied afterwards.
pub(crate) fn gamma_up(k: usize) -> f64 {
    (k + 3) as f64 * UNIT
}

/// Upper bound of the exact `a + b`.
pub(crate) fn add_up(a: f64, b: f64) -> f64 {
    (a + b).next_up()
}

/// Lower bound of the exact `a + b`.
pub(crate) fn add_down(a: f64, b: f64) -> f64 {
    (a + b).next_down()
}

/// Upper bound of the exact `a b`; an exact zero stays zero.
pub(crate) fn mul_up(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { (a * b).next_up() }
}

/// Lower bound of the exact `a b`; an exact zero stays zero.
pub(crate) fn mul_down(a: f64, b: f64) -> f64 {
    -mul_up(-a, b)
}

/// Upper bound of the exact sum of the moduli, `sum |a_j|`.
pub(crate) fn norm1_up(a: &[f64]) -> f64 {
    let sum: f64 = a.iter().map(|v| v.abs()).sum();
    // All partial sums are moduli: the exact sum is at most (1 + gamma) times the computed one. Sums never underflow.
    (sum * (1.0 + gamma_up(a.len()))).next_up()
}
