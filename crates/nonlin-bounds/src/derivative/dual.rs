//! [`Dual`]: a value and its gradient.

use scalars::Scalar;

use super::elementary::{Chain, impl_scalar};

/// A value and its first derivatives by up to eight variables, over any scalar `S`.
///
/// Partial derivatives that are zero whatever the values are (structural zeros) are known and cost nothing: constants carry none.
/// The value may be of a richer type `V` than the derivatives, as [`Decorated`](crate::Decorated).
///
/// **Guarantee:** over intervals each derivative encloses the exact one at every point at which it exists. Where `abs`, `min`, `max` tie,
/// it encloses the generalised derivative of Clarke.
///
/// ```
/// use nonlin_bounds::Dual;
/// use scalars::Scalar;
/// let [x, y] = [Dual::<f64, 2>::variable(3.0, 0), Dual::variable(2.0, 1)];
/// let z = (x * y).scale(0.5) + y.sqr();
/// assert_eq!((z.value(), z.gradient()), (7.0, &[1.0, 5.5]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<S, const N: usize, V = S> {
    value: V,
    gradient: [S; N],
    /// Bit `i` is set unless partial derivative `i` is structurally zero.
    mask: u8,
}

/// The positions of the bits that are set.
#[inline(always)]
pub(super) fn bits(mut mask: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        if mask == 0 {
            return None;
        }
        let index = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        Some(index)
    })
}

impl<S: Scalar, const N: usize, V: Scalar + Into<S>> Dual<S, N, V> {
    /// A constant.
    #[inline]
    #[must_use]
    pub fn constant(value: V) -> Self {
        const { assert!(N <= 8, "a pass has at most eight variables") }
        Self { value, gradient: [S::zero(); N], mask: 0 }
    }

    /// The variable `index`; one that is not below `N` is a constant.
    #[inline]
    #[must_use]
    pub fn variable(value: V, index: usize) -> Self {
        let mut x = Self::constant(value);
        if let Some(partial) = x.gradient.get_mut(index) {
            *partial = S::one();
            x.mask = 1 << index;
        }
        x
    }

    /// The value.
    #[inline]
    #[must_use]
    pub fn value(&self) -> V {
        self.value
    }

    /// The derivatives by all variables.
    #[inline]
    #[must_use]
    pub fn gradient(&self) -> &[S; N] {
        &self.gradient
    }

    /// True if the number is known to depend on no variable.
    #[inline]
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.mask == 0
    }

    /// True if the derivative by variable `index` may be other than zero.
    #[inline]
    #[must_use]
    pub fn depends_on(&self, index: usize) -> bool {
        index < N && self.mask >> index & 1 == 1
    }

    /// `value` with the gradient `sum over the terms`, by whom each variable concerns: both, the first, the second.
    #[inline(always)]
    fn combine(
        self,
        other: Self,
        value: V,
        both: impl Fn(S, S) -> S,
        first: impl Fn(S) -> S,
        second: impl Fn(S) -> S,
    ) -> Self {
        let mut gradient = [S::zero(); N];
        for i in bits(u64::from(self.mask & other.mask)) {
            gradient[i] = both(self.gradient[i], other.gradient[i]);
        }
        for i in bits(u64::from(self.mask & !other.mask)) {
            gradient[i] = first(self.gradient[i]);
        }
        for i in bits(u64::from(other.mask & !self.mask)) {
            gradient[i] = second(other.gradient[i]);
        }
        Self { value, gradient, mask: self.mask | other.mask }
    }

    #[inline(always)]
    fn sum(self, other: Self) -> Self {
        self.combine(other, self.value + other.value, |a, b| a + b, |a| a, |b| b)
    }

    #[inline(always)]
    fn difference(self, other: Self) -> Self {
        self.combine(other, self.value - other.value, |a, b| a - b, |a| a, |b| -b)
    }

    /// `(a b)' = a' b + a b'`.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        let (x, y) = (self.at(), other.at());
        self.combine(other, self.value * other.value, |a, b| a * y + x * b, |a| a * y, |b| x * b)
    }

    /// `q = a / b`: `q' = (a' - q b') / b`.
    #[inline(always)]
    fn quotient(self, other: Self) -> Self {
        let value = self.value / other.value;
        let (q, y) = (value.into(), other.at());
        self.combine(other, value, |a, b| (a - q * b) / y, |a| a / y, |b| -(q * b) / y)
    }

    #[inline(always)]
    fn negated(mut self) -> Self {
        self.value = -self.value;
        for i in bits(u64::from(self.mask)) {
            self.gradient[i] = -self.gradient[i];
        }
        self
    }
}

impl<S: Scalar, const N: usize, V: Scalar + Into<S>> Chain for Dual<S, N, V> {
    type S = S;
    type V = V;

    #[inline(always)]
    fn constant(value: V) -> Self {
        Self::constant(value)
    }

    #[inline(always)]
    fn value(&self) -> V {
        self.value
    }

    #[inline(always)]
    fn chain(mut self, value: V, first: impl FnOnce() -> S, _: impl FnOnce() -> S) -> Self {
        self.value = value;
        if self.mask != 0 {
            let slope = first();
            for i in bits(u64::from(self.mask)) {
                self.gradient[i] = slope * self.gradient[i];
            }
        }
        self
    }

    #[inline(always)]
    fn chain2(self, other: Self, value: V, first: impl FnOnce() -> (S, S), _: impl FnOnce() -> (S, S, S)) -> Self {
        if self.mask | other.mask == 0 {
            return Self::constant(value);
        }
        let (p, q) = first();
        self.combine(other, value, |a, b| p * a + q * b, |a| p * a, |b| q * b)
    }

    #[inline(always)]
    fn affine(mut self, value: V, k: f64) -> Self {
        self.value = value;
        for i in bits(u64::from(self.mask)) {
            self.gradient[i] = self.gradient[i].scale(k);
        }
        self
    }
}

impl_scalar!([S: Scalar, const N: usize, V: Scalar + Into<S>] Dual<S, N, V>);
