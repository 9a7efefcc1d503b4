//! Outward rounding: the few bounds on floating-point errors that the proofs of this crate rest on.
//!
//! Arithmetic rounds to nearest, so the exact result of one operation lies within one step of the computed one; no
//! rounding mode is ever changed. Sources: Rump, *Error estimation of floating-point summation and dot product*, 2012;
//! Ogita, Rump, Oishi, *Accurate sum and dot product*, 2005.

/// Unit roundoff `u = 2^-53`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Far above the sum of all underflow errors of `2^48` products (each at most `2^-1075`).
pub(crate) const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// Twice the largest error of a product that underflows.
const SMALLEST: f64 = f64::from_bits(1);

/// Products above this are normal numbers, and so are their rounding errors.
const TINY_PRODUCT: f64 = 1e-280;

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
    if sum == 0.0 { 0.0 } else { (sum * (1.0 + gamma_up(a.len()))).next_up() }
}

/// Upper bound of the modulus of the exact `start - sum c_k a_k`; NaN if anything overflows in both directions.
pub(crate) fn difference_up(start: f64, products: impl ExactSizeIterator<Item = (f64, f64)>) -> f64 {
    let count = products.len();
    let (mut value, mut moduli) = (start, start.abs());
    for (c, a) in products {
        let product = c * a;
        value -= product;
        moduli += product.abs();
    }
    let error = gamma_up(count + 1) * moduli + UNDERFLOW;
    add_up(value.abs(), error.next_up())
}

/// Lower and upper bound of an exact number.
pub(crate) type Bounds = (f64, f64);

/// Bounds of the sum of a number and `factor` times another.
pub(crate) fn add_scaled(sum: Bounds, factor: f64, term: Bounds) -> Bounds {
    let (low, high) = if factor < 0.0 { (term.1, term.0) } else { term };
    let (low, high) = (mul_down(factor, low), mul_up(factor, high));
    // Adding an exact zero rounds nothing.
    (if low == 0.0 { sum.0 } else { add_down(sum.0, low) }, if high == 0.0 { sum.1 } else { add_up(sum.1, high) })
}

/// Upper bound of the modulus; NaN if a bound is.
pub(crate) fn magnitude(bounds: Bounds) -> f64 {
    if bounds.0.is_nan() || bounds.1.is_nan() { f64::NAN } else { bounds.1.max(-bounds.0) }
}

/// Bounds of the exact `start + sum a_j x_j`; both the same if no operation rounds.
pub(crate) fn dot_enclosure(start: f64, a: &[f64], x: &[f64]) -> Bounds {
    let mut sum = Compensated::new(start);
    for (&a, &x) in a.iter().zip(x) {
        sum.add_product(a, x);
    }
    sum.bounds()
}

/// A sum of numbers and products by compensated summation: the error of every operation is itself a number, so only the
/// sum of the errors is rounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Compensated {
    sum: f64,
    correction: f64,
    /// Sum of the moduli of what the correction adds up, and the number of roundings in it.
    moduli: f64,
    count: usize,
    /// Bound of what no number of this sum represents.
    rest: f64,
}

impl Compensated {
    pub(crate) fn new(start: f64) -> Self {
        Self { sum: start, correction: 0.0, moduli: 0.0, count: 0, rest: 0.0 }
    }

    /// Adds `a x`.
    #[inline]
    pub(crate) fn add_product(&mut self, a: f64, x: f64) {
        let product = a * x;
        let product_error = a.mul_add(x, -product);
        let next = self.sum + product;
        let part = next - self.sum;
        let sum_error = (self.sum - (next - part)) + (product - part);
        self.sum = next;
        self.correction += product_error + sum_error;
        self.moduli += product_error.abs() + sum_error.abs();
        self.count += 2;
        if product.abs() < TINY_PRODUCT && a != 0.0 && x != 0.0 {
            self.rest = add_up(self.rest, SMALLEST);
        }
    }

