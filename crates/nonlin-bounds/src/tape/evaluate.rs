//! Evaluation of a tape over any scalar.

use scalars::Scalar;

use super::Tape;
use super::node::{Node, Unary};
use super::pool::with_buffer;
use crate::{BoundError, Function, Operand};

impl Tape {
    /// `y = f(x, p)` over any scalar, with a buffer of the caller's, which then holds every intermediate value.
    ///
    /// **Guarantee:** over intervals, `y` encloses the range of `f`. Allocates nothing once the buffer has room for
    /// [`slots`](Self::slots) values.
    ///
    /// # Errors
    /// [`BoundError::Dimension`].
    pub fn eval_with<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S], buffer: &mut Vec<S>) -> Result<(), BoundError> {
        self.check(x.len(), p.len())?;
        BoundError::check_size(Operand::Outputs, self.outputs.len(), y.len())?;
        self.run(x.iter().chain(p).copied(), buffer);
        self.read_outputs(buffer, y);
        Ok(())
    }

    /// Errors of variables and parameters of the wrong number.
    pub(crate) fn check(&self, x: usize, p: usize) -> Result<(), BoundError> {
        BoundError::check_size(Operand::Variables, self.variables, x)?;
        BoundError::check_size(Operand::Parameters, self.parameters, p)
    }

    /// Fills the buffer with the values of all slots, from those of the variables and the parameters.
    pub(super) fn run<S: Scalar>(&self, leaves: impl Iterator<Item = S>, buffer: &mut Vec<S>) {
        buffer.clear();
        buffer.reserve(self.slots());
        buffer.extend(leaves);
        buffer.extend(self.constants.iter().map(|c| S::lit(c.lo(), c.hi())));
        let mut rest = self.nodes.iter();
        while let Some(&node) = rest.next() {
            if let Some(operand) = sine_with_cosine(node, rest.as_slice().first()) {
                let (sin, cos) = buffer[operand as usize].sin_cos();
                buffer.push(sin);
                buffer.push(cos);
                rest.next();
            } else {
                let value = node.apply(buffer);
                buffer.push(value);
            }
        }
    }

    fn read_outputs<S: Scalar>(&self, buffer: &[S], y: &mut [S]) {
        for (value, &slot) in y.iter_mut().zip(&self.outputs) {
            *value = buffer[slot as usize];
        }
    }
}

/// The common operand, if a node is a sine and the next one the cosine of the same.
#[inline]
pub(crate) fn sine_with_cosine(node: Node, next: Option<&Node>) -> Option<u32> {
    match node {
        Node::Unary(Unary::Sin, a) if next == Some(&Node::Unary(Unary::Cos, a)) => Some(a),
        _ => None,
    }
}

impl Function for Tape {
    fn variables(&self) -> usize {
        self.variables
    }
    fn parameters(&self) -> usize {
        self.parameters
    }
    fn outputs(&self) -> usize {
        self.outputs.len()
    }
    /// Replays the tape, with a buffer that is kept for the next call on the same thread.
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        with_buffer(|buffer| {
            self.run(x[..self.variables].iter().chain(&p[..self.parameters]).copied(), buffer);
            self.read_outputs(buffer, y);
        });
    }
}
