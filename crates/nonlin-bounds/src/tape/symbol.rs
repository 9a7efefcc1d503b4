//! [`Symbol`]: the scalar that a function is recorded with.
//!
//! A symbol is a position in the recording under way on this thread. Recordings nest (a function may record another one while it is
//! recorded itself): the innermost takes the operations. A symbol that does not belong to it can only arrive through the back door of
//! `Any`; it stands for an unknown number, which is safe.

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use scalars::{Interval, Scalar};

use super::node::{Binary, Bits, Node, Unary};
use super::recorder::{Entry, Recorder};

thread_local! {
    /// The recordings under way on this thread, the innermost last, and how many there have been.
    static RECORDINGS: RefCell<(u64, Vec<(u64, Recorder)>)> = const { RefCell::new((0, Vec::new())) };
}

/// A value of a function that is being recorded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Symbol {
    /// Number of the recording, from 1.
    recording: u64,
    position: u32,
}

/// A recording under way; dropped early by a panic in the function, it leaves the ones around it as they were.
pub(super) struct Recording(u64);

impl Recording {
    pub(super) fn start() -> Self {
        RECORDINGS.with_borrow_mut(|(count, stack)| {
            *count += 1;
            stack.push((*count, Recorder::default()));
            Self(*count)
        })
    }

    pub(super) fn variable(&self, index: usize) -> Symbol {
        with_recorder(|recorder| recorder.intern(Entry::Variable(index as u32)))
    }

    pub(super) fn parameter(&self, index: usize) -> Symbol {
        with_recorder(|recorder| recorder.intern(Entry::Parameter(index as u32)))
    }

    /// What was recorded, and the positions of the outputs in it.
    pub(super) fn finish(self, outputs: &[Symbol]) -> (Recorder, Vec<u32>) {
        RECORDINGS.with_borrow_mut(|(_, stack)| {
            let (id, mut recorder) = stack.pop().unwrap_or_default();
            let outputs = outputs.iter().map(|symbol| symbol.position_in(id, &mut recorder)).collect();
            (recorder, outputs)
        })
    }
}

impl Drop for Recording {
    fn drop(&mut self) {
        RECORDINGS.with_borrow_mut(|(_, stack)| stack.retain(|(id, _)| *id != self.0));
    }
}

/// A value made by the innermost recording; without one, a symbol of none.
fn with_recorder(make: impl FnOnce(&mut Recorder) -> u32) -> Symbol {
    with_recording(|_, recorder| make(recorder))
}

fn with_recording(make: impl FnOnce(u64, &mut Recorder) -> u32) -> Symbol {
    RECORDINGS.with_borrow_mut(|(_, stack)| match stack.last_mut() {
        Some((id, recorder)) => Symbol { recording: *id, position: make(*id, recorder) },
        None => Symbol { recording: 0, position: 0 },
    })
}

impl Symbol {
    fn position_in(self, recording: u64, recorder: &mut Recorder) -> u32 {
        if self.recording == recording { self.position } else { recorder.constant(Interval::ENTIRE) }
    }

    fn constant(value: Interval) -> Self {
        with_recorder(|recorder| recorder.constant(value))
    }

    fn apply(self, node: impl FnOnce(u32) -> Node) -> Self {
        with_recording(|id, recorder| {
            let a = self.position_in(id, recorder);
            recorder.record(node(a))
        })
    }

    fn unary(self, operation: Unary) -> Self {
        self.apply(|a| Node::Unary(operation, a))
    }

    fn binary(self, operation: Binary, other: Self) -> Self {
        with_recording(|id, recorder| {
            let (a, b) = (self.position_in(id, recorder), other.position_in(id, recorder));
            recorder.record(Node::Binary(operation, a, b))
        })
    }
}

/// Operators as operations on the recording.
macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident),* $(,)?) => {$(
        impl $trait for Symbol {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.binary(Binary::$trait, other)
            }
        }
        impl $assign for Symbol {
            fn $assign_method(&mut self, other: Self) {
                *self = self.binary(Binary::$trait, other);
            }
        }
    )*};
}
operators!(
    Add add AddAssign add_assign,
    Sub sub SubAssign sub_assign,
    Mul mul MulAssign mul_assign,
    Div div DivAssign div_assign,
);

impl Neg for Symbol {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Unary::Neg)
    }
}

impl Zero for Symbol {
    fn zero() -> Self {
        Self::constant(Interval::ZERO)
    }
    /// True for the constant 0: structure, not a value.
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Symbol {
    fn one() -> Self {
        Self::constant(Interval::ONE)
    }
}

/// Methods that are one node without further data.
macro_rules! functions {
    ($($method:ident $operation:ident),* $(,)?) => {$(
        fn $method(self) -> Self {
            self.unary(Unary::$operation)
        }
    )*};
}

impl Scalar for Symbol {
    fn from_f64(x: f64) -> Self {
        Self::constant(Interval::point(x))
    }
    fn lit(lo: f64, hi: f64) -> Self {
        Self::constant(<Interval as Scalar>::lit(lo, hi))
    }
    fn ratio(p: i64, q: i64) -> Self {
        Self::constant(Interval::ratio(p, q))
    }
    fn decimal(text: &str) -> Self {
        Self::constant(Interval::decimal(text))
    }
    fn pi() -> Self {
        Self::constant(Interval::PI)
    }
    fn scale(self, k: f64) -> Self {
        self.apply(|a| Node::Scale(a, Bits::new(k)))
    }
    fn add_f64(self, k: f64) -> Self {
        self.apply(|a| Node::Shift(a, Bits::new(k)))
    }
    fn powi(self, n: i32) -> Self {
        self.apply(|a| Node::Power(a, n))
    }
    fn stumpff(self, k: usize) -> Self {
        self.apply(|a| Node::Stumpff(a, u32::try_from(k).unwrap_or(u32::MAX)))
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x)
    }
    fn min(self, other: Self) -> Self {
        self.binary(Binary::Min, other)
    }
    fn max(self, other: Self) -> Self {
        self.binary(Binary::Max, other)
    }
    functions!(
        sqr Sqr, recip Recip, sqrt Sqrt, exp Exp, ln Ln, sin Sin, cos Cos, tan Tan, asin Asin, acos Acos, atan Atan,
        sinh Sinh, cosh Cosh, tanh Tanh, abs Abs, sign Sign,
    );
}
