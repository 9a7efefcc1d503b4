//! Contractors: boxes without points that can not solve `f(x, p) in Y`.
//!
//! [`ForwardBackward`] runs a [`Tape`](crate::Tape) forwards and backwards: cheap, good on wide boxes, needs no smoothness.
//! [`IntervalNewton`] takes the Jacobian of any [`DynFunction`](crate::DynFunction): strong on small boxes, and it can prove that there
//! is exactly one solution. Both never lose a solution.
//!
//! Reading order: `forward_backward`, `reverse` (one operation backwards), `reverse_functions`; `newton`, `linear`.

mod forward_backward;
mod linear;
mod newton;
mod reverse;
mod reverse_functions;

pub use forward_backward::ForwardBackward;
pub use newton::IntervalNewton;

use scalars::Interval;

use crate::{BoundError, Operand};

/// What a contractor has found out. Only [`ProvenEmpty`](Self::ProvenEmpty) leaves the box as it was.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[must_use]
pub enum Contraction {
    /// The box now contains every solution that it contained before; whether there is one is not known.
    Undecided {
        /// Sweeps done.
        sweeps: usize,
    },
    /// As before, and for every parameter vector in `p` and every value in `y` the box contains exactly one solution.
    ProvenUnique {
        /// Sweeps done.
        sweeps: usize,
    },
    /// The box contains no solution.
    ProvenEmpty(Conflict),
}

impl Contraction {
    /// True if the box is proven to contain no solution.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        matches!(self, Self::ProvenEmpty(_))
    }
}

/// What contradicted a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Conflict {
    /// The range required of this output left nothing; constraints revised before it may have had a part.
    Output {
        /// Index of the output.
        output: usize,
        /// Sweep, from 1.
        sweep: usize,
    },
    /// The preconditioned linear system, in which all outputs have a part, left no value for this variable.
    Variable {
        /// Index of the variable.
        variable: usize,
        /// Sweep, from 1.
        sweep: usize,
    },
}

/// Buffers of the contractors.
#[derive(Debug, Default, Clone)]
pub(crate) struct Scratch {
    slots: forward_backward::Slots,
    newton: newton::Buffers,
}

/// Errors of a box of the wrong length or with an empty side.
fn check_box(operand: Operand, expected: usize, sides: &[Interval]) -> Result<(), BoundError> {
    BoundError::check_size(operand, expected, sides.len())?;
    match sides.iter().position(Interval::is_empty) {
        Some(index) => Err(BoundError::EmptyInterval { operand, index }),
        None => Ok(()),
    }
}

/// The largest share of its width that a side has lost; 1 where an unbounded side has changed.
fn gain(before: Interval, after: Interval) -> f64 {
    if before == after {
        return 0.0;
    }
    let (before, after) = (before.hi() - before.lo(), after.hi() - after.lo());
    if before < f64::INFINITY { 1.0 - after / before } else { 1.0 }
}
