//! A warm solver allocates nothing.

use crate::common::corpus::{KINDS, SIZES, case};
use boxlp::Solver;

#[test]
fn a_warm_solver_allocates_nothing() {
    for kind in KINDS {
        for &size in if kind.is_tall() {
            &SIZES[..1]
        } else {
            &SIZES[..3]
        } {
            let cases: Vec<_> = (0..3).map(|seed| case(kind, size, seed)).collect();
            let mut solver = Solver::new(cases[0].problem.clone());
            let mut run = || {
                for case in &cases {
                    solver.load(&case.problem);
                    for c in &case.objectives {
                        solver.maximize(c).unwrap();
                    }
                    solver.emptiness();
                }
            };
            run();
            let count = allocation_counter::measure(run).count_total;
            assert_eq!(count, 0, "{kind:?} {size:?}: {count} allocations");
        }
    }
}

#[test]
fn rows_come_and_go_without_allocation() {
    let case = case(KINDS[0], SIZES[1], 5);
    let extra: Vec<Vec<f64>> = case.objectives.iter().take(3).cloned().collect();
    let rows = case.problem.rows();
    let mut solver = Solver::new(case.problem.clone());
    let mut run = || {
        for row in &extra {
            solver.push_row(row, -0.5, 0.5).unwrap();
        }
        for c in &case.objectives {
            solver.maximize(c).unwrap();
        }
        solver.truncate_rows(rows);
        for c in &case.objectives {
            solver.maximize(c).unwrap();
        }
    };
    run();
    run();
    assert_eq!(allocation_counter::measure(run).count_total, 0);
}
