//! Containment of exact images: interval map.

use setrep::{IntervalMatrix, Matrix, Zonotope};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{is_mapped_witness, is_witness, member};
use crate::common::random::{Random, cases};

/// An interval matrix and the exact entries (row by row) of one of its members.
fn interval_matrix(random: &mut Random, p: usize, n: usize) -> (IntervalMatrix, Vec<Vec<Dyadic>>) {
    let mid = random.matrix(p, n);
    let mut rad = random.matrix(p, n);
    let point = random.below(4) == 0;
    rad.as_mut_slice().iter_mut().for_each(|r| *r = if point { 0.0 } else { r.abs() });
    let entries = (0..p)
        .map(|i| {
            (0..n)
                .map(|k| &Dyadic::from(mid[(i, k)]) + &(&Dyadic::from(rad[(i, k)]) * &Dyadic::from(random.unit())))
                .collect()
        })
        .collect();
    (IntervalMatrix::new(mid, rad).unwrap(), entries)
}

fn dot(a: &[Dyadic], b: impl IntoIterator<Item = Dyadic>) -> Dyadic {
    a.iter().zip(b).fold(Dyadic::zero(), |sum, (a, b)| &sum + &(a * &b))
}

#[test]
fn contains_exact_images_under_every_member() {
    let (mut stripped, mut rounded) = (0, 0);
    for case in 0..cases(20_000) {
        let mut random = Random::new(SEED + 1, case);
        let (n, m) = (random.between(1, 5), random.between(0, 8));
        let p = random.between(1, 5);
        let set = random.set(n, m);
        let (map, entries) = interval_matrix(&mut random, p, n);
        let mapped = set.interval_map(&map).unwrap();
        let member = member(&set, &mut random);
        let x: Vec<Dyadic> = entries.iter().map(|row| dot(row, member.x.iter().cloned())).collect();
        assert!(is_mapped_witness(&set, &mapped, &member, &x), "seed {SEED}+1 case {case}: {map:?} {set:?} {mapped:?}");
        if set.remainder().iter().all(|&r| r == 0.0) {
            let bare = Zonotope::new(mapped.center(), mapped.generators()).unwrap();
            rounded += 1;
            stripped += usize::from(!is_witness(&bare, &member.xi, &x));
        }
    }
    assert!(2 * stripped > rounded, "only {stripped} of {rounded} images need the remainder");
}

#[test]
fn products_contain_every_exact_product() {
    let mut stripped = 0;
    for case in 0..cases(5_000) {
        let mut random = Random::new(SEED + 2, case);
        let (p, n, q) = (random.between(1, 4), random.between(1, 4), random.between(1, 4));
        let (a, a_exact) = interval_matrix(&mut random, p, n);
        let (b, b_exact) = interval_matrix(&mut random, n, q);
        let product = a.mul(&b).unwrap();
        let sum = a.add(&a).unwrap();
        let mut needed = false;
        for i in 0..p {
            for j in 0..q {
                let exact = dot(&a_exact[i], b_exact.iter().map(|row| row[j].clone()));
                let error = (&exact - &Dyadic::from(product.mid()[(i, j)])).abs();
                assert!(error <= Dyadic::from(product.rad()[(i, j)]), "seed {SEED}+2 case {case}: {a:?} {b:?}");
                needed |= !error.is_zero();
            }
            for k in 0..n {
                let error = (&(&a_exact[i][k] + &a_exact[i][k]) - &Dyadic::from(sum.mid()[(i, k)])).abs();
                assert!(error <= Dyadic::from(sum.rad()[(i, k)]), "seed {SEED}+2 case {case}: {a:?}");
            }
        }
        stripped += usize::from(needed);
    }
    assert!(stripped > 0);
}

/// The published example of the CZ-inclusion's idea: with the set about the origin, the remainder is `R rad H`.
#[test]
fn the_remainder_is_radius_times_magnitude() {
    let set = Zonotope::from_box(&[0.0, 0.0], &[2.0, 3.0]).unwrap();
    let map = IntervalMatrix::new(Matrix::zeros(1, 2), Matrix::from_rows(&[&[0.25, 0.5]]).unwrap()).unwrap();
    let mapped = set.interval_map(&map).unwrap();
    assert!((mapped.remainder()[0] - 2.0).abs() < 1e-14 && mapped.remainder()[0] >= 2.0);
}