    /// Adds `sign` (1 or -1) times another sum.
    pub(crate) fn add_signed(&mut self, sign: f64, other: &Self) {
        self.add_product(sign, other.sum);
        self.add_product(sign, other.correction);
        self.rest = add_up(self.rest, other.error());
    }

    /// Bounds of the exact sum.
    pub(crate) fn bounds(&self) -> Bounds {
        if self.moduli == 0.0 && self.rest == 0.0 {
            return (self.sum, self.sum);
        }
        let error = self.error();
        (add_down(add_down(self.sum, self.correction), -error), add_up(add_up(self.sum, self.correction), error))
    }

    /// Bound of the error of `sum + correction`.
    fn error(&self) -> f64 {
        (gamma_up(self.count) * self.moduli + self.rest).next_up()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gamma_exceeds_the_exact_constant() {
        for k in [0_usize, 1, 10, 1 << 10, 1 << 25] {
            let ku = k as f64 * UNIT;
            assert!(gamma_up(k) > ku / (1.0 - ku) * (1.0 + ku) * (1.0 + 4.0 * UNIT));
        }
    }

    #[test]
    fn products_and_sums_step_outward() {
        assert!(mul_up(0.1, 0.1) > 0.1 * 0.1 && mul_down(0.1, 0.1) < 0.1 * 0.1);
        assert_eq!((mul_up(0.0, 3.0), mul_down(-0.0, 3.0)), (0.0, 0.0));
        assert!(mul_up(f64::MIN_POSITIVE, f64::MIN_POSITIVE) > 0.0);
        assert!(mul_down(-f64::MIN_POSITIVE, f64::MIN_POSITIVE) < 0.0);
        assert!(add_up(1.0, 1e-30) > 1.0 && add_down(1.0, -1e-30) < 1.0);
        assert!(norm1_up(&[0.1, -0.2, 0.3]) > 0.6);
    }

    #[test]
    fn a_difference_is_bounded_closely() {
        // 1 - 10 * 0.1 is -2^-54 exactly.
        let bound = difference_up(1.0, [(0.1, 10.0)].into_iter());
        assert!((f64::EPSILON / 4.0..8.0 * f64::EPSILON).contains(&bound));
        assert!(difference_up(0.0, [(1e-200, 1e-200)].into_iter()) > 0.0);
        assert!(difference_up(1.0, [(f64::MAX, 2.0), (f64::MAX, -2.0)].into_iter()).is_nan());
    }

    #[test]
    fn an_exact_sum_is_a_point() {
        assert_eq!(dot_enclosure(0.0, &[3.0, -2.0, 0.5], &[1.0, 1.0, -1.0]), (0.5, 0.5));
        assert_eq!(dot_enclosure(-0.5, &[3.0, -2.0], &[1.0, 1.0]), (0.5, 0.5));
        assert_eq!(dot_enclosure(0.0, &[], &[]), (0.0, 0.0));
    }

    #[test]
    fn a_rounded_sum_is_enclosed_within_a_few_steps() {
        // 0.1 + 0.2 is not a number: the exact sum of the two lies strictly inside.
        let (lower, upper) = dot_enclosure(0.0, &[0.1, 0.2], &[1.0, 1.0]);
        assert!(lower < 0.3 && 0.3 < upper.next_up() && upper - lower < 1e-15);
        let (lower, upper) = dot_enclosure(0.0, &[1.0, 1e-200], &[1.0, 1e-200]);
        assert!(lower <= 1.0 && 1.0 < upper);
        // Cancellation: the exact value is 2^-60.
        let (lower, upper) = dot_enclosure(0.0, &[1.0, f64::EPSILON / 256.0, -1.0], &[1.0, 1.0, 1.0]);
        let exact = f64::EPSILON / 256.0;
        assert!((-1e-17..=exact).contains(&lower) && (exact..1e-17).contains(&upper));
    }
}
