//! Sets around the limit of emptiness, larger than exact arithmetic allows: `min t` of `microlp` is the judge.

use super::microlp_oracle::{self, Answer};
use crate::common::corpus::{KINDS, SIZES, case};
use crate::common::{cases, norm1};
use boxlp::{Emptiness, Solver};

/// No set is missed whose rows miss by more than 1e-9 of their 1-norms, none is called empty that has a point.
#[test]
fn no_empty_set_is_missed_and_none_is_invented() {
    let (mut steps, mut empty, mut nearest) = (0, 0, f64::INFINITY);
    for seed in 0..cases(3) as u64 {
        for kind in KINDS.into_iter().filter(|k| !k.is_empty()) {
            for size in &SIZES[..if kind.is_tall() { 1 } else { 3 }] {
                if kind.is_tall() && seed > 0 {
                    continue;
                }
                let case = case(kind, *size, 1000 + seed);
                let c = &case.objectives[1];
                let norm = norm1(c);
                let top = Solver::new(case.problem.clone()).maximize(c).unwrap().value;
                for exponent in [-3, -6, -8, -9, -10, -12] {
                    for sign in [1.0, -1.0] {
                        let mut problem = case.problem.clone();
                        problem.push_row(c, top + sign * norm * 10_f64.powi(exponent), f64::INFINITY).unwrap();
                        let mut solver = Solver::new(problem.clone());
                        let answer = solver.emptiness();
                        steps += 1;
                        let label = format!("{kind:?} {size:?} seed {seed} {sign} 1e{exponent}");
                        if let Emptiness::Empty(certificate) = answer {
                            assert!(certificate.verify(&problem), "{label}: no proof");
                            assert!(sign > 0.0 || exponent <= -12, "{label}: called empty");
                            empty += 1;
                            nearest = nearest.min(certificate.miss(&problem));
                        } else if sign > 0.0 {
                            let miss = microlp_oracle::miss(&problem);
                            assert!(!matches!(miss, Answer::Optimum(t) if t > 1.1e-9), "{label}: missed, {miss:?}");
                        }
                    }
                }
            }
        }
    }
    println!("{steps} sets, {empty} proven empty, the nearest by a miss of {nearest:.1e} of the 1-norms");
}
