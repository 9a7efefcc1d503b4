//! A pivot limit loosens the bound, nothing else; large problems are within reach.

use crate::common::corpus::{KINDS, Kind, SIZES, case};
use crate::common::norm1;
use boxlp::{Solver, Status};

#[test]
fn a_pivot_limit_loosens_the_bound_only() {
    for kind in KINDS.into_iter().filter(|k| !k.is_empty()) {
        for seed in 0..4 {
            let case = case(kind, SIZES[2], seed);
            for c in case.objectives.iter().take(4) {
                let norm = norm1(c);
                let optimum = Solver::new(case.problem.clone()).maximize(c).unwrap().value;
                let mut last = f64::INFINITY;
                for limit in 0..60 {
                    let mut solver = Solver::new(case.problem.clone());
                    solver.set_pivot_limit(Some(limit));
                    let solution = solver.maximize(c).unwrap();
                    assert!(solution.pivots <= limit);
                    assert!(solution.bound >= optimum - 1e-9 * norm && solution.bound <= norm * (1.0 + 1e-12));
                    // Dual simplex: bounds fall monotonically.
                    assert!(solution.bound <= last + 1e-9 * norm, "{kind:?} seed {seed} limit {limit}");
                    last = solution.bound;
                    if solution.status == Status::Optimal {
                        assert!((solution.value - optimum).abs() <= 1e-9 * norm);
                        break;
                    }
                }
            }
        }
    }
}

#[test]
fn the_largest_intended_sizes_are_solved() {
    for (kind, size) in
        [(Kind::Regular, (2, 500, 100)), (Kind::Chain, (2, 500, 100)), (Kind::RedundantRows, (1, 500, 100))]
    {
        let case = case(kind, size, 1);
        let mut solver = Solver::new(case.problem.clone());
        for c in &case.objectives {
            let norm = norm1(c);
            let solution = solver.maximize(c).unwrap();
            assert_eq!(solution.status, Status::Optimal);
            assert!(solution.gap() <= 1e-11 * norm, "{kind:?}: {:e}", solution.gap() / norm);
        }
    }
}
