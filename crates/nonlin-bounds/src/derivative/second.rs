//! [`Second`]: a value, its gradient and its Hessian.

use scalars::Scalar;

use super::dual::bits;
use super::elementary::{Chain, impl_scalar};

/// A value with its first and second derivatives by up to eight variables, over any scalar `S`; `H = N (N + 1) / 2`.
///
/// The Hessian is packed by rows of its upper triangle, `(0,0), (0,1), .., (0,N-1), (1,1), ..`, plain second derivatives. Structural
/// zeros of gradient and Hessian are known and cost nothing: constants carry no derivatives, affine functions no Hessian.
/// The value may be of a richer type `V` than the derivatives, as [`Decorated`](crate::Decorated).
///
/// **Guarantee:** over intervals each derivative encloses the exact one at every point at which it exists.
///
/// ```
/// use nonlin_bounds::Second;
/// use scalars::Scalar;
/// let [x, y] = [Second::<f64, 2, 3>::variable(3.0, 0), Second::variable(2.0, 1)];
/// let z = x * y + x.sqr();
/// assert_eq!((z.value(), z.gradient(), z.hessian()), (15.0, &[8.0, 3.0], &[2.0, 1.0, 0.0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Second<S, const N: usize, const H: usize, V = S> {
    value: V,
    gradient: [S; N],
    hessian: [S; H],
    /// Bit `i` is set unless partial derivative `i` is structurally zero.
    mask: u8,
    /// The same for the entries of the packed Hessian.
    curved: u64,
}

/// Position of entry `(i, j)`, `i <= j`, in the packed upper triangle of an `n x n` matrix.
#[inline(always)]
pub(crate) const fn packed(n: usize, i: usize, j: usize) -> usize {
    i * (2 * n - i + 1) / 2 + (j - i)
}

