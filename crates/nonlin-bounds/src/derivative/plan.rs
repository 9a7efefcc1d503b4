//! [`Plan`]: which passes the Hessians of a function with a known structure need.

use scalars::Interval;

use super::blocks::{block_pairs, pass};
use super::{Decorated, Dual, Second};
use crate::tape::Curvature;
use crate::{BoundError, Function, Jet, Operand, Order};

/// Most variables of a pass.
const WIDTH: usize = 8;

/// Blocks of variables, each for one pass. Every variable is in a block, every two with a common second derivative are in one together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Plan {
    /// Passes with second derivatives.
    curved: Vec<Vec<usize>>,
    /// Passes with first derivatives only.
    straight: Vec<Vec<usize>>,
}

impl Plan {
    /// The plan for a structure, unless it costs as much as that for any function.
    pub(crate) fn of(structure: &Curvature) -> Option<Self> {
        let variables = structure.straight.len() + structure.curved.iter().map(Vec::len).sum::<usize>();
        let mut curved: Vec<Vec<usize>> = Vec::new();
        let mut groups: Vec<&Vec<usize>> = structure.curved.iter().collect();
        groups.sort_by_key(|group| std::cmp::Reverse(group.len()));
        for group in groups {
            if group.len() > WIDTH {
                curved.extend(block_pairs(group.len(), WIDTH).map(|block| block.map(|k| group[k]).collect()));
                continue;
            }
            // The first block with room for all of it.
            match curved.iter_mut().find(|block| block.len() + group.len() <= WIDTH) {
                Some(block) => block.extend(group),
                None => curved.push(group.clone()),
            }
        }
        curved.iter_mut().for_each(|block| block.sort_unstable());
        let straight = structure.straight.chunks(WIDTH).map(<[usize]>::to_vec).collect();
        let plan = Self { curved, straight };
        (variables > 0 && plan.cost() < dense_cost(variables)).then_some(plan)
    }

    /// About how long the passes take, in evaluations of the function.
    fn cost(&self) -> f64 {
        let second = self.curved.iter().map(|block| second_cost(block.len()));
        let first = self.straight.iter().map(|block| 1.0 + 0.25 * width(block.len()) as f64);
        second.chain(first).sum()
    }
}

/// The number of variables that the type of a pass for so many has.
fn width(variables: usize) -> usize {
    variables.next_power_of_two().clamp(2, WIDTH)
}

/// A pass with second derivatives by so many variables, in evaluations of the function.
fn second_cost(variables: usize) -> f64 {
    let width = width(variables) as f64;
    1.0 + 0.25 * width * (0.5 * width + 1.5)
}

/// The same for a function without structure.
fn dense_cost(variables: usize) -> f64 {
    let passes = if variables <= WIDTH { 1 } else { block_pairs(variables, WIDTH).count() };
    passes as f64 * second_cost(variables.min(WIDTH))
}

/// Value, Jacobian and Hessians of a function with a plan for its structure.
pub(crate) fn enclose_by_plan<F: Function>(
    f: &F,
    plan: &Plan,
    x: &[Interval],
    p: &[Interval],
    jet: &mut Jet,
) -> Result<(), BoundError> {
    BoundError::check_box(Operand::Variables, f.variables(), x)?;
    BoundError::check_box(Operand::Parameters, f.parameters(), p)?;
    jet.reset(Order::Hessian, x.len(), f.outputs());
    // Second derivatives by variables of no common block are zero.
    jet.parts_mut().2.fill(Interval::ZERO);
    for block in &plan.curved {
        match width(block.len()) {
            2 => pass::<_, Second<Interval, 2, 3, Decorated>>(f, x, p, block, jet)?,
            4 => pass::<_, Second<Interval, 4, 10, Decorated>>(f, x, p, block, jet)?,
            _ => pass::<_, Second<Interval, 8, 36, Decorated>>(f, x, p, block, jet)?,
        }
    }
    for block in &plan.straight {
        match width(block.len()) {
            2 => pass::<_, Dual<Interval, 2, Decorated>>(f, x, p, block, jet)?,
            4 => pass::<_, Dual<Interval, 4, Decorated>>(f, x, p, block, jet)?,
            _ => pass::<_, Dual<Interval, 8, Decorated>>(f, x, p, block, jet)?,
        }
    }
    Ok(())
}
