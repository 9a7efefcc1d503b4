//! Tapes as formulas.

use std::fmt;

use scalars::Interval;

use super::Tape;
use super::node::{Binary, Node, Unary};

/// Nested operations in one formula; deeper ones get a name of their own.
const DEPTH: u32 = 24;

/// How strongly an expression holds together: sums, products, powers, and what needs no parentheses.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Power,
    Atom,
}

impl fmt::Display for Tape {
    /// One line for every shared sub-expression (`t0 = ..`) and one for every output (`y[0] = ..`).
    ///
    /// Constants are printed as a short number that means the same set (`0.1`, `1/7`, `pi`), otherwise as an interval.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let printer = Printer { tape: self, names: self.names() };
        for (k, name) in printer.names.iter().enumerate() {
            if let Some(name) = name {
                write!(f, "t{name} = ")?;
                printer.operation(f, self.nodes[k], Binding::Sum)?;
                writeln!(f)?;
            }
        }
        for (k, &slot) in self.outputs.iter().enumerate() {
            write!(f, "y[{k}] = ")?;
            printer.value(f, slot, Binding::Sum)?;
            writeln!(f)?;
        }
        Ok(())
    }
}

impl Tape {
    /// The number of the name of each operation that has one: it is used more than once or nested deeply.
    fn names(&self) -> Vec<Option<usize>> {
        let first = self.first_node();
        let mut uses = vec![0_u32; self.slots()];
        for node in &self.nodes {
            let (a, b) = node.operands();
            [Some(a), b].into_iter().flatten().for_each(|slot| uses[slot as usize] += 1);
        }
        self.outputs.iter().for_each(|&slot| uses[slot as usize] += 1);
        let mut depths = vec![0_u32; self.slots()];
        let mut count = 0..;
        let mut name = |slot: usize| {
            let (a, b) = self.nodes[slot - first].operands();
            let depth = 1 + depths[a as usize].max(b.map_or(0, |b| depths[b as usize]));
            let named = uses[slot] > 1 || depth > DEPTH;
            depths[slot] = if named { 0 } else { depth };
            if named { count.next() } else { None }
        };
        (first..self.slots()).map(&mut name).collect()
    }
}

struct Printer<'t> {
    tape: &'t Tape,
    names: Vec<Option<usize>>,
}

