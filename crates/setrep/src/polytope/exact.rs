//! Exact integer linear algebra for the predicates that floating point cannot decide.
//!
//! Rows of floats are scaled to integers (a positive factor changes no sign). Elimination is fraction free: every entry is a minor
//! of the matrix and every division is exact.
//!
//! **Source:** Bareiss, *Sylvester's identity and multistep integer-preserving Gaussian elimination* (1968).

use core::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use scalars::rounding::ETA;

use super::error_free::exact_sum;

/// `x = mantissa 2^exponent` with an odd mantissa; `(0, 0)` for zero. `x` is finite.
pub(super) fn decompose(x: f64) -> (i64, i32) {
    if x == 0.0 {
        return (0, 0);
    }
    let bits = x.to_bits();
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (mantissa, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
    let zeros = mantissa.trailing_zeros();
    let magnitude = mantissa >> zeros;
    (if x < 0.0 { -magnitude } else { magnitude }, exponent + zeros as i32)
}

/// Integers `A` and the shift `p` with `x_k 2^(e_k) = A_k 2^-p`.
pub(super) fn integer_row(x: &[f64], exponents: &[i32]) -> (Box<[BigInt]>, i32) {
    let parts: Vec<(i64, i32)> =
        x.iter().zip(exponents).map(|(&x, &e)| (decompose(x), e)).map(|((m, p), e)| (m, p + e)).collect();
    let lowest = parts.iter().filter(|(m, _)| *m != 0).map(|&(_, p)| p).min().unwrap_or(0);
    let row = parts
        .iter()
        .map(|&(m, p)| if m == 0 { BigInt::zero() } else { BigInt::from(m) << (p - lowest) as usize })
        .collect();
    (row, -lowest)
}

/// `x 2^-shift` in floating point, relative error at most `2^-52`, and whether it is exact.
pub(super) fn scaled(x: &BigInt, shift: i64) -> (f64, bool) {
    let bits = x.bits();
    let drop = bits.saturating_sub(62);
    let top = x.magnitude() >> drop;
    // At most 62 bits are left.
    let top_digits = top.iter_u64_digits().next().unwrap_or(0);
    let zeros = x.magnitude().trailing_zeros().unwrap_or(0);
    let value = scale_by_power(top_digits as f64, drop as i64 - shift);
    // Only results below the normal range are rounded by the scaling.
    let exact = x.is_zero() || (bits - zeros.min(bits) <= 53 && value.is_normal());
    (if x.sign() == Sign::Minus { -value } else { value }, exact)
}

/// `x 2^k` for any `k`, rounded only where the result is subnormal.
pub(super) fn scale_by_power(x: f64, k: i64) -> f64 {
    let mut value = x;
    let mut k = k.clamp(-4000, 4000);
    while k > 1000 {
        value *= 2f64.powi(1000);
        k -= 1000;
    }
    while k < -1000 {
        value *= 2f64.powi(-1000);
        k += 1000;
    }
    value * 2f64.powi(k as i32)
}

/// The exact quotient `numerator / denominator` between two floats: `mid +- rad`, `rad = 0` if the quotient is a float.
///
/// The bits beyond the 64 leading ones are dropped (relative error `2^-61`), rounding to nearest adds `2^-53`, and half of `ETA` where the result
/// is subnormal.
pub(super) fn quotient(numerator: &BigInt, denominator: &BigInt, exponent: i64) -> (f64, f64) {
    if numerator.is_zero() {
        return (0.0, 0.0);
    }
    let shift = 64 + denominator.bits() as i64 - numerator.bits() as i64;
    let (top, bottom) = if shift >= 0 {
        (numerator << shift as usize, denominator.clone())
    } else {
        (numerator.clone(), denominator << (-shift) as usize)
    };
    let (ratio, rest) = top.div_rem(&bottom);
    let (mid, exact) = scaled(&ratio, shift - exponent);
    let rad = if exact && rest.is_zero() { 0.0 } else { mid.abs() * 2f64.powi(-51) + 2.0 * ETA };
    (mid, rad)
}

/// Sign and value of the product of two integer vectors.
pub(super) fn dot(a: &[BigInt], y: &[BigInt]) -> BigInt {
    a.iter().zip(y).filter(|(a, y)| !a.is_zero() && !y.is_zero()).map(|(a, y)| a * y).sum()
}

/// The exact sign of a sum of products of finite floats.
pub(super) fn sign_of_sum(products: impl Iterator<Item = (f64, f64)> + Clone) -> Ordering {
    if let Some(sum) = exact_sum(products.clone()) {
        return sum.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
    }
    let mut terms: Vec<(BigInt, i32)> = Vec::new();
    for (a, b) in products {
        let ((a, p), (b, q)) = (decompose(a), decompose(b));
        if a != 0 && b != 0 {
            terms.push((BigInt::from(a) * b, p + q));
        }
    }
    let lowest = terms.iter().map(|term| term.1).min().unwrap_or(0);
    sign(&terms.into_iter().map(|(x, p)| x << (p - lowest) as usize).sum())
}

/// The sign of an integer as an ordering against zero.
pub(super) fn sign(x: &BigInt) -> Ordering {
    match x.sign() {
        Sign::Minus => Ordering::Less,
        Sign::NoSign => Ordering::Equal,
        Sign::Plus => Ordering::Greater,
    }
}

/// Independent rows found one at a time, in echelon form.
pub(super) struct Echelon {
    dim: usize,
    rows: Vec<Vec<BigInt>>,
    pivots: Vec<usize>,
}

impl Echelon {
    pub(super) fn new(dim: usize) -> Self {
        Self { dim, rows: Vec::with_capacity(dim), pivots: Vec::with_capacity(dim) }
    }

    /// The number of independent rows so far.
    pub(super) fn rank(&self) -> usize {
        self.rows.len()
    }

    /// The pivot column of each independent row.
    pub(super) fn pivots(&self) -> &[usize] {
        &self.pivots
    }

    /// Adds a row; false if it depends on the rows before it.
    pub(super) fn push(&mut self, row: &[BigInt]) -> bool {
        let mut row = row.to_vec();
        let mut previous = BigInt::one();
        for (reduced, &pivot) in self.rows.iter().zip(&self.pivots) {
            let factor = core::mem::take(&mut row[pivot]);
            for k in 0..self.dim {
                if k != pivot && !(row[k].is_zero() && (factor.is_zero() || reduced[k].is_zero())) {
                    row[k] = (&reduced[pivot] * &row[k] - &factor * &reduced[k]) / &previous;
                }
            }
            previous.clone_from(&reduced[pivot]);
        }
        match row.iter().position(|x| !x.is_zero()) {
            Some(pivot) => {
                self.rows.push(row);
                self.pivots.push(pivot);
                true
            }
            None => false,
        }
    }

    /// A primitive integer vector `y` with `A y = 0`, for `dim - 1` independent rows; its sign is arbitrary.
    pub(super) fn null_vector(&self) -> Option<Box<[BigInt]>> {
        let free = (0..self.dim).find(|k| !self.pivots.contains(k)).filter(|_| self.rank() + 1 == self.dim)?;
        let mut y = vec![BigInt::zero(); self.dim];
        y[free] = self.rows.last().zip(self.pivots.last()).map_or_else(BigInt::one, |(row, &pivot)| row[pivot].clone());
        for (row, &pivot) in self.rows.iter().zip(&self.pivots).rev() {
            // The entry at the pivot of `y` is still zero.
            y[pivot] = -dot(row, &y) / &row[pivot];
        }
        make_primitive(&mut y);
        Some(y.into_boxed_slice())
    }
}

/// The ray on which the `tight` rows vanish and the `loose` ones are not negative, primitive. `None` if it is not unique.
pub(super) fn ray_of<'a>(
    dim: usize,
    tight: impl Iterator<Item = &'a [BigInt]>,
    mut loose: impl Iterator<Item = &'a [BigInt]>,
) -> Option<Box<[BigInt]>> {
    let mut echelon = Echelon::new(dim);
    for row in tight {
        echelon.push(row);
        if echelon.rank() + 1 == dim {
            break;
        }
    }
    let mut ray = echelon.null_vector()?;
    if loose.find_map(|row| Some(sign(&dot(row, &ray))).filter(|sign| sign.is_ne())) == Some(Ordering::Less) {
        for x in &mut ray {
            *x = -core::mem::take(x);
        }
    }
    Some(ray)
}

