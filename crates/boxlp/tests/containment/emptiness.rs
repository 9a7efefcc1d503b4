//! Certificates and witnesses are true in exact arithmetic; sets that miss by more than 1e-9 are found empty.

use crate::common::cases;
use crate::common::corpus::{KINDS, case};
use crate::common::exact::{Exact, dot, rational, weak_duality};
use boxlp::{Certificate, Emptiness, Problem, Solver, Status};
use num_traits::Signed;

/// Checks the answer of `emptiness` exactly; returns (empty, non-empty) claims.
fn check(problem: &Problem, label: &str) -> (bool, bool) {
    let zeros = vec![0.0; problem.variables()];
    let mut solver = Solver::new(problem.clone());
    match solver.emptiness() {
        Emptiness::Empty(certificate) => {
            assert!(
                certificate.verify(problem),
                "{label}: the certificate does not verify"
            );
            assert!(
                weak_duality(problem, &zeros, certificate.multipliers()).is_negative(),
                "{label}: false certificate"
            );
            assert!(
                Exact::new(problem).maximize(&zeros).is_none(),
                "{label}: called empty"
            );
            (true, false)
        }
        Emptiness::NonEmpty(witness) => {
            let (x, radius) = (witness.point(), witness.radius());
            assert!(x.iter().all(|x| x.abs() <= 1.0));
            if radius == 0.0 {
                for i in 0..problem.rows() {
                    let (lower, upper) = problem.range(i);
                    let activity = dot(problem.row(i), x);
                    assert!(
                        lower.is_infinite() || activity >= rational(lower),
                        "{label}: witness below row {i}"
                    );
                    assert!(
                        upper.is_infinite() || activity <= rational(upper),
                        "{label}: witness above row {i}"
                    );
                }
            } else {
                // The set, cut to the ball, still has a point.
                assert!(radius < 1e-9, "{label}: radius {radius:e}");
                let mut ball = problem.clone();
                for j in 0..problem.variables() {
                    let mut row = zeros.clone();
                    row[j] = 1.0;
                    ball.push_row(&row, (x[j] - radius).next_down(), (x[j] + radius).next_up())
                        .unwrap();
                }
                assert!(
                    Exact::new(&ball).maximize(&zeros).is_some(),
                    "{label}: no point in the ball of the witness"
                );
            }
            (false, true)
        }
        Emptiness::Undecided => (false, false),
    }
}

#[test]
fn claims_on_the_corpus_are_true() {
    let mut counts = [0; 3];
    for seed in 0..cases(12) as u64 {
        for kind in KINDS.into_iter().filter(|k| !k.is_tall()) {
            for size in [(2, 4, 2), (2, 6, 3), (2, 8, 4)] {
                let label = format!("{kind:?} {size:?} seed {seed}");
                let (empty, full) = check(&case(kind, size, seed).problem, &label);
                assert_eq!(empty, kind.is_empty(), "{label}");
                if kind.is_regular() {
                    assert!(full, "{label}: a regular set is not proven non-empty");
                }
                counts[usize::from(empty) + 2 * usize::from(full)] += 1;
            }
        }
    }
    println!(
        "undecided {}, empty {}, non-empty {}",
        counts[0], counts[1], counts[2]
    );
}

/// A support row moved just outside or just inside: right at every miss above 1e-9, never wrong below.
#[test]
fn the_ladder_is_climbed_on_the_right_side() {
    let (mut missed, mut steps) = (0, 0);
    for seed in 0..cases(4) as u64 {
        for kind in KINDS.into_iter().filter(|k| k.is_regular() && !k.is_tall()) {
            let case = case(kind, (2, 7, 3), seed);
            let c = &case.objectives[0];
            let norm: f64 = c.iter().copied().map(f64::abs).sum();
            let top = Solver::new(case.problem.clone()).maximize(c).unwrap().bound;
            for exponent in 2..15 {
                for sign in [-1.0, 1.0] {
                    let mut problem = case.problem.clone();
                    let shift = sign * norm * 10_f64.powi(-exponent);
                    problem.push_row(c, top + shift, f64::INFINITY).unwrap();
                    let label = format!("{kind:?} seed {seed} shift {shift:e}");
                    let (empty, _) = check(&problem, &label);
                    steps += 1;
                    if sign > 0.0 && exponent <= 8 && !empty {
                        missed += 1;
                        println!("{label}: not found empty");
                    }
                }
            }
        }
    }
    println!("{steps} steps, {missed} missed");
    assert_eq!(missed, 0);
}

/// A certificate of one problem proves nothing about another.
#[test]
fn verify_rejects_what_is_no_proof() {
    let mut empty = Problem::new(2).unwrap();
    empty.push_row(&[1.0, 1.0], 2.5, 3.0).unwrap();
    let mut solver = Solver::new(empty.clone());
    assert_eq!(solver.maximize(&[1.0, 0.0]).unwrap().status, Status::Empty);
    let Emptiness::Empty(certificate) = solver.emptiness() else {
        panic!("a row beyond the box")
    };
    assert!(certificate.verify(&empty));
    assert!((certificate.miss(&empty) - 0.25).abs() < 1e-12);
    let mut touching = Problem::new(2).unwrap();
    touching.push_row(&[1.0, 1.0], 2.0, 3.0).unwrap();
    assert!(!certificate.verify(&touching));
    assert!(!certificate.verify(&Problem::new(2).unwrap()));
    for y in [f64::NAN, f64::INFINITY, 0.0, 1.0, -1e308] {
        assert!(!Certificate::new(vec![(0, y)]).verify(&touching));
    }
    assert!(!Certificate::new(vec![]).verify(&touching));
}
