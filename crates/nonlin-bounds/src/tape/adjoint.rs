//! Reverse mode: the Jacobian by one pass backwards for every output, whatever the number of variables.

use scalars::Interval;

use super::Tape;
use crate::derivative::{Decorated, Dual};
use crate::{BoundError, Jet, Operand, Order, Smoothness, Workspace};

/// Buffers of the passes.
#[derive(Debug, Default, Clone)]
pub(crate) struct Buffers {
    /// Ranges of all slots, and what is proven of them.
    values: Vec<Decorated>,
    /// Derivatives of each operation by its operands.
    partials: Vec<[Interval; 2]>,
    /// Derivative of the output at hand by each slot; none for a slot that it does not depend on.
    adjoints: Vec<Option<Interval>>,
}

impl Tape {
    /// Value, Jacobian and smoothness over a box, as [`DynFunction::enclose`](crate::DynFunction::enclose) with [`Order::Jacobian`], by
    /// reverse mode: the cost of an evaluation for every output instead of one for every eight variables.
    ///
    /// **Guarantee:** every entry contains the exact quantity at every point of the box at which it exists; derivatives of an output that
    /// is not proven to be `C1` are the whole line. Entries may be wider or narrower than those of the forward mode: intersect
    /// both where width matters more than time.
    ///
    /// **Source:** Griewank, Walther, *Evaluating Derivatives*, SIAM 2008, section 3.2.
    ///
    /// # Errors
    /// As [`DynFunction::enclose`](crate::DynFunction::enclose).
    pub fn enclose_backward(
        &self,
        x: &[Interval],
        p: &[Interval],
        jet: &mut Jet,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        BoundError::check_box(Operand::Variables, self.variables, x)?;
        BoundError::check_box(Operand::Parameters, self.parameters, p)?;
        jet.reset(Order::Jacobian, self.variables, self.outputs.len());
        let Buffers { values, partials, adjoints } = &mut workspace.adjoint;
        let sides = x.iter().map(|&x| Decorated::variable(x));
        self.run(sides.chain(p.iter().map(|&p| Decorated::constant(p))), values);
        partials.clear();
        partials.extend(self.nodes.iter().map(|node| {
            let (a, b) = node.operands();
            let seed = |slot: u32, index| Dual::<Interval, 2>::variable(values[slot as usize].range(), index);
            let operands = [seed(a, 0), seed(b.unwrap_or(a), 1)];
            *node.with_operands(0, 1).apply(&operands).gradient()
        }));
        let (ranges, jacobian, _, smoothness) = jet.parts_mut();
        for (i, &output) in self.outputs.iter().enumerate() {
            let value = values[output as usize];
            (ranges[i], smoothness[i]) = (value.range(), value.smoothness());
            self.pass(output, partials, adjoints);
            let smooth = value.smoothness() >= Smoothness::C1;
            let row = &mut jacobian[i * self.variables..][..self.variables];
            for (entry, adjoint) in row.iter_mut().zip(&*adjoints) {
                *entry = match adjoint {
                    None => Interval::ZERO,
                    Some(derivative) if smooth => *derivative,
                    Some(_) => Interval::ENTIRE,
                };
            }
        }
        Ok(())
    }

    /// Derivatives of one slot by all slots before it.
    fn pass(&self, output: u32, partials: &[[Interval; 2]], adjoints: &mut Vec<Option<Interval>>) {
        let first = self.first_node();
        adjoints.clear();
        adjoints.resize(self.slots(), None);
        adjoints[output as usize] = Some(Interval::ONE);
        // Operations behind the output do not reach it.
        let end = (output as usize + 1).saturating_sub(first);
        for (k, (node, partials)) in self.nodes.iter().zip(partials).enumerate().take(end).rev() {
            let Some(adjoint) = adjoints[first + k] else { continue };
            let (a, b) = node.operands();
            for (operand, &partial) in [Some(a), b].into_iter().zip(partials) {
                let Some(operand) = operand else { continue };
                // The derivative of the output by itself is exactly one.
                let term = if adjoint == Interval::ONE { partial } else { adjoint * partial };
                let sum = &mut adjoints[operand as usize];
                *sum = Some(sum.map_or(term, |sum| sum + term));
            }
        }
    }
}
