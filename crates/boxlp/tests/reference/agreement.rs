//! 13 kinds, more than 1,300 sets and 12,000 LPs: agreement, emptiness, gaps.

use super::microlp_oracle::Answer;
use super::{clarabel_oracle, microlp_oracle};
use crate::common::corpus::{Case, KINDS, Kind, SIZES, case};
use crate::common::{cases, norm1};
use boxlp::{Emptiness, Solver, Status};
use std::collections::BTreeMap;

/// What was seen of one kind.
#[derive(Clone, Debug, Default)]
struct Tally {
    seconds: f64,
    sets: usize,
    lps: usize,
    pivots: usize,
    stopped: usize,
    gap: f64,
    microlp: f64,
    microlp_failed: usize,
    microlp_false_empty: usize,
    clarabel: f64,
    clarabel_unsolved: usize,
    empty: usize,
    nonempty: usize,
}

fn seeds(kind: Kind, size: usize) -> usize {
    match (kind, size) {
        (Kind::Tall4x150, 0) => cases(12),
        (Kind::Tall6x640, 0) => cases(4),
        (Kind::Tall4x150 | Kind::Tall6x640, _) => 0,
        (_, 3) => 1,
        (_, _) => cases(40),
    }
}

fn run(case: &Case, seed: u64, solver: &mut Solver, tally: &mut Tally) {
    let Case { kind, problem, objectives } = case;
    tally.sets += 1;
    solver.load(problem);
    let clarabel =
        if kind.is_empty() { vec![None; objectives.len()] } else { clarabel_oracle::maximize(problem, objectives) };
    for (c, clarabel) in objectives.iter().zip(clarabel) {
        let norm = norm1(c);
        let scale = 1.0 + norm;
        let label = format!("{kind:?} {}x{} seed {seed}", problem.variables(), problem.rows());
        let solution = solver.maximize(c).unwrap();
        tally.lps += 1;
        tally.pivots += solution.pivots;
        assert_eq!(solution.status == Status::Empty, kind.is_empty(), "{label}: {:?}", solution.status);
        if kind.is_empty() {
            continue;
        }
        tally.stopped += usize::from(solution.status != Status::Optimal);
        tally.gap = tally.gap.max(solution.gap() / scale);
        assert!(solution.point.iter().all(|x| x.abs() <= 1.0));
        assert!(
            problem.upper_bound(c, solution.multipliers).unwrap() == solution.bound,
            "{label}: bound not reproduced"
        );
        match microlp_oracle::maximize(problem, c) {
            Answer::Optimum(value) => {
                tally.microlp = tally.microlp.max((value - solution.value).abs() / scale);
                assert!(solution.bound >= value - 1e-9 * scale, "{label}: bound below microlp's optimum");
            }
            Answer::Infeasible => tally.microlp_false_empty += 1,
            Answer::Failed => tally.microlp_failed += 1,
        }
        match clarabel {
            Some(value) => {
                tally.clarabel = tally.clarabel.max((value - solution.value).abs() / scale);
                assert!(solution.bound >= value - 1e-6 * scale, "{label}: bound below Clarabel's optimum");
            }
            None => tally.clarabel_unsolved += 1,
        }
    }
    match solver.emptiness() {
        Emptiness::Empty(certificate) => {
            assert!(kind.is_empty() && certificate.verify(problem));
            tally.empty += 1;
        }
        Emptiness::NonEmpty(_) => {
            assert!(!kind.is_empty());
            tally.nonempty += 1;
        }
        Emptiness::Undecided => assert!(!kind.is_empty() && !kind.is_regular(), "{kind:?} seed {seed}: undecided"),
    }
}

#[test]
fn the_corpus_agrees_with_two_other_solvers() {
    let mut tallies: BTreeMap<Kind, Tally> = BTreeMap::new();
    let mut solver = Solver::new(boxlp::Problem::new(0).unwrap());
    for kind in KINDS {
        let tally = tallies.entry(kind).or_default();
        let start = std::time::Instant::now();
        for (k, &size) in SIZES.iter().enumerate() {
            for seed in 0..seeds(kind, k) as u64 {
                run(&case(kind, size, seed), seed, &mut solver, tally);
            }
        }
        tally.seconds = start.elapsed().as_secs_f64();
    }
    let (sets, lps) = tallies.values().fold((0, 0), |(s, l), t| (s + t.sets, l + t.lps));
    println!("{sets} sets, {lps} LPs; errors and gaps as shares of 1 + |c|_1");
    for (kind, t) in &tallies {
        println!(
            "{kind:?}: {:.1} s, {} sets, {} LPs, {:.1} pivots an LP, {} stopped | gap {:.1e} | microlp off {:.1e}, failed {}, \
             false empty {} | Clarabel off {:.1e}, unsolved {} | proven empty {}, non-empty {}",
            t.seconds,
            t.sets,
            t.lps,
            t.pivots as f64 / t.lps as f64,
            t.stopped,
            t.gap,
            t.microlp,
            t.microlp_failed,
            t.microlp_false_empty,
            t.clarabel,
            t.clarabel_unsolved,
            t.empty,
            t.nonempty
        );
        assert_eq!(t.stopped, 0, "{kind:?}");
        assert!(t.microlp <= 1e-9, "{kind:?}: microlp {:e}", t.microlp);
        assert!(t.clarabel <= 1e-6, "{kind:?}: Clarabel {:e}", t.clarabel);
        assert!(t.gap <= if kind.is_regular() { 1e-11 } else { 1e-8 }, "{kind:?}: gap {:e}", t.gap);
    }
    assert!(sets >= 1300 && lps >= 12_000);
}
