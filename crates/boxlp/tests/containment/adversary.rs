//! Problems meant to hurt: bounds hold, claims are true, whatever was asked before and wherever the method had to stop.

use super::emptiness::check;
use crate::common::exact::{Exact, rational};
use crate::common::random::Random;
use crate::common::{cases, dot, nasty, norm1};
use boxlp::{Problem, Solver, Status};
use num_rational::BigRational;

/// The answer to one objective holds exactly; returns whether it is optimal, or proven empty.
fn check_answer(solver: &mut Solver, c: &[f64], optimum: Option<&BigRational>, label: &str) -> bool {
    let problem = solver.problem().clone();
    let solution = solver.maximize(c).unwrap();
    assert!(solution.point.iter().all(|x| x.abs() <= 1.0), "{label}: {:?}", solution.point);
    assert!(!solution.bound.is_nan() && !solution.value.is_nan(), "{label}: {solution:?}");
    if let Some(optimum) = optimum {
        assert_ne!(solution.status, Status::Empty, "{label}: called empty");
        assert!(rational(solution.bound) >= *optimum, "{label}: bound below the optimum");
        let again = problem.upper_bound(c, solution.multipliers).unwrap();
        assert_eq!(again, solution.bound, "{label}: bound not reproduced");
    }
    solution.status != Status::Stopped
}

#[test]
fn nasty_problems_are_answered_validly() {
    let (mut answers, mut settled) = (0, 0);
    for seed in 0..cases(800) as u64 {
        let mut random = Random::new(seed + 10_000);
        let (n, m) = (1 + random.below(5), random.below(6));
        let problem = nasty::problem(&mut random, n, m);
        let label = format!("nasty seed {seed}: {problem:?}");
        let mut exact = Exact::new(&problem);
        let mut solver = Solver::new(problem.clone());
        solver.set_pivot_limit([None, None, Some(0), Some(1), Some(2)][random.below(5)]);
        for _ in 0..3 {
            let c = nasty::objective(&mut random, &problem);
            let optimum = exact.maximize(&c);
            answers += 1;
            settled += usize::from(check_answer(&mut solver, &c, optimum.as_ref(), &format!("{label} {c:?}")));
        }
        check(&problem, 1e-3, &label);
    }
    println!("{answers} answers, {settled} settled");
    assert!(2 * settled > answers);
}

/// Rows come, go and move between solves: the bound holds for the rows of the moment.
#[test]
fn nasty_edits_leave_valid_answers() {
    for seed in 0..cases(60) as u64 {
        let mut random = Random::new(seed + 20_000);
        let n = 2 + random.below(3);
        let through = nasty::through(&mut random, n);
        let mut solver = Solver::new(Problem::new(n).unwrap());
        for step in 0..15 {
            match random.below(6) {
                0 => solver.truncate_rows(random.below(5)),
                1 => {
                    let dropped = random.below(4);
                    solver.retain_rows(|i| i % 4 != dropped);
                }
                2 if solver.problem().rows() > 0 => {
                    let i = random.below(solver.problem().rows());
                    let (_, lower, upper) = nasty::row(&mut random, &through, solver.problem());
                    solver.set_range(i, lower, upper).unwrap();
                }
                3 => {
                    solver.emptiness();
                }
                _ if solver.problem().rows() < 6 => {
                    let (row, lower, upper) = nasty::row(&mut random, &through, solver.problem());
                    solver.push_row(&row, lower, upper).unwrap();
                }
                _ => solver.set_pivot_limit([None, Some(1)][random.below(2)]),
            }
            let c = nasty::objective(&mut random, solver.problem());
            let optimum = Exact::new(solver.problem()).maximize(&c);
            let label = format!("edits seed {seed} step {step}: {:?} {c:?}", solver.problem());
            check_answer(&mut solver, &c, optimum.as_ref(), &label);
        }
    }
}

/// Sizes beyond exact arithmetic, around a known point: no hang, no false claim.
#[test]
fn large_nasty_problems_end() {
    for (n, m) in [(500, 100), (12, 1000), (100, 100), (3, 400)] {
        for seed in 0..cases(3) as u64 {
            let mut random = Random::new(seed + 30_000);
            let through = nasty::through(&mut random, n);
            let mut problem = Problem::new(n).unwrap();
            for _ in 0..m {
                let (row, ..) = nasty::row(&mut random, &through, &problem);
                let norm = norm1(&row);
                let middle = dot(&row, &through);
                // Rounding of the middle is far below the width: the point satisfies every row.
                let width = norm * random.scale(-12.0, -2.0) + 1e-300;
                problem.push_row(&row, middle - width, middle + width).unwrap();
            }
            let mut solver = Solver::new(problem.clone());
            for _ in 0..3 {
                let c: Vec<f64> = (0..n).map(|_| random.normal()).collect();
                let at_point = dot(&c, &through);
                let norm = norm1(&c);
                let solution = solver.maximize(&c).unwrap();
                assert_ne!(solution.status, Status::Empty, "{n}x{m} seed {seed}");
                assert!(solution.bound >= at_point - 1e-13 * norm, "{n}x{m} seed {seed}");
                assert!(solution.pivots <= 36 * (n + m + 10), "{n}x{m} seed {seed}: {} pivots", solution.pivots);
                println!("{n}x{m} seed {seed}: {:?}, {} pivots", solution.status, solution.pivots);
            }
            assert!(!matches!(solver.emptiness(), boxlp::Emptiness::Empty(_)), "{n}x{m} seed {seed}");
        }
    }
}
