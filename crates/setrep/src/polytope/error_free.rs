//! Sums of products without any rounding error, and sums with a known one.
//!
//! `two_sum` and `two_product` split `a + b` and `a b` into a float and its exact rounding error. Expansions (lists of
//! non-overlapping floats, the smallest first) add up any number of such parts exactly.
//!
//! **Source:** Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates* (1997), theorem 10;
//! Ogita, Rump, Oishi, *Accurate sum and dot product* (2005), proposition 5.5.

use scalars::rounding::{ETA, UNIT_ROUNDOFF, up};

use crate::bounds::two_sum;

/// Products of magnitudes between these bounds neither overflow on the way nor lose their error term to underflow.
const SAFE: core::ops::Range<f64> = 1e-240..1e240;

/// Longest expansion kept on the stack.
const CAPACITY: usize = 64;

/// The upper half of the digits of `a` (Veltkamp).
#[inline]
fn split(a: f64) -> f64 {
    let c = 134_217_729.0 * a;
    c - (c - a)
}

/// `a b` as computed and its exact rounding error (Dekker); exact for `|a|`, `|b|` and `|a b|` zero or within [`SAFE`].
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, b_high) = (split(a), split(b));
    let (a_low, b_low) = (a - a_high, b - b_high);
    (product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low))
}

/// The exact value of a sum of products `sum_k a_k b_k`, rounded with relative error of at most `2^-50`: sign and zero are exact.
///
/// `None` where a product could overflow or underflow, or where there are too many.
pub(super) fn exact_sum(products: impl Iterator<Item = (f64, f64)>) -> Option<f64> {
    let mut expansion = [0.0; CAPACITY];
    let mut length = 0;
    for (a, b) in products {
        if a == 0.0 || b == 0.0 {
            continue;
        }
        if !SAFE.contains(&a.abs()) || !SAFE.contains(&b.abs()) || !SAFE.contains(&(a * b).abs()) {
            return None;
        }
        let (product, error) = two_product(a, b);
        for part in [error, product] {
            // Grow the expansion by one float; zero components are left out.
            let mut carry = part;
            let mut kept = 0;
            for k in 0..length {
                let (sum, low) = two_sum(carry, expansion[k]);
                carry = sum;
                if low != 0.0 {
                    expansion[kept] = low;
                    kept += 1;
                }
            }
            if carry != 0.0 {
                if kept == CAPACITY {
                    return None;
                }
                expansion[kept] = carry;
                kept += 1;
            }
            length = kept;
        }
    }
    // The largest component exceeds the sum of all others: it carries the sign, and plain summation from the small end is
    // accurate to a few roundings.
    let sum: f64 = expansion[..length].iter().sum();
    if length > 0 && (sum == 0.0 || sum.is_sign_negative() != expansion[length - 1].is_sign_negative()) {
        return Some(expansion[length - 1]);
    }
    Some(sum)
}

/// Compensated dot product: value and a bound of its error, zero where no operation rounded.
///
/// The error is at most `u |s| + gamma_n^2 sum |x_k y_k|` (Ogita, Rump, Oishi). NaN bounds come out where a product overflows.
pub(crate) fn dot_compensated(x: &[f64], y: &[f64]) -> (f64, f64) {
    let (mut sum, mut compensation, mut magnitude, mut lost, mut tiny) = (0.0, 0.0, 0.0, 0.0, false);
    for (&a, &b) in x.iter().zip(y) {
        // A factor of zero or one is exact at any scale.
        let unit = [a, b].into_iter().any(|x| x == 0.0 || x.abs() == 1.0);
        let (product, error) = if unit { (a * b, 0.0) } else { two_product(a, b) };
        let (next, carry) = two_sum(sum, product);
        sum = next;
        compensation += error + carry;
        lost += error.abs() + carry.abs();
        magnitude += product.abs();
        let normal = SAFE.contains(&product.abs()) && a.abs() < SAFE.end && b.abs() < SAFE.end;
        tiny |= !(unit || normal);
    }
    if tiny {
        return dot_plain(x, y);
    }
    if lost == 0.0 {
        return (sum, 0.0);
    }
    let n = x.len() as f64 + 2.0;
    let value = sum + compensation;
    let gamma = 2.0 * n * UNIT_ROUNDOFF;
    (value, up(UNIT_ROUNDOFF * value.abs() * 1.01 + gamma * gamma * magnitude * 1.01 + ETA))
}

/// Plain dot product with its error bound, underflow included; the bound is NaN or infinite beside an overflow.
#[inline]
pub(super) fn dot_plain(x: &[f64], y: &[f64]) -> (f64, f64) {
    let (mut sum, mut magnitude) = (0.0, 0.0);
    for (&a, &b) in x.iter().zip(y) {
        sum += a * b;
        magnitude += (a * b).abs();
    }
    let n = x.len() as f64 + 2.0;
    (sum, up(n * UNIT_ROUNDOFF * magnitude * 1.01 + n * ETA))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_cancelling_sums_are_exact() {
        let tiny = 2f64.powi(-52);
        // (1 + e)(1 - e) - 1 = -e^2
        let value = exact_sum([(1.0 + tiny, 1.0 - tiny), (-1.0, 1.0)].into_iter()).unwrap();
        assert_eq!(value, -tiny * tiny);
        assert_eq!(exact_sum([(0.1, 3.0), (-0.3, 1.0), (0.1, -3.0), (0.3, 1.0)].into_iter()), Some(0.0));
        assert!(exact_sum([(0.1, 3.0), (-0.3, 1.0)].into_iter()).unwrap() > 0.0);
        assert_eq!(exact_sum([(1e-200, 1e-200)].into_iter()), None);
    }

    #[test]
    fn exact_products_have_no_error() {
        assert_eq!(dot_compensated(&[1.0, 0.0, -2.0], &[0.3, 0.7, 0.1]).1.min(0.0), 0.0);
        assert_eq!(dot_compensated(&[1.0, 0.0], &[0.3, 0.7]), (0.3, 0.0));
        let (value, error) = dot_compensated(&[0.1, 0.1], &[0.1, 0.3]);
        assert!(error > 0.0 && (value - 0.04).abs() < 1e-17);
    }
}
