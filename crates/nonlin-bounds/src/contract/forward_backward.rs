//! [`ForwardBackward`]: constraint propagation over a tape.

use scalars::Interval;

use super::{Conflict, Contraction, check_box, gain, reverse, reverse_functions};
use crate::tape::node::Node;
use crate::tape::{Tape, sine_with_cosine};
use crate::{BoundError, Function, Operand, Workspace};

/// The forward-backward contractor HC4-revise, on the graph of all outputs at once.
///
/// A sweep evaluates the tape forwards, intersects the outputs with their required ranges, and goes backwards: every operation whose
/// range got smaller takes from its operands what fits no result. Sub-expressions that outputs share pass narrowed ranges from one to
/// the other within the sweep. Later sweeps only touch what has changed.
///
/// **Solutions** are the `x` of the box for which some `p` in the parameters' box makes every `f_i(x, p)` defined and a member of
/// `y_i`; the outputs share one `p`. A required range may be unbounded on one side or on both, and so may the box.
///
/// **Guarantee:** no solution is lost, rounding included. Without repeated variables in one constraint the result of one sweep is the
/// hull of that constraint's solutions up to rounding; otherwise it is a superset of the hull.
///
/// **Source:** Benhamou, Goualard, Granvilliers, Puget, *Revising hull and box consistency*, ICLP 1999; Schichl, Neumaier, *Interval
/// analysis on directed acyclic graphs for global optimization*, J. Global Optimization 33, 2005.
///
/// ```
/// use nonlin_bounds::{Contraction, ForwardBackward, Function, Tape, Workspace};
/// use scalars::{Interval, Scalar};
///
/// struct Norm;
/// impl Function for Norm {
///     const VARIABLES: Option<usize> = Some(2);
///     fn outputs(&self) -> usize { 1 }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
///         y[0] = x[0].sqr() + x[1].sqr();
///     }
/// }
///
/// let tape = Tape::record(&Norm);
/// let mut x = [Interval::new(0.5, 4.0)?, Interval::new(-3.0, 3.0)?];
/// let outcome = ForwardBackward::default().contract(&tape, &mut x, &[], &[Interval::ONE], &mut Workspace::new())?;
/// assert!(!outcome.is_empty());
/// assert!(x[0].contains(1.0) && x[0].hi() < 1.0 + 1e-15 && x[1].mag() < 0.8661);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForwardBackward {
    /// Most sweeps.
    pub sweeps: usize,
    /// Stop after a sweep in which no side of the box lost more than this share of its width.
    pub least_gain: f64,
}

impl Default for ForwardBackward {
    /// Ten sweeps, 2 %.
    fn default() -> Self {
        Self { sweeps: 10, least_gain: 0.02 }
    }
}

