//! Containment of exact images: minkowski sum.

use setrep::Zonotope;

use crate::SEED;
use crate::common::exact::{is_witness, member, sum};
use crate::common::random::{Random, cases};

#[test]
fn contains_exact_sums() {
    let (mut stripped, mut rounded) = (0, 0);
    for case in 0..cases(15_000) {
        let mut random = Random::new(SEED + 3, case);
        let (n, m, k) = (random.between(1, 5), random.between(0, 8), random.between(0, 8));
        let (a, b) = (random.set(n, m), random.set(n, k));
        let total = a.minkowski_sum(&b).unwrap();
        let (x, y) = (member(&a, &mut random), member(&b, &mut random));
        let xi = [x.xi, y.xi].concat();
        let exact = sum(&x.x, &y.x);
        assert!(is_witness(&total, &xi, &exact), "seed {SEED}+3 case {case}: {a:?} {b:?}");
        if a.remainder().iter().chain(b.remainder()).all(|&r| r == 0.0) {
            rounded += 1;
            let bare = Zonotope::new(total.center(), total.generators()).unwrap();
            stripped += usize::from(!is_witness(&bare, &xi, &exact));
        }
    }
    assert!(10 * stripped > rounded, "only {stripped} of {rounded} sums need the rounding term");
}

#[test]
fn contains_exact_products() {
    for case in 0..cases(3_000) {
        let mut random = Random::new(SEED + 4, case);
        let (n, m, k) = (random.between(1, 3), random.between(0, 5), random.between(0, 5));
        let (a, b) = (random.set(n, m), random.set(4 - n, k));
        let product = a.cartesian_product(&b);
        let (x, y) = (member(&a, &mut random), member(&b, &mut random));
        assert!(is_witness(&product, &[x.xi, y.xi].concat(), &[x.x, y.x].concat()), "seed {SEED}+4 case {case}");
    }
}

/// A noise box costs no generators, and widens the hull by exactly itself (up to rounding).
#[test]
fn a_noise_box_is_free() {
    let mut random = Random::new(SEED, 2);
    let set = Zonotope::new(&[0.5, -0.25], &random.matrix(2, 6)).unwrap();
    let noisy = set.minkowski_sum(&Zonotope::from_box(&[0.0, 0.0], &[0.125, 0.5]).unwrap()).unwrap();
    assert_eq!(noisy.num_generators(), set.num_generators());
    for (k, width) in [0.25, 1.0].into_iter().enumerate() {
        let (before, after) = (set.interval_hull()[k].width(), noisy.interval_hull()[k].width());
        assert!((after - before - width).abs() <= 1e-14 * after);
    }
}
