//! Containment of exact images: affine.

use setrep::Zonotope;

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{is_witness, member, sum};
use crate::common::random::{Random, cases};

#[test]
fn contains_exact_translates_and_multiples() {
    let mut stripped = 0;
    for case in 0..cases(10_000) {
        let mut random = Random::new(SEED + 5, case);
        let (n, m) = (random.between(1, 5), random.between(0, 8));
        let set = random.set(n, m);
        let point = member(&set, &mut random);

        let shift: Vec<f64> = (0..n).map(|_| random.wide()).collect();
        let mut moved = set.clone();
        moved.translate(&shift).unwrap();
        let exact_shift: Vec<Dyadic> = shift.iter().map(|&t| Dyadic::from(t)).collect();
        assert!(is_witness(&moved, &point.xi, &sum(&point.x, &exact_shift)), "seed {SEED}+5 case {case}: {set:?}");

        let style = random.below(3);
        let factor = random.entry(style);
        let mut scaled = set.clone();
        scaled.scale(factor).unwrap();
        let exact: Vec<Dyadic> = point.x.iter().map(|x| x * &Dyadic::from(factor)).collect();
        assert!(is_witness(&scaled, &point.xi, &exact), "seed {SEED}+5 case {case}: {factor} {set:?}");
        let bare = Zonotope::new(scaled.center(), scaled.generators()).unwrap();
        stripped += usize::from(set.remainder().iter().all(|&r| r == 0.0) && !is_witness(&bare, &point.xi, &exact));

        let mut whole = set.clone();
        whole.materialize();
        assert!(whole.remainder().iter().all(|&r| r == 0.0));
        let mut xi = point.xi.clone();
        xi.extend((0..n).filter(|&k| set.remainder()[k] > 0.0).map(|k| point.eta[k]));
        assert!(is_witness(&whole, &xi, &point.x), "seed {SEED}+5 case {case}: {set:?}");
    }
    assert!(stripped > 0, "no multiple needs the rounding term");
}
