//! [`Node`]: one operation of a tape.

use scalars::{Interval, Scalar};

/// A floating-point number by its bits, so that nodes can be compared and hashed; `-0` counts as `0`, and all NaNs are one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Bits(u64);

impl Bits {
    pub(crate) fn new(x: f64) -> Self {
        Self(if x.is_nan() { f64::NAN.to_bits() } else { (x + 0.0).to_bits() })
    }

    #[inline]
    pub(crate) fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// Operations of one operand and nothing else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Unary {
    Neg,
    Sqr,
    Recip,
    Abs,
    Sign,
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
}

/// Operations of two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Min,
    Max,
    /// The angle of the point (second, first).
    Atan2,
}

/// An operation and the slots of its operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    /// A function of one operand.
    Unary(Unary, u32),
    /// A function of two operands.
    Binary(Binary, u32, u32),
    /// `k x`.
    Scale(u32, Bits),
    /// `x + k`.
    Shift(u32, Bits),
    /// `x^n`.
    Power(u32, i32),
    /// `C_k(x)`.
    Stumpff(u32, u32),
}

impl Node {
    /// The value of the operation, from the values of its operands.
    #[inline]
    pub(crate) fn apply<S: Scalar>(self, values: &[S]) -> S {
        let at = |slot: u32| values[slot as usize];
        match self {
            Self::Binary(operation, a, b) => {
                let (a, b) = (at(a), at(b));
                match operation {
                    Binary::Add => a + b,
                    Binary::Sub => a - b,
                    Binary::Mul => a * b,
                    Binary::Div => a / b,
                    Binary::Min => a.min(b),
                    Binary::Max => a.max(b),
                    Binary::Atan2 => a.atan2(b),
                }
            }
            Self::Unary(operation, a) => {
                let a = at(a);
                match operation {
                    Unary::Neg => -a,
                    Unary::Sqr => a.sqr(),
                    Unary::Recip => a.recip(),
                    Unary::Abs => a.abs(),
                    Unary::Sign => a.sign(),
                    Unary::Sqrt => a.sqrt(),
                    Unary::Exp => a.exp(),
                    Unary::Ln => a.ln(),
                    Unary::Sin => a.sin(),
                    Unary::Cos => a.cos(),
                    Unary::Tan => a.tan(),
                    Unary::Asin => a.asin(),
                    Unary::Acos => a.acos(),
                    Unary::Atan => a.atan(),
                    Unary::Sinh => a.sinh(),
                    Unary::Cosh => a.cosh(),
                    Unary::Tanh => a.tanh(),
                }
            }
            Self::Scale(a, k) => at(a).scale(k.get()),
            Self::Shift(a, k) => at(a).add_f64(k.get()),
            Self::Power(a, n) => at(a).powi(n),
            Self::Stumpff(a, k) => at(a).stumpff(k as usize),
        }
    }

    /// The slots of the operands; the second is missing for a function of one.
    #[inline]
    pub(crate) fn operands(self) -> (u32, Option<u32>) {
        match self {
            Self::Binary(_, a, b) => (a, Some(b)),
            Self::Unary(_, a) | Self::Scale(a, _) | Self::Shift(a, _) | Self::Power(a, _) | Self::Stumpff(a, _) => {
                (a, None)
            }
        }
    }

    /// The same operation on operands at other slots; the second is ignored by a function of one.
    pub(crate) fn with_operands(self, a: u32, b: u32) -> Self {
        match self {
            Self::Unary(operation, _) => Self::Unary(operation, a),
            Self::Binary(operation, ..) => Self::Binary(operation, a, b),
            Self::Scale(_, k) => Self::Scale(a, k),
            Self::Shift(_, k) => Self::Shift(a, k),
            Self::Power(_, n) => Self::Power(a, n),
            Self::Stumpff(_, k) => Self::Stumpff(a, k),
        }
    }

    /// Defined for all real operands.
    pub(crate) fn is_total(self) -> bool {
        match self {
            Self::Unary(operation, _) => {
                !matches!(operation, Unary::Recip | Unary::Sqrt | Unary::Ln | Unary::Tan | Unary::Asin | Unary::Acos)
            }
            Self::Binary(operation, ..) => !matches!(operation, Binary::Div | Binary::Atan2),
            Self::Scale(_, k) | Self::Shift(_, k) => k.get().is_finite(),
            Self::Power(_, n) => n >= 0,
            Self::Stumpff(..) => true,
        }
    }

    /// True if some members of the operand's range lie outside the domain of the operation, and an interval can say so.
    #[inline]
    pub(crate) fn leaves_domain(self, operand: Interval) -> bool {
        match self {
            Self::Unary(Unary::Sqrt | Unary::Ln, _) => operand.lo() < 0.0,
            Self::Unary(Unary::Asin | Unary::Acos, _) => operand.mag() > 1.0,
            _ => false,
        }
    }
}
