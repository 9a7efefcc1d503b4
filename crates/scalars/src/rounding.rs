//! Directed rounding without changing the rounding mode: bounds of real results, computed to nearest and stepped outward.
//!
//! For a result `c` rounded to nearest, `e = |c| PHI + ETA` with `PHI = u (1 + 2u)`, `u = 2^-53`, `ETA = 2^-1074` gives
//! `c - e <= pred(c)` and `succ(c) <= c + e` after rounding to nearest, so `[c - e, c + e]` contains the exact result.
//! Exact zeros stay zero, infinite operands and overflow give the bound a real number can have, and NaN becomes the
//! infinite bound that is always true.
//!
//! **Source:** Rump, Zimmermann, Boldo, Melquiond, *Computing predecessor and successor in rounding to nearest*, BIT 49 (2009).

/// Unit roundoff of binary64, `2^-53`.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// The smallest positive binary64 number, `2^-1074`: half of it bounds the error of an underflow.
pub const ETA: f64 = f64::from_bits(1);

/// `u (1 + 2u)`: the factor of the step outward.
pub(crate) const PHI: f64 = UNIT_ROUNDOFF * (1.0 + f64::EPSILON);

/// The larger of two, the second if the first is NaN: one machine instruction.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The smaller of two, the second if the first is NaN: one machine instruction.
#[inline(always)]
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Length of the step outward from a finite result.
#[inline(always)]
pub(crate) fn outward(c: f64) -> f64 {
    c.abs() * PHI + ETA
}

/// Lower bound from a result rounded to nearest; zero is stepped too, NaN stays NaN.
#[inline(always)]
pub(crate) fn step_down(c: f64) -> f64 {
    let c = smaller(f64::MAX, c);
    c - outward(c)
}

/// Upper bound from a result rounded to nearest; zero is stepped too, NaN stays NaN.
#[inline(always)]
pub(crate) fn step_up(c: f64) -> f64 {
    let c = larger(f64::MIN, c);
    c + outward(c)
}

/// As [`step_down`] for results whose zeros are exact: zero stays zero.
#[inline(always)]
pub(crate) fn step_down_nonzero(c: f64) -> f64 {
    let c = smaller(f64::MAX, c);
    let a = c.abs();
    c - (a * PHI + smaller(ETA, a))
}

/// As [`step_up`] for results whose zeros are exact: zero stays zero.
#[inline(always)]
pub(crate) fn step_up_nonzero(c: f64) -> f64 {
    let c = larger(f64::MIN, c);
    let a = c.abs();
    c + (a * PHI + smaller(ETA, a))
}

/// `NaN` is replaced by the bound that is always true.
#[inline(always)]
fn or(bound: f64, always_true: f64) -> f64 {
    if bound.is_nan() { always_true } else { bound }
}

/// One step up: at least the successor of `c`, hence above every real number that rounds to `c`.
///
/// **Guarantee:** an upper bound; `up(NaN) = inf`, `up(-inf)` is finite (an overflowed real is above `-inf`).
#[inline]
#[must_use]
pub fn up(c: f64) -> f64 {
    or(step_up(c), f64::INFINITY)
}

/// One step down: at most the predecessor of `c`, hence below every real number that rounds to `c`.
///
/// **Guarantee:** a lower bound; `down(NaN) = -inf`, `down(inf)` is finite (an overflowed real is below `inf`).
#[inline]
#[must_use]
pub fn down(c: f64) -> f64 {
    or(step_down(c), f64::NEG_INFINITY)
}

/// Upper bound of `a + b`. A zero sum is exact and stays zero.
#[inline]
#[must_use]
pub fn add_up(a: f64, b: f64) -> f64 {
    or(step_up_nonzero(a + b), f64::INFINITY)
}

/// Lower bound of `a + b`. A zero sum is exact and stays zero.
#[inline]
#[must_use]
pub fn add_down(a: f64, b: f64) -> f64 {
    or(step_down_nonzero(a + b), f64::NEG_INFINITY)
}

