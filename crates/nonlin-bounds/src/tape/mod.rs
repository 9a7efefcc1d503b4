//! [`Tape`]: a function as data, recorded by running it once on symbols.
//!
//! Reading order: `node` (one operation), `recorder` (each operation once, in a simple form), `symbol` (the scalar that records),
//! `compile` (dead code out, slots in order), `evaluate` (over any scalar), `adjoint` (reverse mode), `curvature` (which
//! second derivatives are zero), `display` (formulas).

mod adjoint;
mod compile;
mod curvature;
mod display;
mod evaluate;
pub(crate) mod node;
mod pool;
mod recorder;
mod symbol;

use scalars::{Interval, Scalar};

use crate::Function;
pub(crate) use adjoint::Buffers as AdjointBuffers;
pub(crate) use curvature::Curvature;
pub(crate) use evaluate::sine_with_cosine;
use node::Node;
use symbol::{Recording, Symbol};

/// A recorded function: a flat list of operations, each sub-expression once.
///
/// A slot is a value: the variables come first, then the parameters, the constants, and one slot for each operation, whose operands lie
/// before it. A tape is itself a [`Function`], so every enclosure takes it in place of what was recorded; besides, it can be run
/// backwards, for contraction ([`ForwardBackward`](crate::ForwardBackward)) and for gradients
/// ([`enclose_backward`](Self::enclose_backward)), and printed.
///
/// Constants are kept as intervals that contain the numbers meant (`S::decimal("0.1")`, `S::ratio(1, 7)`, `S::pi()`).
///
/// **Guarantee:** over intervals the values are those of the recorded function or tighter; the points where an output is defined are the
/// same. Over `f64` a value may differ by rounding where a constant was folded. Operations that no output needs are left out, so they
/// restrict no domain.
///
/// ```
/// use nonlin_bounds::{Function, Tape};
/// use scalars::Scalar;
///
/// struct Ring;
/// impl Function for Ring {
///     const VARIABLES: Option<usize> = Some(2);
///     fn outputs(&self) -> usize { 2 }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
///         let radius = (x[0] * x[0] + x[1] * x[1]).sqrt();
///         y[0] = radius - S::decimal("0.1");
///         y[1] = x[0] / radius;
///     }
/// }
///
/// let tape = Tape::record(&Ring);
/// assert_eq!(tape.to_string(), "t0 = sqrt(x[0]^2 + x[1]^2)\ny[0] = t0 - 0.1\ny[1] = x[0] / t0\n");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Tape {
    variables: usize,
    parameters: usize,
    constants: Vec<Interval>,
    nodes: Vec<Node>,
    /// Slot of each output.
    outputs: Vec<u32>,
    /// For each operation the first output that needs it.
    needed_by: Vec<u32>,
}

impl Tape {
    /// Records a function by evaluating it once.
    ///
    /// Outputs that the function does not write are zero. A panic in the function passes through and leaves no trace; a function may
    /// record others while it is recorded.
    #[must_use]
    pub fn record<F: Function>(function: &F) -> Self {
        let recording = Recording::start();
        let (n, q, m) = (function.variables(), function.parameters(), function.outputs());
        let x: Vec<Symbol> = (0..n).map(|k| recording.variable(k)).collect();
        let p: Vec<Symbol> = (0..q).map(|k| recording.parameter(k)).collect();
        let mut y = vec![Symbol::from_f64(0.0); m];
        function.eval(&x, &p, &mut y);
        let (recorder, outputs) = recording.finish(&y);
        compile::tape(&recorder, &outputs, n, q)
    }

    /// Number of operations.
    #[must_use]
    pub fn operations(&self) -> usize {
        self.nodes.len()
    }

    /// Number of slots, the length of the buffer of an evaluation: variables, parameters, constants and operations.
    #[must_use]
    pub fn slots(&self) -> usize {
        self.first_node() + self.nodes.len()
    }

    /// Which second derivatives are zero.
    pub(crate) fn curvature(&self) -> Curvature {
        Curvature::of(self)
    }

    /// Slot of the first operation.
    pub(crate) fn first_node(&self) -> usize {
        self.variables + self.parameters + self.constants.len()
    }

    pub(crate) fn constants(&self) -> &[Interval] {
        &self.constants
    }

    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    pub(crate) fn output_slots(&self) -> &[u32] {
        &self.outputs
    }

    pub(crate) fn needed_by(&self) -> &[u32] {
        &self.needed_by
    }
}
