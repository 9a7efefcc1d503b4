//! [`Recorder`]: collects operations, each once, in a simple form.
//!
//! Rewriting rules keep three promises. Values stay those of the expression written: only exact identities of real numbers are used.
//! Enclosures stay or get tighter: `x + 0 -> x`, `x x -> x^2`, `-(-x) -> x`, constants as operands of `scale` and `add_f64`. And the
//! domain stays: a term is dropped (`0 x -> 0`, `x - x -> 0`) only if it is defined everywhere.

use std::collections::HashMap;

use scalars::{Interval, Scalar};

use super::node::{Binary, Bits, Node, Unary};
use crate::{Decorated, Smoothness};

/// What a recorded value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Entry {
    Variable(u32),
    Parameter(u32),
    /// A number between two bounds.
    Constant(Bits, Bits),
    Node(Node),
}

/// The values recorded so far; each is named by its position.
#[derive(Debug, Default)]
pub(super) struct Recorder {
    entries: Vec<Entry>,
    /// Defined for all real variables and parameters.
    total: Vec<bool>,
    /// The first two constants, etc., by what they are.
    positions: HashMap<Entry, u32>,
    /// The constants, for folding: one for each entry, the whole line where it is no constant.
    constants: Vec<Decorated>,
}

impl Recorder {
    /// The values, in the order they were recorded: operands come first.
    pub(super) fn entries(&self) -> &[Entry] {
        &self.entries
    }

    pub(super) fn entry(&self, position: u32) -> Entry {
        self.entries[position as usize]
    }

    /// The position of a value, new or known.
    pub(super) fn intern(&mut self, entry: Entry) -> u32 {
        if let Some(&known) = self.positions.get(&entry) {
            return known;
        }
        let unknown = Decorated::constant(Interval::ENTIRE);
        let (total, constant) = match entry {
            Entry::Variable(_) | Entry::Parameter(_) => (true, unknown),
            Entry::Constant(lo, hi) => {
                let constant = Decorated::lit(lo.get(), hi.get());
                (constant.smoothness() > Smoothness::Undefined, constant)
            }
            Entry::Node(node) => {
                let (a, b) = node.operands();
                let total = |k: u32| self.total[k as usize];
                (node.is_total() && total(a) && b.is_none_or(total), unknown)
            }
        };
        // Four thousand million operations do not fit into memory; the cast can not wrap before that.
        let position = self.entries.len() as u32;
        self.entries.push(entry);
        self.total.push(total);
        self.constants.push(constant);
        self.positions.insert(entry, position);
        position
    }

    pub(super) fn constant(&mut self, value: Interval) -> u32 {
        self.intern(Entry::Constant(Bits::new(value.lo()), Bits::new(value.hi())))
    }

    /// Records an operation, or what it is equal to.
    pub(super) fn record(&mut self, node: Node) -> u32 {
        if let Some(value) = self.folded(node) {
            return self.constant(value);
        }
        match node {
            Node::Unary(operation, a) => self.unary(operation, a),
            Node::Binary(Binary::Add, a, b) => self.add(a, b),
            Node::Binary(Binary::Sub, a, b) => self.sub(a, b),
            Node::Binary(Binary::Mul, a, b) => self.mul(a, b),
            Node::Binary(operation @ (Binary::Min | Binary::Max), a, b) => {
                if a == b {
                    a
                } else {
                    self.commutative(operation, a, b)
                }
            }
            Node::Binary(Binary::Div, a, b) => match self.point(b) {
                Some(1.0) => a,
                Some(-1.0) => self.record(Node::Unary(Unary::Neg, a)),
                _ => self.intern(Entry::Node(node)),
            },
            Node::Scale(a, k) => self.scale(a, k.get()),
            Node::Shift(a, k) if k.get() == 0.0 => a,
            Node::Power(a, 0) if self.total[a as usize] => self.constant(Interval::ONE),
            Node::Power(a, 1) => a,
            Node::Power(a, 2) => self.record(Node::Unary(Unary::Sqr, a)),
            Node::Power(a, -1) => self.record(Node::Unary(Unary::Recip, a)),
            _ => self.intern(Entry::Node(node)),
        }
    }

