//! Answers do not depend on what the solver did before: warm and cold starts, rows appended and dropped, ranges moved.

use crate::common::corpus::{Case, KINDS, Kind, SIZES, case};
use crate::common::random::Random;
use crate::common::{cases, norm1};
use boxlp::{Problem, Solver, Status};

/// Both answer alike: empty or not, and values within 1e-9 of `1 + |c|_1`.
fn assert_alike(warm: &mut Solver, problem: &Problem, objectives: &[Vec<f64>], label: &str) {
    for c in objectives {
        let mut cold = Solver::new(problem.clone());
        let (a, b) = (warm.maximize(c).unwrap(), cold.maximize(c).unwrap());
        let scale = 1.0 + norm1(c);
        assert_eq!(a.status, b.status, "{label}");
        if a.status != Status::Empty {
            assert!((a.value - b.value).abs() <= 1e-9 * scale, "{label}: {} {}", a.value, b.value);
            assert!((a.bound - b.bound).abs() <= 1e-9 * scale, "{label}: {} {}", a.bound, b.bound);
        }
    }
}

#[test]
fn a_warm_start_changes_nothing() {
    for kind in KINDS {
        for &size in if kind.is_tall() { &SIZES[..1] } else { &SIZES[..3] } {
            for seed in 0..cases(4) as u64 {
                let Case { problem, objectives, .. } = case(kind, size, seed);
                let mut warm = Solver::new(problem.clone());
                assert_alike(&mut warm, &problem, &objectives, &format!("{kind:?} {size:?} {seed}"));
            }
        }
    }
}

/// A random walk over problems: rows appended and dropped, ranges moved, solves and emptiness checks between.
#[test]
fn edits_are_as_good_as_a_fresh_problem() {
    for kind in [Kind::Regular, Kind::Chain, Kind::RedundantRows, Kind::Integers, Kind::Scales] {
        for seed in 0..cases(6) as u64 {
            let Case { mut problem, objectives, .. } = case(kind, SIZES[1 + seed as usize % 2], seed);
            let mut random = Random::new(seed + 99);
            let mut solver = Solver::new(problem.clone());
            for step in 0..40 {
                let label = format!("{kind:?} seed {seed} step {step}");
                match random.below(5) {
                    0 | 1 => {
                        let row = &objectives[random.below(objectives.len())];
                        let norm = norm1(row);
                        let upper = norm * (0.2 + random.unit());
                        problem.push_row(row, f64::NEG_INFINITY, upper).unwrap();
                        solver.push_row(row, f64::NEG_INFINITY, upper).unwrap();
                    }
                    2 => {
                        let dropped = random.below(problem.rows().max(1));
                        problem.retain_rows(|i| i != dropped);
                        solver.retain_rows(|i| i != dropped);
                    }
                    3 if problem.rows() > 0 => {
                        let i = random.below(problem.rows());
                        let (lower, upper) = problem.range(i);
                        problem.set_range(i, lower - 0.01, upper + 0.01).unwrap();
                        solver.set_range(i, lower - 0.01, upper + 0.01).unwrap();
                    }
                    _ => {
                        solver.emptiness();
                    }
                }
                assert_eq!(solver.problem(), &problem, "{label}");
                let c = &objectives[step % objectives.len()];
                assert_alike(&mut solver, &problem, std::slice::from_ref(c), &label);
            }
        }
    }
}

/// Thousands of objectives on one tableau: drift is noticed and repaired.
#[test]
fn long_runs_stay_tight() {
    let mut random = Random::new(3);
    for (kind, size, objectives) in
        [(Kind::Regular, SIZES[1], 4000), (Kind::Scales, SIZES[2], 2000), (Kind::Regular, SIZES[3], 60)]
    {
        let case = case(kind, size, 11);
        let mut solver = Solver::new(case.problem.clone());
        let mut pivots = 0;
        for _ in 0..objectives {
            let c: Vec<f64> = (0..size.1).map(|_| random.normal()).collect();
            let norm = norm1(&c);
            let solution = solver.maximize(&c).unwrap();
            assert_eq!(solution.status, Status::Optimal);
            assert!(solution.gap() <= 1e-11 * norm, "{kind:?}: gap {:e} after {pivots} pivots", solution.gap() / norm);
            pivots += solution.pivots;
        }
    }
}

/// Scaling a row, or a range with it, by any power of two changes no answer at all.
#[test]
fn rows_may_be_scaled_by_powers_of_two() {
    for seed in 0..cases(10) as u64 {
        let Case { problem, objectives, .. } = case(Kind::Regular, SIZES[1], seed);
        let mut scaled = Problem::new(problem.variables()).unwrap();
        for i in 0..problem.rows() {
            let factor = 2_f64.powi(7 * i as i32 - 20);
            let row: Vec<f64> = problem.row(i).iter().map(|a| a * factor).collect();
            let (lower, upper) = problem.range(i);
            scaled.push_row(&row, lower * factor, upper * factor).unwrap();
        }
        let (mut a, mut b) = (Solver::new(problem), Solver::new(scaled));
        for c in &objectives {
            let (a, b) = (a.maximize(c).unwrap(), b.maximize(c).unwrap());
            assert_eq!((a.value, a.bound, a.point), (b.value, b.bound, b.point));
        }
    }
}
