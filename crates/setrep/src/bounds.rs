//! Upper bounds of sums of absolute values, and of what rounding does to them.
//!
//! Notation: `u = 2^-53`, `eta = 2^-1074`, `gamma_k = k u / (1 - k u)`. A floating-point sum of `k + 1` nonnegative terms, in any
//! order, is at least `(1 - u)^k` times the exact one, so the exact one is at most `(1 + gamma_k)` times the computed one. A
//! computed dot product of length `k`, in any order, with or without fused multiply-add, is off by at most
//! `gamma_k |x|'|y| + k eta` (Jeannerod and Rump 2013; `eta` for products that underflow).

use scalars::rounding::{ETA, UNIT_ROUNDOFF, add_up, up};

/// Below this, a computed sum of products may owe a visible part to products that underflowed.
const SAFE_MAGNITUDE: f64 = 1e-280;

/// Upper bound of `gamma_k`, within 1 % of it and without a division.
///
/// `gamma_k <= k u (1 + 2 k u) <= 1.01 k u` for `k <= 2^45`, more columns than an address space holds.
#[inline]
pub(crate) fn gamma(k: usize) -> f64 {
    k as f64 * (1.01 * UNIT_ROUNDOFF)
}

/// Upper bound of the exact sum of nonnegative terms whose floating-point sum, with `additions` additions, is `computed`.
#[inline]
pub(crate) fn sum_bound(computed: f64, additions: usize) -> f64 {
    // A sum of nonnegative floats is exactly zero only if every term is.
    if computed == 0.0 { 0.0 } else { inflate(computed, additions) }
}

/// Upper bound of an exact sum of nonnegative products whose floating-point value is `computed`; `products` counts those that are
/// not exactly zero (none: the sum is exactly zero), `roundings` the most roundings that one term goes through.
#[inline]
pub(crate) fn product_sum_bound(computed: f64, products: usize, roundings: usize) -> f64 {
    if computed > SAFE_MAGNITUDE {
        // The slack of u * computed in the factor exceeds every lost eta.
        inflate(computed, roundings)
    } else if products == 0 && computed == 0.0 {
        0.0
    } else {
        // NaN comes here, and passes on as infinity.
        add_up(inflate(computed, roundings), underflow_bound(products))
    }
}

/// Upper bound of `computed (1 + gamma_roundings)`, with a slack of at least `u * computed`: the factor is above
/// `1 + 2 (roundings + 1) u - u`.
#[inline]
fn inflate(computed: f64, roundings: usize) -> f64 {
    up(computed * (1.0 + 2.0 * gamma(roundings + 1)))
}

/// Upper bound of what `products` multiplications lose to underflow.
#[inline]
pub(crate) fn underflow_bound(products: usize) -> f64 {
    // A small integer times the smallest subnormal number is exact; beyond 2^52 products no memory holds the operands.
    products as f64 * ETA
}

/// Upper bound of `a + b` for nonnegative `a`, `b`; exact if one of them is zero.
#[inline]
pub(crate) fn add_lengths(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { a + b } else { add_up(a, b) }
}

/// `a + b` as computed and its exact rounding error (Knuth's branch-free transformation); not finite if `a + b` overflows.
#[inline]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// Adds `sum_j |x_ij|` over the columns of a column-major array to `sums` (plain floating point, one addition a column).
#[inline]
pub(crate) fn add_abs_row_sums(columns: &[f64], sums: &mut [f64]) {
    match sums.len() {
        2 => add_abs_row_sums_small::<2>(columns, sums),
        3 => add_abs_row_sums_small::<3>(columns, sums),
        4 => add_abs_row_sums_small::<4>(columns, sums),
        n => {
            for column in columns.chunks_exact(n.max(1)) {
                for (sum, x) in sums.iter_mut().zip(column) {
                    *sum += x.abs();
                }
            }
        }
    }
}

/// [`add_abs_row_sums`] with four columns in flight.
#[inline]
fn add_abs_row_sums_small<const N: usize>(columns: &[f64], sums: &mut [f64]) {
    let (columns, _) = columns.as_chunks::<N>();
    let (blocks, rest) = columns.as_chunks::<4>();
    let mut lanes = [[0.0_f64; N]; 4];
    for block in blocks {
        for (lane, column) in lanes.iter_mut().zip(block) {
            for i in 0..N {
                lane[i] += column[i].abs();
            }
        }
    }
    for (lane, column) in lanes.iter_mut().zip(rest) {
        for i in 0..N {
            lane[i] += column[i].abs();
        }
    }
    for (i, sum) in sums.iter_mut().enumerate() {
        *sum += (lanes[0][i] + lanes[1][i]) + (lanes[2][i] + lanes[3][i]);
    }
}

/// The largest power of two at most `x`, which is positive and normal.
#[inline]
pub(crate) fn power_of_two_below(x: f64) -> f64 {
    // The exponent field alone.
    f64::from_bits(x.to_bits() & (0x7ff << 52))
}
