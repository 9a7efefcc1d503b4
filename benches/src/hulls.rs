//! Hulls, supports and emptiness of constrained zonotopes against LP solvers, on the same sets in one run.

use std::hint::black_box;

use scalars::Interval;
use setrep::{ConstrainedZonotope, Workspace};

use crate::cz_sets::{SIZES, Size, chain, random};
use crate::lp_peers::{Clarabel, Microlp, hull_objectives};
use crate::timing::Bench;

/// Sets of a row: times vary from set to set.
const SETS: u64 = 4;

/// A set with the memory its owner keeps.
struct Ours {
    set: ConstrainedZonotope,
    workspace: Workspace,
    hull: Vec<Interval>,
}

impl Ours {
    fn new(set: &ConstrainedZonotope) -> Self {
        Self { set: set.clone(), workspace: Workspace::new(), hull: vec![Interval::ZERO; set.dim()] }
    }

    /// What a user calls: the proven hull, within memory of the last call.
    fn hull(&mut self) {
        black_box(&self.set).interval_hull_into(&mut self.hull, &mut self.workspace).expect("sizes agree");
        black_box(&self.hull);
    }
}

/// The rows `hull/*`, `hull-chain/*`, `hull-cold/*`, `support/*` and `emptiness/*`.
pub fn benches() -> Vec<Bench> {
    let mut benches = Vec::new();
    for size in SIZES {
        let sets: Vec<_> = (0..SETS).map(|seed| random(size, seed)).collect();
        benches.extend(hull_rows(&format!("hull/{size}"), &sets));
        if size.n < 20 {
            benches.push(cold_row(&format!("hull-cold/{size}"), &sets));
            benches.push(support_row(&format!("support/{size}"), &sets));
            benches.push(emptiness_row(&format!("emptiness/{size}"), &sets));
        }
    }
    for (n, steps) in [(4, 4), (10, 15)] {
        let sets: Vec<_> = (0..SETS).map(|seed| chain(n, steps, seed)).collect();
        let size = Size { n, ng: sets[0].num_generators(), nc: sets[0].num_constraints() };
        benches.extend(hull_rows(&format!("hull-chain/{size}"), &sets));
    }
    benches
}

/// The hull of random sets of one size against Clarabel.
pub fn random_hull(size: Size) -> Bench {
    let sets: Vec<_> = (0..SETS / 2).map(|seed| random(size, seed)).collect();
    clarabel_row(&format!("hull/{size}"), &sets)
}

/// A row whose calls run over all sets.
fn over<P: 'static>(
    name: &str,
    peer: &'static str,
    sets: &[ConstrainedZonotope],
    mut ours: impl FnMut(&mut Ours) + 'static,
    mut peers: Vec<P>,
    mut theirs: impl FnMut(&mut P) + 'static,
) -> Bench {
    let mut states: Vec<Ours> = sets.iter().map(Ours::new).collect();
    Bench::new(
        name,
        peer,
        move || states.iter_mut().for_each(&mut ours),
        move || peers.iter_mut().for_each(&mut theirs),
    )
    .batched(sets.len())
}

/// The hull against both peers.
fn hull_rows(name: &str, sets: &[ConstrainedZonotope]) -> [Bench; 2] {
    let microlp: Vec<_> = sets.iter().map(|set| Microlp::new(set, &hull_objectives(set))).collect();
    let count = 2 * sets[0].dim();
    [
        clarabel_row(name, sets),
        over(name, "microlp", sets, Ours::hull, microlp, move |solver| {
            for k in 0..count {
                black_box(solver.maximum(k));
            }
        }),
    ]
}

/// The hull against Clarabel set up beforehand.
fn clarabel_row(name: &str, sets: &[ConstrainedZonotope]) -> Bench {
    let clarabel: Vec<_> = sets.iter().map(|set| (Clarabel::new(set), hull_objectives(set))).collect();
    over(name, "clarabel", sets, Ours::hull, clarabel, |(solver, objectives)| {
        for objective in objectives {
            black_box(solver.maximize(objective));
        }
    })
}

/// The hull of a set never seen before, in fresh memory, against a Clarabel problem set up for it.
fn cold_row(name: &str, sets: &[ConstrainedZonotope]) -> Bench {
    let ours = |ours: &mut Ours| {
        black_box(ours.set.interval_hull(&mut Workspace::new())).expect("sizes agree");
    };
    let peers = sets.iter().map(|set| (set.clone(), hull_objectives(set))).collect();
    over(name, "clarabel", sets, ours, peers, |(set, objectives)| {
        let mut solver = Clarabel::new(set);
        for objective in objectives {
            black_box(solver.maximize(objective));
        }
    })
}

/// One support value, the problem loaded anew, against one solve of Clarabel set up beforehand.
fn support_row(name: &str, sets: &[ConstrainedZonotope]) -> Bench {
    let ours = |ours: &mut Ours| {
        let direction = [1.0; 20];
        let support = ours.set.support(black_box(&direction[..ours.set.dim()]), &mut ours.workspace);
        black_box(support.expect("sizes agree"));
    };
    let sum =
        |set: &ConstrainedZonotope| (0..set.num_generators()).map(|j| set.generators().col(j).iter().sum()).collect();
    let peers: Vec<(Clarabel, Vec<f64>)> = sets.iter().map(|set| (Clarabel::new(set), sum(set))).collect();
    over(name, "clarabel", sets, ours, peers, |(solver, objective)| {
        black_box(solver.maximize(objective));
    })
}

/// Emptiness with its proof, against one solve of Clarabel for feasibility.
fn emptiness_row(name: &str, sets: &[ConstrainedZonotope]) -> Bench {
    let ours = |ours: &mut Ours| {
        black_box(black_box(&ours.set).emptiness(&mut ours.workspace).expect("sizes agree"));
    };
    let peers: Vec<_> = sets.iter().map(|set| (Clarabel::new(set), vec![0.0; set.num_generators()])).collect();
    over(name, "clarabel", sets, ours, peers, |(solver, zeros)| {
        black_box(solver.maximize(zeros));
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All three sides compute the same hulls.
    #[test]
    fn the_peers_solve_the_same_problems() {
        let sets = SIZES[..3].iter().map(|&size| random(size, 1)).chain([chain(4, 4, 1), chain(10, 15, 1)]);
        for set in sets {
            let objectives = hull_objectives(&set);
            let (mut clarabel, microlp) = (Clarabel::new(&set), Microlp::new(&set, &objectives));
            let mut ours = Ours::new(&set);
            ours.hull();
            for (k, objective) in objectives.iter().enumerate() {
                let (side, shift) = (ours.hull[k / 2], set.center()[k / 2]);
                let value = if k % 2 == 0 { side.hi() - shift } else { shift - side.lo() };
                let (a, b) = (clarabel.maximize(objective), microlp.maximum(k));
                assert!((a - value).abs() < 1e-6 * (1.0 + value.abs()), "Clarabel {a}, ours {value}");
                assert!((b - value).abs() < 1e-9 * (1.0 + value.abs()), "microlp {b}, ours {value}");
            }
        }
    }
}