    /// The range of an operation on constants, if it is defined and a number up to rounding: a wide constant is not folded, so that over `f64` the
    /// function stays the one written.
    fn folded(&self, node: Node) -> Option<Interval> {
        let is_constant = |k: u32| matches!(self.entry(k), Entry::Constant(..));
        let (a, b) = node.operands();
        if !(is_constant(a) && b.is_none_or(is_constant)) {
            return None;
        }
        let result = node.apply(&self.constants);
        let (value, is_defined) = (result.range(), result.smoothness() > Smoothness::Undefined);
        (is_defined && value.is_bounded() && value.width() <= 1e-13 * value.mag()).then_some(value)
    }

    /// The floating-point number that a constant is exactly.
    fn point(&self, position: u32) -> Option<f64> {
        match self.entry(position) {
            Entry::Constant(lo, hi) if lo == hi && lo.get().is_finite() => Some(lo.get()),
            _ => None,
        }
    }

    /// `x` of `-x`.
    fn negated(&self, position: u32) -> Option<u32> {
        match self.entry(position) {
            Entry::Node(Node::Unary(Unary::Neg, a)) => Some(a),
            _ => None,
        }
    }

    fn commutative(&mut self, operation: Binary, a: u32, b: u32) -> u32 {
        self.intern(Entry::Node(Node::Binary(operation, a.min(b), a.max(b))))
    }

    fn unary(&mut self, operation: Unary, a: u32) -> u32 {
        let replaced = match (operation, self.entry(a)) {
            (Unary::Neg, Entry::Node(Node::Unary(Unary::Neg, b))) => return b,
            (Unary::Neg, Entry::Node(Node::Scale(b, k))) => Node::Scale(b, Bits::new(-k.get())),
            (Unary::Neg, Entry::Node(Node::Binary(Binary::Sub, b, c))) => Node::Binary(Binary::Sub, c, b),
            (Unary::Sqr | Unary::Abs, Entry::Node(Node::Unary(Unary::Neg, b))) => Node::Unary(operation, b),
            _ => Node::Unary(operation, a),
        };
        self.intern(Entry::Node(replaced))
    }

    fn add(&mut self, a: u32, b: u32) -> u32 {
        if a == b {
            return self.scale(a, 2.0);
        }
        match (self.point(a), self.point(b), self.negated(a), self.negated(b)) {
            (_, Some(k), ..) => self.record(Node::Shift(a, Bits::new(k))),
            (Some(k), ..) => self.record(Node::Shift(b, Bits::new(k))),
            (_, _, _, Some(c)) => self.sub(a, c),
            (_, _, Some(c), _) => self.sub(b, c),
            _ => self.commutative(Binary::Add, a, b),
        }
    }

    fn sub(&mut self, a: u32, b: u32) -> u32 {
        if a == b && self.total[a as usize] {
            return self.constant(Interval::ZERO);
        }
        match (self.point(a), self.point(b), self.negated(b)) {
            (_, Some(k), _) => self.record(Node::Shift(a, Bits::new(-k))),
            (Some(0.0), ..) => self.record(Node::Unary(Unary::Neg, b)),
            (_, _, Some(c)) => self.record(Node::Binary(Binary::Add, a, c)),
            _ => self.intern(Entry::Node(Node::Binary(Binary::Sub, a, b))),
        }
    }

    fn mul(&mut self, a: u32, b: u32) -> u32 {
        if a == b {
            return self.record(Node::Unary(Unary::Sqr, a));
        }
        match (self.point(a), self.point(b), self.negated(a), self.negated(b)) {
            (_, Some(k), ..) => self.scale(a, k),
            (Some(k), ..) => self.scale(b, k),
            (_, _, Some(c), Some(d)) => self.mul(c, d),
            (_, _, Some(c), None) | (_, _, None, Some(c)) => {
                let product = self.record(Node::Binary(Binary::Mul, if self.negated(a).is_some() { b } else { a }, c));
                self.record(Node::Unary(Unary::Neg, product))
            }
            _ => self.commutative(Binary::Mul, a, b),
        }
    }

    fn scale(&mut self, a: u32, k: f64) -> u32 {
        match (k, self.negated(a)) {
            (1.0, _) => a,
            (-1.0, _) => self.record(Node::Unary(Unary::Neg, a)),
            (0.0, _) if self.total[a as usize] => self.constant(Interval::ZERO),
            (_, Some(b)) => self.scale(b, -k),
            _ => self.intern(Entry::Node(Node::Scale(a, Bits::new(k)))),
        }
    }
}
