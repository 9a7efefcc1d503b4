//! Certificates and witnesses are true in exact arithmetic; sets that miss by more than 1e-9 are found empty.

use crate::common::corpus::{KINDS, case};
use crate::common::exact::{self, Exact, rational, weak_duality};
use crate::common::random::Random;
use crate::common::{cases, dot, norm1};
use boxlp::{Certificate, Emptiness, Problem, Solver, Status};
use num_traits::Signed;

/// Checks the answer of `emptiness` exactly, and the radius of a witness; returns (empty, non-empty) claims.
pub(crate) fn check(problem: &Problem, widest: f64, label: &str) -> (bool, bool) {
    let zeros = vec![0.0; problem.variables()];
    let mut solver = Solver::new(problem.clone());
    match solver.emptiness() {
        Emptiness::Empty(certificate) => {
            assert!(certificate.verify(problem), "{label}: the certificate does not verify");
            assert!(
                weak_duality(problem, &zeros, certificate.multipliers()).is_negative(),
                "{label}: false certificate"
            );
            assert!(Exact::new(problem).maximize(&zeros).is_none(), "{label}: called empty");
            (true, false)
        }
        Emptiness::NonEmpty(witness) => {
            let (x, radius) = (witness.point(), witness.radius());
            assert!(x.iter().all(|x| x.abs() <= 1.0));
            if radius == 0.0 {
                for i in 0..problem.rows() {
                    let (lower, upper) = problem.range(i);
                    let activity = exact::dot(problem.row(i), x);
                    assert!(lower.is_infinite() || activity >= rational(lower), "{label}: witness below row {i}");
                    assert!(upper.is_infinite() || activity <= rational(upper), "{label}: witness above row {i}");
                }
            } else {
                // The set, cut to the ball, still has a point.
                assert!(radius <= widest, "{label}: radius {radius:e}");
                let mut ball = problem.clone();
                for j in 0..problem.variables() {
                    let mut row = zeros.clone();
                    row[j] = 1.0;
                    ball.push_row(&row, (x[j] - radius).next_down(), (x[j] + radius).next_up()).unwrap();
                }
                assert!(Exact::new(&ball).maximize(&zeros).is_some(), "{label}: no point in the ball of the witness");
            }
            (false, true)
        }
        Emptiness::Undecided => (false, false),
    }
}

/// Every claim is true, and what is left undecided is counted against what exact arithmetic knows.
#[test]
fn claims_on_the_corpus_are_true() {
    for kind in KINDS.into_iter().filter(|k| !k.is_tall()) {
        let (mut undecided, mut truly_full, mut proven) = (0, 0, 0);
        for seed in 0..cases(12) as u64 {
            for size in [(2, 4, 2), (2, 6, 3), (2, 8, 4)] {
                let label = format!("{kind:?} {size:?} seed {seed}");
                let problem = case(kind, size, seed).problem;
                let (empty, full) = check(&problem, 1e-9, &label);
                assert_eq!(empty, kind.is_empty(), "{label}");
                proven += usize::from(full);
                if !empty && !full {
                    undecided += 1;
                    let zeros = vec![0.0; problem.variables()];
                    truly_full += usize::from(Exact::new(&problem).maximize(&zeros).is_some());
                }
            }
        }
        println!("{kind:?}: {proven} proven non-empty, {undecided} undecided, of which {truly_full} are not empty");
        assert!(!kind.is_regular() || undecided == 0, "{kind:?}: a regular set is not proven non-empty");
    }
}

/// Integer points that the rows pin down, and rows that follow exactly from others, are proven non-empty whatever the scales.
#[test]
fn exact_points_and_exactly_dependent_rows_are_proven() {
    for seed in 0..cases(60) as u64 {
        let mut random = Random::new(seed + 500);
        let (n, m) = (3 + random.below(8), 1 + random.below(3));
        let mut dyadic = |count: usize, range: usize| -> Vec<f64> {
            (0..count).map(|_| random.below(2 * range + 1) as f64 - range as f64).collect()
        };
        // Corner sums pin a point; a few more integer equations hold there.
        let corner: Vec<f64> = dyadic(n, 1).iter().map(|v| if *v < 0.0 { -1.0 } else { 1.0 }).collect();
        let mut pinned = Problem::new(n).unwrap();
        for k in 0..=m {
            let row = if k == 0 { corner.clone() } else { dyadic(n, 3) };
            let value = dot(&row, &corner);
            pinned.push_row(&row, value, value).unwrap();
        }
        assert!(check(&pinned, 0.0, &format!("pinned, seed {seed}")).1, "pinned, seed {seed}");
        // Equations through a point that no float need satisfy, then their multiples and sums.
        let rows: Vec<Vec<f64>> = (0..m).map(|_| dyadic(n, 900)).collect();
        let inner: Vec<f64> = dyadic(n, 700).iter().map(|v| v / 1000.0).collect();
        let mut dependent = Problem::new(n).unwrap();
        let mut push = |row: &[f64], value: f64, factor: f64| {
            let row: Vec<f64> = row.iter().map(|a| a * factor).collect();
            dependent.push_row(&row, value * factor, value * factor).unwrap();
        };
        let values: Vec<f64> = rows.iter().map(|row| dot(row, &inner).round()).collect();
        for (k, (row, &value)) in rows.iter().zip(&values).enumerate() {
            push(row, value, 1.0);
            push(row, value, -3.0);
            push(row, value, 2_f64.powi(40 - 70 * k as i32));
            let sum: Vec<f64> = row.iter().zip(&rows[0]).map(|(a, b)| a + 2.0 * b).collect();
            push(&sum, value + 2.0 * values[0], 1.0);
        }
        assert!(check(&dependent, 1e-12, &format!("dependent, seed {seed}")).1, "dependent, seed {seed}");
    }
}

/// A support row moved just outside or just inside: right at every miss above 1e-9, never wrong below.
#[test]
fn the_ladder_is_climbed_on_the_right_side() {
    let (mut missed, mut steps) = (0, 0);
    for seed in 0..cases(4) as u64 {
        for kind in KINDS.into_iter().filter(|k| k.is_regular() && !k.is_tall()) {
            let case = case(kind, (2, 7, 3), seed);
            let c = &case.objectives[0];
            let norm = norm1(c);
            let top = Solver::new(case.problem.clone()).maximize(c).unwrap().bound;
            for exponent in 2..15 {
                for sign in [-1.0, 1.0] {
                    let mut problem = case.problem.clone();
                    let shift = sign * norm * 10_f64.powi(-exponent);
                    problem.push_row(c, top + shift, f64::INFINITY).unwrap();
                    let label = format!("{kind:?} seed {seed} shift {shift:e}");
                    let (empty, _) = check(&problem, 1e-9, &label);
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
    let Emptiness::Empty(certificate) = solver.emptiness() else { panic!("a row beyond the box") };
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