/// Upper bound of `a - b`.
#[inline]
#[must_use]
pub fn sub_up(a: f64, b: f64) -> f64 {
    add_up(a, -b)
}

/// Lower bound of `a - b`.
#[inline]
#[must_use]
pub fn sub_down(a: f64, b: f64) -> f64 {
    add_down(a, -b)
}

/// `ETA` unless a factor is zero, when the product is exact.
#[inline(always)]
fn underflow(a: f64, b: f64) -> f64 {
    if (a != 0.0) & (b != 0.0) { ETA } else { 0.0 }
}

/// Upper bound of `a b`. A product with a zero factor is exact and stays zero; `0 inf` gives `inf`.
#[inline]
#[must_use]
pub fn mul_up(a: f64, b: f64) -> f64 {
    let c = larger(f64::MIN, a * b);
    or(c + (c.abs() * PHI + underflow(a, b)), f64::INFINITY)
}

/// Lower bound of `a b`. A product with a zero factor is exact and stays zero; `0 inf` gives `-inf`.
#[inline]
#[must_use]
pub fn mul_down(a: f64, b: f64) -> f64 {
    -mul_up(-a, b)
}

/// Upper bound of `a / b`. A zero numerator stays zero; `b = 0` gives `inf`.
#[inline]
#[must_use]
pub fn div_up(a: f64, b: f64) -> f64 {
    let c = larger(f64::MIN, a / b);
    let quotient = if b == 0.0 { f64::NAN } else { c };
    or(quotient + (quotient.abs() * PHI + underflow(a, 1.0)), f64::INFINITY)
}

/// Lower bound of `a / b`. A zero numerator stays zero; `b = 0` gives `-inf`.
#[inline]
#[must_use]
pub fn div_down(a: f64, b: f64) -> f64 {
    -div_up(-a, b)
}

/// The least floating-point number at or above `a - b`, for finite bounds: exact differences are not stepped.
#[inline]
pub(crate) fn sub_up_tight(a: f64, b: f64) -> f64 {
    let d = a - b;
    // Error of the difference (Knuth's TwoSum), exact unless something overflows; then it is NaN or infinite.
    let back = d - a;
    let error = (a - (d - back)) - (b + back);
    if error <= 0.0 { d } else { or(d.next_up(), f64::INFINITY) }
}

/// Upper bound of the square root; `inf` where there is none.
#[inline]
#[must_use]
pub fn sqrt_up(a: f64) -> f64 {
    or(step_up_nonzero(a.sqrt()), f64::INFINITY)
}

/// Lower bound of the square root, never negative; `-inf` where there is none.
#[inline]
#[must_use]
pub fn sqrt_down(a: f64) -> f64 {
    or(step_down_nonzero(a.sqrt()), f64::NEG_INFINITY)
}

/// Upper bound of a sum, in the order given.
///
/// ```
/// assert!(scalars::rounding::sum_up([0.1; 10]) >= 1.0);
/// ```
#[inline]
#[must_use]
pub fn sum_up(terms: impl IntoIterator<Item = f64>) -> f64 {
    terms.into_iter().fold(0.0, add_up)
}

/// Upper bound of `gamma_k = k u / (1 - k u)`, the relative error constant of `k` roundings; `inf` for `k u >= 1`.
///
/// **Source:** Higham, *Accuracy and Stability of Numerical Algorithms*, section 3.1.
#[inline]
#[must_use]
pub fn gamma_up(k: usize) -> f64 {
    if k == 0 {
        return 0.0;
    }
    // `k as f64` rounds for k > 2^53, where k u >= 1 anyway.
    let ku = k as f64 * UNIT_ROUNDOFF;
    if ku < 1.0 { div_up(ku, sub_down(1.0, ku)) } else { f64::INFINITY }
}
