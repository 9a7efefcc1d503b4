//! The chain rule of every function of [`Scalar`](scalars::Scalar), written once for all dual numbers.

use num_traits::{One, Zero};
use scalars::Scalar;

/// A value with derivatives: how a function of one or two such numbers is differentiated.
///
/// Derivatives of the function are closures: of a constant, none is computed, and a first-order number never asks for the
/// second ones.
pub(super) trait Chain: Copy {
    /// The scalar of derivatives.
    type S: Scalar;
    /// The scalar of values.
    type V: Scalar + Into<Self::S>;

    /// A number that depends on no variable.
    fn constant(value: Self::V) -> Self;
    /// The value.
    fn value(&self) -> Self::V;
    /// `f(a)` of value `value`, from `f'(a)` and `f''(a)`.
    fn chain(self, value: Self::V, first: impl FnOnce() -> Self::S, second: impl FnOnce() -> Self::S) -> Self;
    /// `f(a, b)` of value `value`, from `(f_a, f_b)` and `(f_aa, f_ab, f_bb)`.
    fn chain2(
        self,
        other: Self,
        value: Self::V,
        first: impl FnOnce() -> (Self::S, Self::S),
        second: impl FnOnce() -> (Self::S, Self::S, Self::S),
    ) -> Self;
    /// An affine function of slope `k`.
    fn affine(self, value: Self::V, k: f64) -> Self;

    /// The value, as a scalar of derivatives.
    #[inline(always)]
    fn at(&self) -> Self::S {
        self.value().into()
    }

    /// `x^n`.
    #[inline]
    fn power(self, n: i32) -> Self {
        let x = self.at();
        let degree = f64::from(n);
        match n {
            0 => Self::constant(self.value().powi(0)),
            1 => self,
            // n - 2 is not an i32.
            _ if n < i32::MIN + 2 => self.chain(
                self.value().powi(n),
                || (x.powi(n) / x).scale(degree),
                || (x.powi(n) / x.sqr()).scale(degree).scale(degree - 1.0),
            ),
            _ => self.chain(
                self.value().powi(n),
                || x.powi(n - 1).scale(degree),
                || x.powi(n - 2).scale(degree).scale(degree - 1.0),
            ),
        }
    }

    /// Inverse sine.
    #[inline]
    fn arc_sine(self) -> Self {
        let x = self.at();
        let slope = || (Self::S::one() - x.sqr()).sqrt().recip();
        self.chain(self.value().asin(), slope, || x * (slope().sqr() * slope()))
    }

    /// Inverse cosine.
    #[inline]
    fn arc_cosine(self) -> Self {
        let x = self.at();
        let slope = || -(Self::S::one() - x.sqr()).sqrt().recip();
        self.chain(self.value().acos(), slope, || x * (slope().sqr() * slope()))
    }

    /// Angle of the point `(x, self)`.
    #[inline]
    fn angle(self, x: Self) -> Self {
        let (v, u) = (self.at(), x.at());
        let squared = u.sqr() + v.sqr();
        self.chain2(
            x,
            self.value().atan2(x.value()),
            || (u / squared, -v / squared),
            || {
                let fourth = squared.sqr();
                let mixed = (u * v).scale(2.0) / fourth;
                (-mixed, (v.sqr() - u.sqr()) / fourth, mixed)
            },
        )
    }

    /// One of two: the first where `lead` is positive, the second where it is negative.
    #[inline]
    fn select(self, other: Self, value: Self::V, lead: impl FnOnce() -> Self::S) -> Self {
        let (zero, half) = (Self::S::zero(), |x: Self::S| x.scale(0.5));
        // Weights (1, 0) if the first is the one, (0, 1) if the second is, all between the two at a tie.
        let weights = || {
            let side = lead().sign();
            (half(side.add_f64(1.0)), half((-side).add_f64(1.0)))
        };
        self.chain2(other, value, weights, || (zero, zero, zero))
    }

    /// `C_k`: `C_k' = (k C_{k+2} - C_{k+1}) / 2`, applied twice for the second derivative.
    #[inline]
    fn stumpff_function(self, k: usize) -> Self {
        let s = self.at();
        let degree = k as f64;
        let c = |j: usize| s.stumpff(k.saturating_add(j));
        let value = self.value().stumpff(k);
        if k == 0 {
            return self.chain(value, || c(1).scale(-0.5), || (c(2) - c(3)).scale(0.25));
        }
        self.chain(
            value,
            || (c(2).scale(degree) - c(1)).scale(0.5),
            || (c(4).scale(degree * (degree + 2.0)) - c(3).scale(2.0 * degree + 1.0) + c(2)).scale(0.25),
        )
    }
}

