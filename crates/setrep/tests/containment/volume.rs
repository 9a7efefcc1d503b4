//! Containment of exact images: volume.

use std::cmp::Ordering;

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::determinant;
use crate::common::random::{Random, cases};

/// `2^n sum |det|` over the `n`-subsets of the columns, exactly.
fn exact_volume(columns: &[Vec<Dyadic>], n: usize) -> Dyadic {
    fn descend(columns: &[Vec<Dyadic>], n: usize, from: usize, chosen: &mut Vec<Vec<Dyadic>>, sum: &mut Dyadic) {
        if chosen.len() == n {
            *sum += &determinant(chosen).abs();
            return;
        }
        for j in from..columns.len() {
            chosen.push(columns[j].clone());
            descend(columns, n, j + 1, chosen, sum);
            chosen.pop();
        }
    }
    let mut sum = Dyadic::zero();
    descend(columns, n, 0, &mut Vec::new(), &mut sum);
    &sum * &Dyadic::from(2f64.powi(n as i32))
}

#[test]
fn the_interval_contains_the_exact_volume() {
    let mut tight = 0;
    let total = cases(4_000);
    for case in 0..total {
        let mut random = Random::new(SEED + 20, case);
        let n = random.between(1, 4);
        let m = random.between(0, 7);
        let set = random.set(n, m);
        let volume = set.volume().unwrap();
        let mut whole = set.clone();
        whole.materialize();
        let columns: Vec<Vec<Dyadic>> =
            whole.generators().columns().map(|g| g.iter().map(|&x| Dyadic::from(x)).collect()).collect();
        let exact = exact_volume(&columns, n);
        assert_ne!(
            Dyadic::from(volume.lo()).cmp(&exact),
            Ordering::Greater,
            "seed {SEED}+20 case {case}: {volume:?} of {set:?}"
        );
        assert_ne!(
            Dyadic::from(volume.hi()).cmp(&exact),
            Ordering::Less,
            "seed {SEED}+20 case {case}: {volume:?} of {set:?}"
        );
        tight += usize::from(volume.width() <= 1e-12 * volume.hi());
    }
    assert!(10 * tight > 7 * total, "only {tight} of {total} volumes are known to 12 digits");
}