/// Divides by the greatest common divisor.
pub(super) fn make_primitive(y: &mut [BigInt]) {
    let mut divisor = BigInt::zero();
    for x in y.iter() {
        divisor = divisor.gcd(x);
        if divisor.is_one() {
            return;
        }
    }
    if !divisor.is_zero() && !divisor.abs().is_one() {
        for x in y.iter_mut() {
            *x /= &divisor;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_vectors_are_exact() {
        let rows = [[0.1, 0.2, -0.3, 1.0], [1.0, 0.0, 1e-30, 5.0], [3.0, 1e20, 7.0, 0.0]];
        let mut echelon = Echelon::new(4);
        let integers: Vec<_> = rows.iter().map(|row| integer_row(row, &[0, 1, -3, 0]).0).collect();
        assert!(integers.iter().all(|row| echelon.push(row)));
        assert!(!echelon.push(&integers[1]));
        let y = echelon.null_vector().unwrap();
        assert!(integers.iter().all(|row| dot(row, &y).is_zero()));
    }

    #[test]
    fn quotients_bracket() {
        let (mid, rad) = quotient(&BigInt::from(1), &BigInt::from(3), 0);
        assert!((mid - 1.0 / 3.0).abs() <= rad && rad < 1e-15);
        assert_eq!(quotient(&BigInt::from(-6), &BigInt::from(4), 1), (-3.0, 0.0));
        assert_eq!(quotient(&(BigInt::from(1) << 3000), &(BigInt::from(1) << 2999), 0), (2.0, 0.0));
    }
}