/// The operators and [`Scalar`](scalars::Scalar) for a type that implements [`Chain`] and has the methods `sum`, `difference`,
/// `product`, `quotient` and `negated`.
macro_rules! impl_scalar {
    ([$($generics:tt)*] $type:ty) => {
        impl_scalar!(@operator [$($generics)*] $type, Add add sum, AddAssign add_assign);
        impl_scalar!(@operator [$($generics)*] $type, Sub sub difference, SubAssign sub_assign);
        impl_scalar!(@operator [$($generics)*] $type, Mul mul product, MulAssign mul_assign);
        impl_scalar!(@operator [$($generics)*] $type, Div div quotient, DivAssign div_assign);

        impl<$($generics)*> std::ops::Neg for $type {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                self.negated()
            }
        }

        impl<$($generics)*> num_traits::Zero for $type {
            #[inline]
            fn zero() -> Self {
                Self::constant(V::zero())
            }
            #[inline]
            fn is_zero(&self) -> bool {
                self.is_constant() && self.value.is_zero()
            }
        }
        impl<$($generics)*> num_traits::One for $type {
            #[inline]
            fn one() -> Self {
                Self::constant(V::one())
            }
        }

        impl<$($generics)*> Scalar for $type {
            #[inline]
            fn from_f64(x: f64) -> Self {
                Self::constant(V::from_f64(x))
            }
            #[inline]
            fn lit(lo: f64, hi: f64) -> Self {
                Self::constant(V::lit(lo, hi))
            }
            #[inline]
            fn ratio(p: i64, q: i64) -> Self {
                Self::constant(V::ratio(p, q))
            }
            #[inline]
            fn decimal(text: &str) -> Self {
                Self::constant(V::decimal(text))
            }
            #[inline]
            fn pi() -> Self {
                Self::constant(V::pi())
            }
            #[inline]
            fn scale(self, k: f64) -> Self {
                Chain::affine(self, self.value.scale(k), k)
            }
            #[inline]
            fn add_f64(mut self, k: f64) -> Self {
                self.value = self.value.add_f64(k);
                self
            }
            #[inline]
            fn sqr(self) -> Self {
                self.chain(self.value.sqr(), || self.at().scale(2.0), || S::from_f64(2.0))
            }
            #[inline]
            fn recip(self) -> Self {
                let value = self.value.recip();
                let r: S = value.into();
                self.chain(value, || -r.sqr(), || (r.sqr() * r).scale(2.0))
            }
            #[inline]
            fn sqrt(self) -> Self {
                let value = self.value.sqrt();
                let inverse = || Into::<S>::into(value).recip();
                self.chain(value, || inverse().scale(0.5), || (inverse().sqr() * inverse()).scale(-0.25))
            }
            #[inline]
            fn powi(self, n: i32) -> Self {
                Chain::power(self, n)
            }
            #[inline]
            fn exp(self) -> Self {
                let value = self.value.exp();
                self.chain(value, || value.into(), || value.into())
            }
            #[inline]
            fn ln(self) -> Self {
                self.chain(self.value.ln(), || self.at().recip(), || -self.at().recip().sqr())
            }
            #[inline]
            fn sin(self) -> Self {
                let (sin, cos) = self.value.sin_cos();
                self.chain(sin, || cos.into(), || -sin.into())
            }
            #[inline]
            fn cos(self) -> Self {
                let (sin, cos) = self.value.sin_cos();
                self.chain(cos, || -sin.into(), || -cos.into())
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let (sin, cos) = self.value.sin_cos();
                (self.chain(sin, || cos.into(), || -sin.into()), self.chain(cos, || -sin.into(), || -cos.into()))
            }
            #[inline]
            fn tan(self) -> Self {
                let value = self.value.tan();
                let tan: S = value.into();
                let slope = || tan.sqr().add_f64(1.0);
                self.chain(value, slope, || (tan * slope()).scale(2.0))
            }
            #[inline]
            fn asin(self) -> Self {
                Chain::arc_sine(self)
            }
            #[inline]
            fn acos(self) -> Self {
                Chain::arc_cosine(self)
            }
            #[inline]
            fn atan(self) -> Self {
                let x = self.at();
                let slope = || x.sqr().add_f64(1.0).recip();
                self.chain(self.value.atan(), slope, || (x * slope().sqr()).scale(-2.0))
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                Chain::angle(self, x)
            }
            #[inline]
            fn sinh(self) -> Self {
                let value = self.value.sinh();
                self.chain(value, || self.at().cosh(), || value.into())
            }
            #[inline]
            fn cosh(self) -> Self {
                let value = self.value.cosh();
                self.chain(value, || self.at().sinh(), || value.into())
            }
            #[inline]
            fn tanh(self) -> Self {
                let value = self.value.tanh();
                // 1 - tanh^2, without its cancellation.
                let slope = || self.at().cosh().recip().sqr();
                self.chain(value, slope, || {
                    let tanh: S = value.into();
                    (tanh * slope()).scale(-2.0)
                })
            }
            #[inline]
            fn abs(self) -> Self {
                self.chain(self.value.abs(), || self.at().sign(), S::zero)
            }
            #[inline]
            fn sign(self) -> Self {
                self.chain(self.value.sign(), S::zero, S::zero)
            }
            #[inline]
            fn min(self, other: Self) -> Self {
                Chain::select(self, other, self.value.min(other.value), || other.at() - self.at())
            }
            #[inline]
            fn max(self, other: Self) -> Self {
                Chain::select(self, other, self.value.max(other.value), || self.at() - other.at())
            }
            #[inline]
            fn stumpff(self, k: usize) -> Self {
                Chain::stumpff_function(self, k)
            }
        }
    };
    (@operator [$($generics:tt)*] $type:ty, $trait:ident $method:ident $body:ident, $assign:ident $assign_method:ident) => {
        impl<$($generics)*> std::ops::$trait for $type {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$body(other)
            }
        }
        impl<$($generics)*> std::ops::$assign for $type {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = self.$body(other);
            }
        }
    };
}
pub(super) use impl_scalar;