impl<S: Scalar, const N: usize, const H: usize, V: Scalar + Into<S>> Second<S, N, H, V> {
    /// A constant.
    #[inline]
    #[must_use]
    pub fn constant(value: V) -> Self {
        const {
            assert!(N <= 8, "a pass has at most eight variables");
            assert!(H == N * (N + 1) / 2, "a packed Hessian has N (N + 1) / 2 entries");
        }
        Self { value, gradient: [S::zero(); N], hessian: [S::zero(); H], mask: 0, curved: 0 }
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

    /// The second derivatives, packed.
    #[inline]
    #[must_use]
    pub fn hessian(&self) -> &[S; H] {
        &self.hessian
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

    /// `value` with derivatives that are linear in those of the operands, by whom each entry concerns: both, the first, the second.
    #[inline(always)]
    fn combine(
        &self,
        other: &Self,
        value: V,
        both: impl Fn(S, S) -> S,
        first: impl Fn(S) -> S,
        second: impl Fn(S) -> S,
    ) -> Self {
        let mut result = Self::constant(value);
        let (a, b) = (u64::from(self.mask), u64::from(other.mask));
        for i in bits(a & b) {
            result.gradient[i] = both(self.gradient[i], other.gradient[i]);
        }
        for i in bits(a & !b) {
            result.gradient[i] = first(self.gradient[i]);
        }
        for i in bits(b & !a) {
            result.gradient[i] = second(other.gradient[i]);
        }
        let (a, b) = (self.curved, other.curved);
        for k in bits(a & b) {
            result.hessian[k] = both(self.hessian[k], other.hessian[k]);
        }
        for k in bits(a & !b) {
            result.hessian[k] = first(self.hessian[k]);
        }
        for k in bits(b & !a) {
            result.hessian[k] = second(other.hessian[k]);
        }
        result.mask = self.mask | other.mask;
        result.curved = a | b;
        result
    }

    /// Adds `term` to entry `(i, j)` of the Hessian, `i` and `j` in any order.
    #[inline(always)]
    fn bend(&mut self, i: usize, j: usize, term: S) {
        let k = packed(N, i.min(j), i.max(j));
        if self.curved >> k & 1 == 1 {
            self.hessian[k] += term;
        } else {
            self.hessian[k] = term;
            self.curved |= 1 << k;
        }
    }

    /// Adds `c (a b' + b a')` to the Hessian, `a` and `b` the gradients of the two operands.
    #[inline(always)]
    fn bend_mixed(&mut self, a: &Self, b: &Self, term: impl Fn(S, S) -> S) {
        for i in bits(u64::from(a.mask)) {
            for j in bits(u64::from(b.mask)) {
                let product = term(a.gradient[i], b.gradient[j]);
                self.bend(i, j, if i == j { product.scale(2.0) } else { product });
            }
        }
    }

    /// Adds `c a a'` to the Hessian, `a` the gradient of the operand.
    #[inline(always)]
    fn bend_square(&mut self, a: &Self, c: S) {
        for i in bits(u64::from(a.mask)) {
            self.bend(i, i, c * a.gradient[i].sqr());
            let scaled = c * a.gradient[i];
            for j in bits(u64::from(a.mask) & !((2 << i) - 1)) {
                self.bend(i, j, scaled * a.gradient[j]);
            }
        }
    }

    #[inline(always)]
    fn sum(self, other: Self) -> Self {
        self.combine(&other, self.value + other.value, |a, b| a + b, |a| a, |b| b)
    }

    #[inline(always)]
    fn difference(self, other: Self) -> Self {
        self.combine(&other, self.value - other.value, |a, b| a - b, |a| a, |b| -b)
    }

    /// `(a b)'' = a'' b + a b'' + a' b' + b' a'`.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        let (x, y) = (self.at(), other.at());
        let value = self.value * other.value;
        let mut result = self.combine(&other, value, |a, b| a * y + x * b, |a| a * y, |b| x * b);
        result.bend_mixed(&self, &other, |a, b| a * b);
        result
    }

    /// `q = a / b`: `q' = (a' - q b') / b`, `q'' = (a'' - q b'' - q' b' - b' q') / b`.
    #[inline(always)]
    fn quotient(self, other: Self) -> Self {
        let value = self.value / other.value;
        let (q, y) = (value.into(), other.at());
        if other.mask == 0 {
            return self.linear(value, |a| a / y);
        }
        // The numerator of q'', then the division.
        let mut result = self.combine(&other, value, |a, b| a - q * b, |a| a, |b| -(q * b));
        for i in bits(u64::from(result.mask)) {
            result.gradient[i] /= y;
        }
        let first = result;
        result.bend_mixed(&first, &other, |a, b| -(a * b));
        for k in bits(result.curved) {
            result.hessian[k] /= y;
        }
        result
    }

    #[inline(always)]
    fn negated(self) -> Self {
        self.linear(-self.value, |a| -a)
    }

    /// `value` with every derivative mapped.
    #[inline(always)]
    fn linear(mut self, value: V, map: impl Fn(S) -> S) -> Self {
        self.value = value;
        for i in bits(u64::from(self.mask)) {
            self.gradient[i] = map(self.gradient[i]);
        }
        for k in bits(self.curved) {
            self.hessian[k] = map(self.hessian[k]);
        }
        self
    }
}

impl<S: Scalar, const N: usize, const H: usize, V: Scalar + Into<S>> Chain for Second<S, N, H, V> {
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
    fn chain(self, value: V, first: impl FnOnce() -> S, second: impl FnOnce() -> S) -> Self {
        if self.mask == 0 {
            return Self::constant(value);
        }
        let slope = first();
        let mut result = self.linear(value, |a| slope * a);
        result.bend_square(&self, second());
        result
    }

    #[inline(always)]
    fn chain2(self, other: Self, value: V, first: impl FnOnce() -> (S, S), second: impl FnOnce() -> (S, S, S)) -> Self {
        if self.mask | other.mask == 0 {
            return Self::constant(value);
        }
        let (p, q) = first();
        let mut result = self.combine(&other, value, |a, b| p * a + q * b, |a| p * a, |b| q * b);
        let (pp, pq, qq) = second();
        if self.mask != 0 {
            result.bend_square(&self, pp);
        }
        if self.mask != 0 && other.mask != 0 {
            result.bend_mixed(&self, &other, |a, b| pq * (a * b));
        }
        if other.mask != 0 {
            result.bend_square(&other, qq);
        }
        result
    }

    #[inline(always)]
    fn affine(self, value: V, k: f64) -> Self {
        self.linear(value, |a| a.scale(k))
    }
}

impl_scalar!([S: Scalar, const N: usize, const H: usize, V: Scalar + Into<S>] Second<S, N, H, V>);
