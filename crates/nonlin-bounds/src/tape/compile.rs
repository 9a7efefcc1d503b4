//! From a recording to a tape: what no output needs is left out, and slots are given in order.

use scalars::Interval;

use super::Tape;
use super::node::{Node, Unary};
use super::recorder::{Entry, Recorder};

/// Slot of a value that has none yet.
const NONE: u32 = u32::MAX;

/// The tape of `n` variables and `q` parameters whose outputs are at the given positions of the recording.
pub(super) fn tape(recorder: &Recorder, outputs: &[u32], n: usize, q: usize) -> Tape {
    let entries = recorder.entries();
    let needed_by = first_users(entries, outputs);
    let needed = |position: usize| needed_by[position] != NONE;
    let mut slots = vec![NONE; entries.len()];
    let mut constants = Vec::new();
    for (position, entry) in entries.iter().enumerate() {
        match *entry {
            Entry::Variable(k) => slots[position] = k,
            Entry::Parameter(k) => slots[position] = n as u32 + k,
            Entry::Constant(lo, hi) if needed(position) => {
                slots[position] = (n + q + constants.len()) as u32;
                constants.push(Interval::new(lo.get(), hi.get()).unwrap_or(Interval::EMPTY));
            }
            _ => {}
        }
    }
    let mut tape =
        Tape { variables: n, parameters: q, constants, nodes: Vec::new(), outputs: Vec::new(), needed_by: Vec::new() };
    let partners = partners(entries, &needed);
    for (position, entry) in entries.iter().enumerate() {
        let Entry::Node(node) = *entry else { continue };
        if !needed(position) || slots[position] != NONE {
            continue;
        }
        // A sine and the cosine of the same operand stand side by side, the sine first: they are computed together.
        let pair = match (node, partners[position]) {
            (Node::Unary(Unary::Cos, _), Some(sine)) => [Some(sine), Some(position)],
            (_, partner) => [Some(position), partner],
        };
        for position in pair.into_iter().flatten() {
            let Entry::Node(node) = entries[position] else { continue };
            slots[position] = (tape.first_node() + tape.nodes.len()) as u32;
            let (a, b) = node.operands();
            tape.nodes.push(node.with_operands(slots[a as usize], slots[b.unwrap_or(a) as usize]));
            tape.needed_by.push(needed_by[position]);
        }
    }
    tape.outputs = outputs.iter().map(|&position| slots[position as usize]).collect();
    tape
}

/// For each value the first output that needs it, or none.
fn first_users(entries: &[Entry], outputs: &[u32]) -> Vec<u32> {
    let mut users = vec![NONE; entries.len()];
    for (k, &position) in outputs.iter().enumerate() {
        let user = &mut users[position as usize];
        *user = (*user).min(k as u32);
    }
    for position in (0..entries.len()).rev() {
        let Entry::Node(node) = entries[position] else { continue };
        let (a, b) = node.operands();
        for operand in [Some(a), b].into_iter().flatten() {
            users[operand as usize] = users[operand as usize].min(users[position]);
        }
    }
    users
}

/// For each needed sine the position of the needed cosine of the same operand, and the other way round.
fn partners(entries: &[Entry], needed: &impl Fn(usize) -> bool) -> Vec<Option<usize>> {
    let mut partners = vec![None; entries.len()];
    // Last sine and cosine seen of each operand; each operation is recorded once, so there is at most one of either.
    let mut sines = vec![None; entries.len()];
    let mut cosines = vec![None; entries.len()];
    for (position, entry) in entries.iter().enumerate().filter(|(position, _)| needed(*position)) {
        match *entry {
            Entry::Node(Node::Unary(Unary::Sin, a)) => sines[a as usize] = Some(position),
            Entry::Node(Node::Unary(Unary::Cos, a)) => cosines[a as usize] = Some(position),
            _ => {}
        }
    }
    for (sine, cosine) in sines.iter().zip(&cosines) {
        if let (&Some(sine), &Some(cosine)) = (sine, cosine) {
            partners[sine] = Some(cosine);
            partners[cosine] = Some(sine);
        }
    }
    partners
}
