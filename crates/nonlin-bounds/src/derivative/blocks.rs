//! Enclosures of value, Jacobian and Hessians of a [`Function`] by passes over blocks of variables.
//!
//! One pass carries the derivatives by at most eight variables. Up to eight variables take one pass; the Jacobian of more takes one
//! pass for every eight, the Hessians one for every pair of blocks of four. Variables outside the blocks of a pass are ranges without
//! derivatives.

use scalars::{Interval, Scalar};

use super::second::packed;
use super::{Decorated, Dual, Second};
use crate::function::check_box;
use crate::{BoundError, Function, Jet, Operand, Order, Smoothness};

/// A number type that passes are made with.
trait Pass: Scalar {
    /// Most variables of a pass.
    const WIDTH: usize;
    /// The buffer for numbers of this type.
    fn buffer(scratch: &mut Scratch) -> &mut Vec<Self>;
    /// A number of this range; the variable of a position, if one is given.
    fn seed(value: Decorated, position: Option<usize>) -> Self;
    /// The range, and what is proven.
    fn value(&self) -> Decorated;
    /// True if the number depends on the variable at a position.
    fn depends_on(&self, position: usize) -> bool;
    /// The derivative by the variable at a position.
    fn first(&self, position: usize) -> Interval;
    /// The second derivative by those at positions `i <= j`; the whole line if the type has none.
    fn second(&self, i: usize, j: usize) -> Interval;
}

/// Buffers of all passes, one for each number type; they hold no result.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    values: Vec<Decorated>,
    dual2: Vec<Dual<Interval, 2, Decorated>>,
    dual4: Vec<Dual<Interval, 4, Decorated>>,
    dual8: Vec<Dual<Interval, 8, Decorated>>,
    second2: Vec<Second<Interval, 2, 3, Decorated>>,
    second4: Vec<Second<Interval, 4, 10, Decorated>>,
    second8: Vec<Second<Interval, 8, 36, Decorated>>,
}

impl Pass for Decorated {
    const WIDTH: usize = 0;
    fn buffer(scratch: &mut Scratch) -> &mut Vec<Self> {
        &mut scratch.values
    }
    fn seed(value: Decorated, _: Option<usize>) -> Self {
        value
    }
    fn value(&self) -> Decorated {
        *self
    }
    fn depends_on(&self, _: usize) -> bool {
        true
    }
    fn first(&self, _: usize) -> Interval {
        Interval::ENTIRE
    }
    fn second(&self, _: usize, _: usize) -> Interval {
        Interval::ENTIRE
    }
}

macro_rules! passes {
    ($($type:ty, $width:literal, $buffer:ident, $second:expr;)*) => {$(
        impl Pass for $type {
            const WIDTH: usize = $width;
            fn buffer(scratch: &mut Scratch) -> &mut Vec<Self> {
                &mut scratch.$buffer
            }
            fn seed(value: Decorated, position: Option<usize>) -> Self {
                position.map_or(Self::constant(value), |position| Self::variable(value, position))
            }
            fn value(&self) -> Decorated {
                self.value()
            }
            fn depends_on(&self, position: usize) -> bool {
                self.depends_on(position)
            }
            fn first(&self, position: usize) -> Interval {
                self.gradient()[position]
            }
            fn second(&self, i: usize, j: usize) -> Interval {
                let second: fn(&Self, usize, usize) -> Interval = $second;
                second(self, i, j)
            }
        }
    )*};
}
passes! {
    Dual<Interval, 2, Decorated>, 2, dual2, |_, _, _| Interval::ENTIRE;
    Dual<Interval, 4, Decorated>, 4, dual4, |_, _, _| Interval::ENTIRE;
    Dual<Interval, 8, Decorated>, 8, dual8, |_, _, _| Interval::ENTIRE;
    Second<Interval, 2, 3, Decorated>, 2, second2, |x, i, j| x.hessian()[packed(2, i, j)];
    Second<Interval, 4, 10, Decorated>, 4, second4, |x, i, j| x.hessian()[packed(4, i, j)];
    Second<Interval, 8, 36, Decorated>, 8, second8, |x, i, j| x.hessian()[packed(8, i, j)];
}