impl Printer<'_> {
    /// A slot: its name, or its formula, in parentheses if it binds less than its surroundings ask for.
    fn value(&self, f: &mut fmt::Formatter<'_>, slot: u32, least: Binding) -> fmt::Result {
        let (slot, n, q) = (slot as usize, self.tape.variables, self.tape.parameters);
        if slot < n {
            return write!(f, "x[{slot}]");
        }
        if slot < n + q {
            return write!(f, "p[{}]", slot - n);
        }
        let first = self.tape.first_node();
        if slot < first {
            return constant(f, self.tape.constants[slot - n - q], least);
        }
        match self.names[slot - first] {
            Some(name) => write!(f, "t{name}"),
            None => self.operation(f, self.tape.nodes[slot - first], least),
        }
    }

    /// The operation of a slot that is printed where it is used.
    fn inline(&self, slot: u32) -> Option<Node> {
        let index = (slot as usize).checked_sub(self.tape.first_node())?;
        if self.names[index].is_none() { Some(self.tape.nodes[index]) } else { None }
    }

    fn operation(&self, f: &mut fmt::Formatter<'_>, node: Node, least: Binding) -> fmt::Result {
        let binding = binding(node);
        if binding < least {
            f.write_str("(")?;
        }
        match node {
            Node::Binary(Binary::Add, a, b) => match self.inline(b) {
                Some(Node::Scale(c, k)) if k.get() < 0.0 => {
                    self.value(f, a, Binding::Sum)?;
                    write!(f, " - {} * ", -k.get())?;
                    self.value(f, c, Binding::Product)?;
                }
                _ => self.infix(f, (a, Binding::Sum), " + ", (b, Binding::Sum))?,
            },
            Node::Binary(Binary::Sub, a, b) => self.infix(f, (a, Binding::Sum), " - ", (b, Binding::Product))?,
            Node::Binary(Binary::Mul, a, b) => self.infix(f, (a, Binding::Product), " * ", (b, Binding::Product))?,
            Node::Binary(Binary::Div, a, b) => self.infix(f, (a, Binding::Product), " / ", (b, Binding::Power))?,
            Node::Binary(operation, a, b) => {
                write!(f, "{}(", format!("{operation:?}").to_lowercase())?;
                self.infix(f, (a, Binding::Sum), ", ", (b, Binding::Sum))?;
                f.write_str(")")?;
            }
            Node::Unary(Unary::Neg, a) => {
                f.write_str("-")?;
                self.value(f, a, Binding::Power)?;
            }
            Node::Unary(Unary::Recip, a) => {
                f.write_str("1 / ")?;
                self.value(f, a, Binding::Power)?;
            }
            Node::Unary(Unary::Sqr, a) => self.power(f, a, 2)?,
            Node::Power(a, n) => self.power(f, a, n)?,
            Node::Unary(operation, a) => {
                write!(f, "{}(", format!("{operation:?}").to_lowercase())?;
                self.value(f, a, Binding::Sum)?;
                f.write_str(")")?;
            }
            Node::Scale(a, k) => {
                write!(f, "{} * ", k.get())?;
                self.value(f, a, Binding::Product)?;
            }
            Node::Shift(a, k) => {
                self.value(f, a, Binding::Sum)?;
                let sign = if k.get() < 0.0 { '-' } else { '+' };
                write!(f, " {sign} {}", k.get().abs())?;
            }
            Node::Stumpff(a, k) => {
                write!(f, "stumpff{k}(")?;
                self.value(f, a, Binding::Sum)?;
                f.write_str(")")?;
            }
        }
        if binding < least {
            f.write_str(")")?;
        }
        Ok(())
    }

    fn infix(&self, f: &mut fmt::Formatter<'_>, a: (u32, Binding), sign: &str, b: (u32, Binding)) -> fmt::Result {
        self.value(f, a.0, a.1)?;
        f.write_str(sign)?;
        self.value(f, b.0, b.1)
    }

    fn power(&self, f: &mut fmt::Formatter<'_>, a: u32, n: i32) -> fmt::Result {
        self.value(f, a, Binding::Atom)?;
        if n < 0 { write!(f, "^({n})") } else { write!(f, "^{n}") }
    }
}

fn binding(node: Node) -> Binding {
    match node {
        Node::Binary(Binary::Add | Binary::Sub, ..) | Node::Shift(..) | Node::Unary(Unary::Neg, _) => Binding::Sum,
        Node::Binary(Binary::Mul | Binary::Div, ..) | Node::Scale(..) | Node::Unary(Unary::Recip, _) => {
            Binding::Product
        }
        Node::Unary(Unary::Sqr, _) | Node::Power(..) => Binding::Power,
        _ => Binding::Atom,
    }
}

/// A number, `pi`, a short decimal or fraction that encloses the same, or the interval itself.
fn constant(f: &mut fmt::Formatter<'_>, c: Interval, least: Binding) -> fmt::Result {
    let mid = c.mid();
    let text = if c == Interval::point(mid) {
        format!("{mid}")
    } else if c == Interval::PI {
        return f.write_str("pi");
    } else if let decimal = format!("{mid}")
        && decimal.len() < 12
        && Interval::decimal(&decimal) == c
    {
        decimal
    } else if let Some((p, q)) = fraction(c) {
        if least > Binding::Sum {
            return write!(f, "({p}/{q})");
        }
        format!("{p}/{q}")
    } else {
        return write!(f, "{c}");
    };
    // The sign of a negative number binds as a difference does.
    if text.starts_with('-') && least > Binding::Sum { write!(f, "({text})") } else { f.write_str(&text) }
}

/// The fraction of a small denominator that is recorded as this interval.
fn fraction(c: Interval) -> Option<(i64, i64)> {
    let mid = c.mid();
    if !c.is_bounded() || mid.abs() > 1e9 {
        return None;
    }
    (2..=1000).map(|q| ((mid * q as f64).round() as i64, q)).find(|&(p, q)| Interval::ratio(p, q) == c)
}
