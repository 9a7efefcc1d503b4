//! The proven bound is never below the exact optimum, and close to it.

use crate::common::corpus::{KINDS, Kind, case};
use crate::common::exact::{Exact, rational};
use crate::common::{cases, norm1, random::Random};
use boxlp::{Problem, Solver, Status};
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

/// >= 2,000 LPs of the small kinds: bound >= optimum exactly; on regular kinds within 1e-11 of it.
#[test]
fn bounds_hold_exactly() {
    let mut lps = 0;
    let mut excess = 0.0_f64;
    for seed in 0..cases(8) as u64 {
        for kind in KINDS.into_iter().filter(|k| !k.is_empty() && !k.is_tall()) {
            for size in [(5, 4, 2), (5, 5, 3), (5, 6, 3)] {
                let case = case(kind, size, seed);
                let mut exact = Exact::new(&case.problem);
                let mut solver = Solver::new(case.problem.clone());
                for c in &case.objectives {
                    let solution = solver.maximize(c).unwrap();
                    assert_ne!(solution.status, Status::Empty, "{kind:?} {size:?} seed {seed}");
                    lps += 1;
                    let Some(optimum) = exact.maximize(c) else {
                        continue;
                    };
                    let norm = norm1(c);
                    assert!(
                        rational(solution.bound) >= optimum,
                        "{kind:?} {size:?} seed {seed}: bound below the optimum"
                    );
                    let above = (rational(solution.bound) - &optimum).to_f64().unwrap() / (1.0 + norm);
                    let off = (rational(solution.value) - &optimum).abs().to_f64().unwrap() / (1.0 + norm);
                    if kind.is_regular() {
                        excess = excess.max(above);
                        assert!(above <= 1e-11 && off <= 1e-11, "{kind:?} {size:?} seed {seed}: {above:e} {off:e}");
                    } else if kind != Kind::RedundantRows {
                        // (Rows that are dependent but for the rounding of their entries cut the set exactly, not usefully.)
                        assert!(above <= 1e-8 && off <= 1e-8, "{kind:?} {size:?} seed {seed}: {above:e} {off:e}");
                    }
                }
            }
        }
    }
    println!("{lps} LPs, excess of the bound on regular kinds at most {excess:.1e}");
    assert!(lps >= 2000);
}

/// Tall sets: the optimum over 150 rows in 4 variables, exactly.
#[test]
fn tall_bounds_hold_exactly() {
    for seed in 0..cases(1) as u64 {
        let case = case(Kind::Tall4x150, (0, 0, 0), seed);
        let mut exact = Exact::new(&case.problem);
        let mut solver = Solver::new(case.problem.clone());
        for c in &case.objectives {
            let optimum = exact.maximize(c).expect("built around a point");
            let bound = solver.maximize(c).unwrap().bound;
            assert!(rational(bound) >= optimum && (rational(bound) - optimum).to_f64().unwrap() < 1e-11);
        }
    }
}

/// Any multipliers whatever give a valid bound.
#[test]
fn random_multipliers_give_valid_bounds() {
    let mut random = Random::new(7);
    for seed in 0..cases(40) as u64 {
        let case = case(KINDS[seed as usize % 9], (3, 6, 3), seed);
        let mut exact = Exact::new(&case.problem);
        for c in &case.objectives {
            let Some(optimum) = exact.maximize(c) else {
                continue;
            };
            for _ in 0..20 {
                let scale = random.scale(-300.0, 300.0);
                let y: Vec<(usize, f64)> =
                    (0..random.below(6)).map(|_| (random.below(3), scale * random.normal())).collect();
                let bound = case.problem.upper_bound(c, &y).unwrap();
                assert!(bound.is_finite() && rational(bound) >= optimum, "seed {seed}, y {y:?}");
            }
        }
    }
}

fn entry() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => -2.0..2.0_f64,
        2 => (-4..5_i32).prop_map(f64::from),
        1 => Just(0.0),
        1 => (-8.0..8.0_f64, -1.0..1.0_f64).prop_map(|(e, v)| v * 10_f64.powf(e)),
    ]
}

fn problem() -> impl Strategy<Value = (Problem, Vec<Vec<f64>>)> {
    (1..6_usize, 0..5_usize).prop_flat_map(|(n, m)| {
        let row = (prop::collection::vec(entry(), n), entry(), prop_oneof![Just(0.0), 0.0..3.0_f64], 0..4_u8);
        let objective = prop::collection::vec(entry(), n);
        (prop::collection::vec(row, m), prop::collection::vec(objective, 1..4)).prop_map(move |(rows, objectives)| {
            let mut problem = Problem::new(n).unwrap();
            for (row, lower, width, form) in rows {
                let (lower, upper) = match form {
                    0 => (f64::NEG_INFINITY, lower),
                    1 => (lower, f64::INFINITY),
                    _ => (lower, lower + width),
                };
                problem.push_row(&row, lower, upper).unwrap();
            }
            (problem, objectives)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: cases(2000) as u32,
        failure_persistence: None,
        rng_seed: prop::test_runner::RngSeed::Fixed(20_261_122),
        ..ProptestConfig::default()
    })]

    /// Entries of 1e-8 .. 1e8, integers, zeros, one-sided rows: the bound holds, "empty" is true, and an optimal bound lies
    /// between the exact optimum and that of the rows loosened by a few roundings.
    #[test]
    fn any_small_problem_is_answered_validly((problem, objectives) in problem()) {
        let mut exact = Exact::new(&problem);
        let mut loosened = Exact::new(&loosened(&problem, LOOSE));
        let mut solver = Solver::new(problem.clone());
        for c in &objectives {
            let solution = solver.maximize(c).unwrap();
            let Some(optimum) = exact.maximize(c) else {
                prop_assert!(solution.bound.is_finite() || solution.status == Status::Empty);
                continue;
            };
            prop_assert_ne!(solution.status, Status::Empty);
            prop_assert!(rational(solution.bound) >= optimum);
            if solution.status == Status::Optimal {
                let norm = norm1(c);
                let most = loosened.maximize(c).unwrap() + rational(1e-10 * norm + 1e-300);
                prop_assert!(rational(solution.bound) <= most, "bound {:e}", solution.bound);
            }
        }
    }
}

/// Rows may be missed by a few roundings of their 1-norms; a set whose rows contradict each other by less than 1e-12 of these is
/// treated as the one they mean.
const LOOSE: f64 = 1e-11;

/// The same rows, each range wider by a share of the row's 1-norm on either side.
fn loosened(problem: &Problem, share: f64) -> Problem {
    let mut wide = problem.clone();
    for i in 0..problem.rows() {
        let reach = norm1(problem.row(i));
        let (lower, upper) = problem.range(i);
        wide.set_range(i, lower - share * reach, upper + share * reach).unwrap();
    }
    wide
}