/// The body of [`DynFunction::enclose`](crate::DynFunction::enclose) for a [`Function`].
pub(crate) fn enclose<F: Function>(
    f: &F,
    order: Order,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    check_box(Operand::Variables, f.variables(), x)?;
    check_box(Operand::Parameters, f.parameters(), p)?;
    jet.reset(order, x.len(), f.outputs());
    let mut scratch = std::mem::take(&mut jet.scratch);
    let job = Job { f, x, p, jet, scratch: &mut scratch };
    match (order, x.len()) {
        (Order::Value, _) | (_, 0) => job.values(),
        (Order::Jacobian, ..=2) => job.jacobian::<Dual<Interval, 2, Decorated>>(),
        (Order::Jacobian, ..=4) => job.jacobian::<Dual<Interval, 4, Decorated>>(),
        (Order::Jacobian, _) => job.jacobian::<Dual<Interval, 8, Decorated>>(),
        (Order::Hessian, ..=2) => job.hessians::<Second<Interval, 2, 3, Decorated>>(),
        (Order::Hessian, ..=4) => job.hessians::<Second<Interval, 4, 10, Decorated>>(),
        (Order::Hessian, _) => job.hessians::<Second<Interval, 8, 36, Decorated>>(),
    }
    jet.scratch = scratch;
    Ok(())
}

/// One call: the function, where it is evaluated, and where the results go.
struct Job<'a, F> {
    f: &'a F,
    x: &'a [Interval],
    p: &'a [Interval],
    jet: &'a mut Jet,
    scratch: &'a mut Scratch,
}

impl<F: Function> Job<'_, F> {
    fn values(mut self) {
        self.pass::<Decorated>(&[]);
    }

    fn jacobian<D: Pass>(mut self) {
        let mut block = [0; 8];
        for start in (0..self.x.len()).step_by(D::WIDTH) {
            let width = fill(&mut block, start..self.x.len().min(start + D::WIDTH), 0);
            self.pass::<D>(&block[..width]);
        }
    }

    fn hessians<D: Pass>(mut self) {
        let n = self.x.len();
        let mut block = [0; 8];
        if n <= D::WIDTH {
            let width = fill(&mut block, 0..n, 0);
            return self.pass::<D>(&block[..width]);
        }
        let half = D::WIDTH / 2;
        for low in (0..n).step_by(half) {
            for high in (low + half..n).step_by(half) {
                let width = fill(&mut block, low..low + half, 0);
                let width = fill(&mut block, high..n.min(high + half), width);
                self.pass::<D>(&block[..width]);
            }
        }
    }

    /// Evaluates with derivatives by the variables of `block`, in ascending order, and stores all that is found.
    fn pass<D: Pass>(&mut self, block: &[usize]) {
        let (n, m) = (self.x.len(), self.f.outputs());
        let buffer = D::buffer(self.scratch);
        buffer.clear();
        buffer.extend(self.x.iter().map(|&x| D::seed(Decorated::variable(x), None)));
        for (position, &index) in block.iter().enumerate() {
            buffer[index] = D::seed(Decorated::variable(self.x[index]), Some(position));
        }
        buffer.extend(self.p.iter().map(|&p| D::seed(Decorated::constant(p), None)));
        buffer.resize(n + self.p.len() + m, D::zero());
        let (x, rest) = buffer.split_at_mut(n);
        let (p, y) = rest.split_at_mut(self.p.len());
        self.f.eval::<D>(x, p, y);

        let (values, jacobian, hessians, smoothness) = self.jet.parts_mut();
        for (output, y) in y.iter().enumerate() {
            let value = y.value();
            values[output] = value.range();
            smoothness[output] = value.smoothness();
            if jacobian.is_empty() {
                continue;
            }
            let row = &mut jacobian[output * n..][..n];
            for (position, &index) in block.iter().enumerate() {
                let known = value.smoothness() >= Smoothness::C1 || !y.depends_on(position);
                row[index] = if known { y.first(position) } else { Interval::ENTIRE };
            }
            if hessians.is_empty() {
                continue;
            }
            let entries = n * (n + 1) / 2;
            let hessian = &mut hessians[output * entries..][..entries];
            for (i, &row) in block.iter().enumerate() {
                for (j, &column) in block.iter().enumerate().skip(i) {
                    let known = value.smoothness() >= Smoothness::C2 || !(y.depends_on(i) && y.depends_on(j));
                    hessian[packed(n, row, column)] = if known { y.second(i, j) } else { Interval::ENTIRE };
                }
            }
        }
    }
}

/// Writes the indices to `block` from position `start` on and returns where they end.
fn fill(block: &mut [usize; 8], indices: std::ops::Range<usize>, start: usize) -> usize {
    let end = start + indices.len();
    for (slot, index) in block[start..end].iter_mut().zip(indices) {
        *slot = index;
    }
    end
}