impl ForwardBackward {
    /// Shrinks the box `x` around the solutions of `f(x, p) in y`.
    ///
    /// After [`Contraction::ProvenEmpty`] and after an error the box is as it was. Allocates nothing once the workspace has grown.
    ///
    /// # Errors
    /// [`BoundError::Dimension`]; [`BoundError::EmptyInterval`] for an empty side of the box, a parameter or a required range (also
    /// where a bound was NaN).
    pub fn contract(
        &self,
        tape: &Tape,
        x: &mut [Interval],
        p: &[Interval],
        y: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<Contraction, BoundError> {
        self.run(tape, x, p, y, false, workspace)
    }

    /// As [`contract`](Self::contract), but nothing is asked of an output whose required range is the whole line: it need not be defined at the points
    /// that are kept, as the formula of a missing measurement need not be at the state.
    ///
    /// # Errors
    /// As [`contract`](Self::contract).
    pub fn contract_stated(
        &self,
        tape: &Tape,
        x: &mut [Interval],
        p: &[Interval],
        y: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<Contraction, BoundError> {
        self.run(tape, x, p, y, true, workspace)
    }

    fn run(
        &self,
        tape: &Tape,
        x: &mut [Interval],
        p: &[Interval],
        y: &[Interval],
        only_stated: bool,
        workspace: &mut Workspace,
    ) -> Result<Contraction, BoundError> {
        check_box(Operand::Variables, tape.variables(), x)?;
        check_box(Operand::Parameters, tape.parameters(), p)?;
        check_box(Operand::Outputs, tape.outputs(), y)?;
        let slots = &mut workspace.contract.slots;
        slots.start(tape, x, p);
        slots.find_needed(tape, y, only_stated);
        let mut sweeps = 0;
        while sweeps < self.sweeps {
            sweeps += 1;
            if let Err(Emptied(output)) = slots.sweep(tape, y) {
                return Ok(Contraction::ProvenEmpty(Conflict::Output { output: output as usize, sweep: sweeps }));
            }
            let gained = slots.gain(x.len());
            if gained == 0.0 || gained < self.least_gain {
                break;
            }
        }
        x.copy_from_slice(&slots.values[..x.len()]);
        Ok(Contraction::Undecided { sweeps })
    }
}

/// The output whose required range left nothing.
struct Emptied(u32);

/// What is known of the history of a slot.
#[derive(Debug, Clone, Copy, Default)]
struct Mark {
    /// The output that narrowed it last.
    cause: u32,
    /// Pass (forward or backward) of the last change.
    changed: u32,
    /// Its operation is to be run backwards: the range is smaller than the image of the operands, or the operands leave the domain.
    pending: bool,
}

/// The ranges of all slots.
#[derive(Debug, Default, Clone)]
pub(super) struct Slots {
    values: Vec<Interval>,
    marks: Vec<Mark>,
    /// Whether a slot is an operand of an output that is asked for.
    needed: Vec<bool>,
    /// The variables before the sweep.
    before: Vec<Interval>,
    /// Number of the pass, from 1.
    pass: u32,
}

impl Slots {
    fn start(&mut self, tape: &Tape, x: &[Interval], p: &[Interval]) {
        self.values.clear();
        self.values.reserve(tape.slots());
        for part in [x, p, tape.constants()] {
            self.values.extend_from_slice(part);
        }
        self.marks.clear();
        self.marks.resize(tape.slots(), Mark::default());
        self.before.clear();
        self.before.extend_from_slice(x);
        self.pass = 0;
    }

    /// Marks what the outputs that are asked for are made of: all, or those that state something.
    fn find_needed(&mut self, tape: &Tape, y: &[Interval], only_stated: bool) {
        let asked = |required: &Interval| !only_stated || *required != Interval::ENTIRE;
        self.needed.clear();
        self.needed.resize(tape.slots(), y.iter().all(asked));
        for (&slot, _) in tape.output_slots().iter().zip(y).filter(|(_, required)| asked(required)) {
            self.needed[slot as usize] = true;
        }
        for (k, node) in tape.nodes().iter().enumerate().rev() {
            if self.needed[tape.first_node() + k] {
                let (a, b) = node.operands();
                self.needed[a as usize] = true;
                self.needed[b.unwrap_or(a) as usize] = true;
            }
        }
    }

    /// The largest gain of the first `n` slots since the last call.
    fn gain(&mut self, n: usize) -> f64 {
        let mut largest = 0.0_f64;
        for (before, &after) in self.before.iter_mut().zip(&self.values[..n]) {
            largest = largest.max(gain(*before, after));
            *before = after;
        }
        largest
    }

    fn sweep(&mut self, tape: &Tape, y: &[Interval]) -> Result<(), Emptied> {
        self.pass += 1;
        if self.pass == 1 {
            self.first_forward(tape)?;
        } else {
            self.forward(tape)?;
        }
        self.pass += 1;
        for (output, (&slot, &required)) in tape.output_slots().iter().zip(y).enumerate() {
            if !self.needed[slot as usize] {
                continue;
            }
            self.narrow(slot, self.values[slot as usize].intersection(required), output as u32)?;
        }
        self.backward(tape)
    }

    /// Images of all operations.
    fn first_forward(&mut self, tape: &Tape) -> Result<(), Emptied> {
        let nodes = tape.nodes();
        let first = tape.first_node();
        let mut k = 0;
        while k < nodes.len() {
            if let Some(operand) = sine_with_cosine(nodes[k], nodes.get(k + 1)) {
                let (sin, cos) = self.values[operand as usize].sin_cos();
                self.values.push(sin);
                self.values.push(cos);
                k += 2;
                continue;
            }
            if !self.needed[first + k] {
                self.values.push(Interval::ENTIRE);
                k += 1;
                continue;
            }
            let (node, needed_by) = (nodes[k], tape.needed_by()[k]);
            let image = node.apply(&self.values);
            if image.is_empty() {
                return Err(Emptied(needed_by));
            }
            if node.leaves_domain(self.values[node.operands().0 as usize]) {
                self.marks[first + k] = Mark { cause: needed_by, changed: 0, pending: true };
            }
            self.values.push(image);
            k += 1;
        }
        Ok(())
    }

    /// Images of the operations whose operands have changed since the last forward pass.
    fn forward(&mut self, tape: &Tape) -> Result<(), Emptied> {
        let first = tape.first_node();
        for (k, &node) in tape.nodes().iter().enumerate().filter(|(k, _)| self.needed[first + k]) {
            let (a, b) = node.operands();
            let changed = |slot: u32| self.marks[slot as usize].changed + 1 >= self.pass;
            let operand = match b {
                _ if changed(a) => a,
                Some(b) if changed(b) => b,
                _ => continue,
            };
            let slot = first + k;
            let cause = self.marks[operand as usize].cause;
            let (image, before) = (node.apply(&self.values), self.values[slot]);
            let after = image.intersection(before);
            if after.is_empty() {
                return Err(Emptied(cause));
            }
            let mark = &mut self.marks[slot];
            if after != before {
                self.values[slot] = after;
                // An older narrowing that still shows keeps its name.
                if after == image || mark.changed == 0 {
                    mark.cause = cause;
                }
                mark.changed = self.pass;
            }
            mark.pending |= after != image || node.leaves_domain(self.values[a as usize]);
        }
        Ok(())
    }

    /// Runs the pending operations backwards.
    fn backward(&mut self, tape: &Tape) -> Result<(), Emptied> {
        let first = tape.first_node();
        for (k, &node) in tape.nodes().iter().enumerate().rev() {
            let mark = &mut self.marks[first + k];
            if !mark.pending {
                continue;
            }
            mark.pending = false;
            let cause = mark.cause;
            let z = self.values[first + k];
            let at = |slot: u32| self.values[slot as usize];
            match node {
                Node::Binary(operation, a, b) => {
                    self.narrow(a, reverse::first(operation, z, at(a), at(b)), cause)?;
                    let at = |slot: u32| self.values[slot as usize];
                    self.narrow(b, reverse::second(operation, z, at(a), at(b)), cause)?;
                }
                Node::Unary(operation, a) => self.narrow(a, reverse::unary(operation, z, at(a)), cause)?,
                Node::Scale(a, k) => self.narrow(a, reverse::scale(k.get(), z, at(a)), cause)?,
                Node::Shift(a, k) => self.narrow(a, reverse::shift(k.get(), z, at(a)), cause)?,
                Node::Power(a, n) => self.narrow(a, reverse::power(n, z, at(a)), cause)?,
                Node::Stumpff(a, k) => self.narrow(a, reverse_functions::stumpff(k as usize, z, at(a)), cause)?,
            }
        }
        Ok(())
    }

    /// Replaces a range by a subset of it.
    #[inline]
    fn narrow(&mut self, slot: u32, subset: Interval, cause: u32) -> Result<(), Emptied> {
        let slot = slot as usize;
        if subset.is_empty() {
            return Err(Emptied(cause));
        }
        if subset != self.values[slot] {
            self.values[slot] = subset;
            self.marks[slot] = Mark { cause, changed: self.pass, pending: true };
        }
        Ok(())
    }
}
