//! Enclosures of value, Jacobian and Hessians of a [`Function`] by passes over blocks of variables.
//!
//! One pass carries the derivatives by at most eight variables. Up to eight variables take one pass; the Jacobian of more takes one
//! pass for every eight, the Hessians one for every pair of blocks of four. Variables outside the blocks of a pass are ranges without
//! derivatives.

use scalars::{Interval, Scalar};

use super::second::packed;
use super::{Decorated, Dual, Second};
use crate::{BoundError, Function, Jet, Operand, Order, Smoothness};

/// A number type that passes are made with.
pub(crate) trait Pass: Scalar {
    /// Most variables of a pass.
    const WIDTH: usize;
    /// Whether the type has second derivatives.
    const HAS_SECOND: bool = false;
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

/// What a pass evaluates: a function, or the flow of a differential equation.
pub(crate) trait Evaluate<D> {
    /// Number of outputs.
    fn outputs(&self) -> usize;
    /// Writes the outputs to `y`.
    fn evaluate(&self, x: &[D], p: &[D], y: &mut [D]) -> Result<(), BoundError>;
}

impl<F: Function, D: Pass> Evaluate<D> for F {
    fn outputs(&self) -> usize {
        Function::outputs(self)
    }
    fn evaluate(&self, x: &[D], p: &[D], y: &mut [D]) -> Result<(), BoundError> {
        self.eval(x, p, y);
        Ok(())
    }
}

/// A number type whose ranges can be compared and widened, all parts at once.
pub(crate) trait Enclosure: Pass {
    /// A quantity with the given ranges, from those of two others: of value and derivatives, part by part.
    fn zip_ranges(&self, other: &Self, f: impl Fn(Interval, Interval) -> Interval) -> Self;
    /// True if `f` holds for the ranges of all parts.
    fn all_ranges(&self, other: &Self, f: impl Fn(Interval, Interval) -> bool) -> bool;
}

impl Enclosure for Decorated {
    fn zip_ranges(&self, other: &Self, f: impl Fn(Interval, Interval) -> Interval) -> Self {
        Self::variable(f(self.range(), other.range()))
    }
    fn all_ranges(&self, other: &Self, f: impl Fn(Interval, Interval) -> bool) -> bool {
        f(self.range(), other.range())
    }
}

impl<const N: usize> Enclosure for Dual<Interval, N, Decorated>
where
    Self: Pass,
{
    fn zip_ranges(&self, other: &Self, f: impl Fn(Interval, Interval) -> Interval) -> Self {
        self.combine(
            other,
            self.value().zip_ranges(&other.value(), &f),
            &f,
            |a| f(a, Interval::ZERO),
            |b| f(Interval::ZERO, b),
        )
    }
    fn all_ranges(&self, other: &Self, f: impl Fn(Interval, Interval) -> bool) -> bool {
        self.value().all_ranges(&other.value(), &f)
            && self.gradient().iter().zip(other.gradient()).all(|(&a, &b)| f(a, b))
    }
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
    /// Results of an evaluation that can fail, until it has not.
    pub(crate) draft: Option<Box<Jet>>,
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
    ($($type:ty, $width:literal, $buffer:ident, $has_second:literal, $second:expr;)*) => {$(
        impl Pass for $type {
            const WIDTH: usize = $width;
            const HAS_SECOND: bool = $has_second;
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
    Dual<Interval, 2, Decorated>, 2, dual2, false, |_, _, _| Interval::ENTIRE;
    Dual<Interval, 4, Decorated>, 4, dual4, false, |_, _, _| Interval::ENTIRE;
    Dual<Interval, 8, Decorated>, 8, dual8, false, |_, _, _| Interval::ENTIRE;
    Second<Interval, 2, 3, Decorated>, 2, second2, true, |x, i, j| x.hessian()[packed(2, i, j)];
    Second<Interval, 4, 10, Decorated>, 4, second4, true, |x, i, j| x.hessian()[packed(4, i, j)];
    Second<Interval, 8, 36, Decorated>, 8, second8, true, |x, i, j| x.hessian()[packed(8, i, j)];
}

/// The body of [`DynFunction::enclose`](crate::DynFunction::enclose) for a [`Function`].
pub(crate) fn enclose<F: Function>(
    f: &F,
    order: Order,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    BoundError::check_box(Operand::Variables, f.variables(), x)?;
    BoundError::check_box(Operand::Parameters, f.parameters(), p)?;
    if order == Order::Value || x.is_empty() {
        return values(f, order, x, p, jet);
    }
    // Branches of constants: a pass that this type of function never takes is not compiled for it.
    if const { takes(F::VARIABLES, 0, 2) } && x.len() <= 2 {
        return derivatives::<_, Dual<Interval, 2, Decorated>, Second<Interval, 2, 3, Decorated>>(f, order, x, p, jet);
    }
    if const { takes(F::VARIABLES, 3, 4) } && x.len() <= 4 {
        return derivatives::<_, Dual<Interval, 4, Decorated>, Second<Interval, 4, 10, Decorated>>(f, order, x, p, jet);
    }
    if const { takes(F::VARIABLES, 5, usize::MAX) } {
        return derivatives::<_, Dual<Interval, 8, Decorated>, Second<Interval, 8, 36, Decorated>>(f, order, x, p, jet);
    }
    // Only where the constant is not the number of variables.
    BoundError::check_size(Operand::Variables, F::VARIABLES.unwrap_or_default(), x.len())
}

/// Whether functions with this constant can have a number of variables from `least` to `most`.
pub(crate) const fn takes(variables: Option<usize>, least: usize, most: usize) -> bool {
    match variables {
        Some(n) => least <= n && n <= most,
        None => true,
    }
}

/// Derivatives of order one or two, by passes of the type for each.
fn derivatives<F: Function, D: Pass, H: Pass>(
    f: &F,
    order: Order,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    if order == Order::Hessian { hessians::<_, H>(f, x, p, jet) } else { jacobian::<_, D>(f, x, p, jet) }
}

/// Ranges only.
pub(crate) fn values<E: Evaluate<Decorated>>(
    f: &E,
    order: Order,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    jet.reset(order, x.len(), f.outputs());
    pass::<E, Decorated>(f, x, p, &[], jet)
}

/// Ranges and Jacobian, a pass for every block of variables.
pub(crate) fn jacobian<E: Evaluate<D>, D: Pass>(
    f: &E,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    jet.reset(Order::Jacobian, x.len(), f.outputs());
    let mut block = [0; 8];
    for start in (0..x.len()).step_by(D::WIDTH) {
        let width = fill(&mut block, start..x.len().min(start + D::WIDTH), 0);
        pass::<E, D>(f, x, p, &block[..width], jet)?;
    }
    Ok(())
}

/// Ranges, Jacobian and Hessians, a pass for every pair of blocks.
fn hessians<E: Evaluate<D>, D: Pass>(f: &E, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
    let n = x.len();
    jet.reset(Order::Hessian, n, f.outputs());
    let mut block = [0; 8];
    if n <= D::WIDTH {
        let width = fill(&mut block, 0..n, 0);
        return pass::<E, D>(f, x, p, &block[..width], jet);
    }
    for pair in block_pairs(n, D::WIDTH) {
        let mut width = 0;
        for index in pair {
            block[width] = index;
            width += 1;
        }
        pass::<E, D>(f, x, p, &block[..width], jet)?;
    }
    Ok(())
}

/// All pairs of blocks of `width / 2` of more than `width / 2` variables, the indices of each pair in ascending order.
pub(super) fn block_pairs(n: usize, width: usize) -> impl Iterator<Item = impl Iterator<Item = usize>> {
    let half = width / 2;
    (0..n).step_by(half).flat_map(move |low| {
        (low + half..n).step_by(half).map(move |high| (low..low + half).chain(high..n.min(high + half)))
    })
}

/// Evaluates with derivatives by the variables of `block`, in ascending order, and stores all that is found.
pub(super) fn pass<E: Evaluate<D>, D: Pass>(
    f: &E,
    x: &[Interval],
    p: &[Interval],
    block: &[usize],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    let n = x.len();
    let mut scratch = std::mem::take(&mut jet.scratch);
    let buffer = D::buffer(&mut scratch);
    buffer.clear();
    buffer.extend(x.iter().map(|&x| D::seed(Decorated::variable(x), None)));
    for (position, &index) in block.iter().enumerate() {
        buffer[index] = D::seed(Decorated::variable(x[index]), Some(position));
    }
    buffer.extend(p.iter().map(|&p| D::seed(Decorated::constant(p), None)));
    buffer.resize(n + p.len() + f.outputs(), D::zero());
    let (x, rest) = buffer.split_at_mut(n);
    let (p, y) = rest.split_at_mut(p.len());
    let result = f.evaluate(x, p, y);
    if result.is_ok() {
        store(y, n, block, jet);
    }
    jet.scratch = scratch;
    result
}

/// Stores value, derivatives by the variables of `block` and smoothness of every output.
fn store<D: Pass>(outputs: &[D], n: usize, block: &[usize], jet: &mut Jet) {
    let entries = n * (n + 1) / 2;
    let (values, jacobian, hessians, smoothness) = jet.parts_mut();
    for (output, y) in outputs.iter().enumerate() {
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
        if hessians.is_empty() || !D::HAS_SECOND {
            continue;
        }
        let hessian = &mut hessians[output * entries..][..entries];
        for (i, &row) in block.iter().enumerate() {
            for (j, &column) in block.iter().enumerate().skip(i) {
                let known = value.smoothness() >= Smoothness::C2 || !(y.depends_on(i) && y.depends_on(j));
                hessian[packed(n, row, column)] = if known { y.second(i, j) } else { Interval::ENTIRE };
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
