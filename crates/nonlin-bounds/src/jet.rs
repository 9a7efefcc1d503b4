//! [`Jet`]: value, Jacobian and Hessians of a function over a box.

use scalars::Interval;

use crate::derivative::Scratch;
use crate::{Order, Smoothness};

/// Enclosures of the value, the Jacobian and the Hessians of a function `R^n -> R^m`, reused from call to call.
///
/// Row `i` of the Jacobian is the gradient of output `i`. A Hessian is packed by rows of its upper triangle:
/// `(0,0), (0,1), .., (0,n-1), (1,1), ..`, `n (n + 1) / 2` entries an output, plain second derivatives (no factor 1/2).
#[derive(Debug, Default)]
pub struct Jet {
    variables: usize,
    values: Vec<Interval>,
    jacobian: Vec<Interval>,
    hessians: Vec<Interval>,
    smoothness: Vec<Smoothness>,
    /// Buffers of the evaluation, so that it allocates nothing in steady state.
    pub(crate) scratch: Scratch,
}

impl Clone for Jet {
    /// The results; buffers start anew.
    fn clone(&self) -> Self {
        Self {
            variables: self.variables,
            values: self.values.clone(),
            jacobian: self.jacobian.clone(),
            hessians: self.hessians.clone(),
            smoothness: self.smoothness.clone(),
            scratch: Scratch::default(),
        }
    }
}

impl PartialEq for Jet {
    /// Equality of the results.
    fn eq(&self, other: &Self) -> bool {
        self.variables == other.variables
            && self.values == other.values
            && self.jacobian == other.jacobian
            && self.hessians == other.hessians
            && self.smoothness == other.smoothness
    }
}

impl Jet {
    /// An empty jet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes room for `outputs` functions of `variables` variables up to `order`; every value and derivative is the whole line, nothing is
    /// proven. Allocates nothing within the capacity.
    pub fn reset(&mut self, order: Order, variables: usize, outputs: usize) {
        self.variables = variables;
        let gradient = if order >= Order::Jacobian { variables } else { 0 };
        let hessian = if order >= Order::Hessian { variables * (variables + 1) / 2 } else { 0 };
        for (buffer, size) in [(&mut self.values, 1), (&mut self.jacobian, gradient), (&mut self.hessians, hessian)] {
            buffer.clear();
            buffer.resize(outputs * size, Interval::ENTIRE);
        }
        self.smoothness.clear();
        self.smoothness.resize(outputs, Smoothness::Undefined);
    }

    /// Number `n` of variables.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Number `m` of outputs.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.values.len()
    }

    /// The range of every output.
    #[must_use]
    pub fn values(&self) -> &[Interval] {
        &self.values
    }

    /// The Jacobian, row by row; empty if it was not asked for.
    #[must_use]
    pub fn jacobian(&self) -> &[Interval] {
        &self.jacobian
    }

    /// The packed Hessians, one output after the other; empty if they were not asked for.
    #[must_use]
    pub fn hessians(&self) -> &[Interval] {
        &self.hessians
    }

    /// What is proven of every output on the box.
    #[must_use]
    pub fn smoothness(&self) -> &[Smoothness] {
        &self.smoothness
    }

    /// All parts, to write to: values, Jacobian, Hessians, smoothness.
    pub fn parts_mut(&mut self) -> (&mut [Interval], &mut [Interval], &mut [Interval], &mut [Smoothness]) {
        (&mut self.values, &mut self.jacobian, &mut self.hessians, &mut self.smoothness)
    }
}
