//! Which variables meet in second derivatives, read off a tape.

use super::Tape;
use super::node::{Binary, Node, Unary};

/// Groups of variables outside of which no second derivative of any output can be other than zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Curvature {
    /// Variables with second derivatives; those of different groups have none by both. Each group in ascending order.
    pub(crate) curved: Vec<Vec<usize>>,
    /// Variables in which every output is affine, with factors that depend on no variable.
    pub(crate) straight: Vec<usize>,
}

impl Curvature {
    /// Of all outputs of a tape together.
    ///
    /// **Guarantee:** for variables of different groups, or a straight one and any other, the second derivative of every output is zero at
    /// every point at which it exists.
    pub(crate) fn of(tape: &Tape) -> Self {
        let n = tape.variables;
        let mut groups = Groups { parent: (0..n).collect(), curved: vec![false; n] };
        // The variables that each slot depends on.
        let mut depends: Vec<Vec<usize>> =
            (0..tape.first_node()).map(|slot| (0..n).filter(|&k| k == slot).collect()).collect();
        for &node in &tape.nodes {
            let (a, b) = node.operands();
            let first = &depends[a as usize];
            let second = b.map_or(&[][..], |b| &depends[b as usize]);
            match node {
                Node::Scale(..) | Node::Shift(..) | Node::Unary(Unary::Neg, _) => {}
                Node::Binary(Binary::Add | Binary::Sub, ..) => {}
                // A factor without variables bends nothing.
                Node::Binary(Binary::Mul, ..) if first.is_empty() || second.is_empty() => {}
                Node::Binary(Binary::Div, ..) if second.is_empty() => {}
                _ => groups.join(first.iter().chain(second)),
            }
            let mut both: Vec<usize> = first.iter().chain(second).copied().collect();
            both.sort_unstable();
            both.dedup();
            depends.push(both);
        }
        groups.sort()
    }
}

/// A forest over the variables: those of one tree meet.
struct Groups {
    parent: Vec<usize>,
    curved: Vec<bool>,
}

impl Groups {
    fn root(&self, mut k: usize) -> usize {
        while self.parent[k] != k {
            k = self.parent[k];
        }
        k
    }

    /// Puts variables into one group.
    fn join<'a>(&mut self, variables: impl Iterator<Item = &'a usize>) {
        let mut root = None;
        for &k in variables {
            self.curved[k] = true;
            let own = self.root(k);
            let first = *root.get_or_insert(own);
            self.parent[own] = first;
        }
    }

    fn sort(&self) -> Curvature {
        let n = self.parent.len();
        let members = |root: usize| (0..n).filter(|&k| self.curved[k] && self.root(k) == root).collect::<Vec<_>>();
        let roots = (0..n).filter(|&k| self.curved[k] && self.parent[k] == k);
        Curvature { curved: roots.map(members).collect(), straight: (0..n).filter(|&k| !self.curved[k]).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::function;

    fn of<F: crate::Function>(function: &F) -> (Vec<Vec<usize>>, Vec<usize>) {
        let Curvature { curved, straight } = Curvature::of(&Tape::record(function));
        (curved, straight)
    }

    #[test]
    fn variables_that_meet_are_grouped() {
        let f = function!(|[a, b, c, d, e]: 5| -> 2 { [a * b + c.sin() + d.scale(2.0), a - e + d / S::ratio(1, 3)] });
        assert_eq!(of(&f), (vec![vec![0, 1], vec![2]], vec![3, 4]));
        // By way of a third one, over two outputs.
        let f = function!(|[a, b, c]: 3| -> 2 { [a * c, (b + c).exp()] });
        assert_eq!(of(&f), (vec![vec![0, 1, 2]], vec![]));
        // A quotient bends its denominator; a constant and a parameter are no variables.
        let f = function!(|[a, b]: 2, [p]: 1| -> 2 { [p * a + p.sin(), S::one() / b] });
        assert_eq!(of(&f), (vec![vec![1]], vec![0]));
        // What is not differentiable everywhere counts as curved.
        let f = function!(|[a, b, c]: 3| -> 1 { [a.abs() + b.min(c)] });
        assert_eq!(of(&f), (vec![vec![0], vec![1, 2]], vec![]));
    }
}
