//! Images, sums, products, translates, multiples and equivalent forms.

use setrep::{ConstrainedZonotope, IntervalMatrix, Matrix, Workspace};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{image, sum};
use crate::common::random::{Random, cases};
use crate::member::{constrained, is_constrained_witness, is_extended_witness, loosened};

fn sizes(random: &mut Random) -> (usize, usize, usize) {
    (random.between(1, 4), random.between(0, 7), random.between(0, 4))
}

#[test]
fn linear_maps_contain_exact_images() {
    for case in 0..cases(10_000) {
        let mut random = Random::new(SEED, case);
        let (n, m, rows) = sizes(&mut random);
        let (set, member) = constrained(&mut random, n, m, rows);
        assert!(is_constrained_witness(&set, &member.xi, &member.x) || set.remainder().iter().any(|&r| r > 0.0));
        let p = random.between(1, 4);
        let map = random.matrix(p, n);
        let mapped = set.linear_map(&map).unwrap();
        let x = image(&map, &member.x);
        assert!(
            is_extended_witness(&set, &mapped, &member, &[], &x),
            "seed {SEED} case {case}: {set:?} {map:?} {mapped:?}"
        );
    }
}

#[test]
fn interval_maps_contain_exact_images() {
    let mut workspace = Workspace::new();
    for case in 0..cases(7_500) {
        let mut random = Random::new(SEED + 1, case);
        let (n, m, rows) = sizes(&mut random);
        let (set, member) = constrained(&mut random, n, m, rows);
        let p = random.between(1, 4);
        let (mid, mut rad) = (random.matrix(p, n), random.matrix(p, n));
        rad.as_mut_slice().iter_mut().for_each(|r| *r = r.abs());
        let entry =
            |i: usize, k: usize, t: f64| &Dyadic::from(mid[(i, k)]) + &(&Dyadic::from(rad[(i, k)]) * &Dyadic::from(t));
        let x: Vec<Dyadic> = (0..p)
            .map(|i| (0..n).fold(Dyadic::zero(), |sum, k| &sum + &(&entry(i, k, random.unit()) * &member.x[k])))
            .collect();
        let hull = set.interval_hull(&mut workspace).unwrap();
        let mut mapped = set.clone();
        let map = IntervalMatrix::new(mid.clone(), rad.clone()).unwrap();
        mapped.interval_map_in_place(&map, &hull, &mut workspace).unwrap();
        assert!(
            is_extended_witness(&set, &mapped, &member, &[], &x),
            "seed {SEED}+1 case {case}: {set:?} {map:?} {mapped:?}"
        );
    }
}

#[test]
fn sums_and_products_contain_exact_ones() {
    for case in 0..cases(7_500) {
        let mut random = Random::new(SEED + 2, case);
        let (n, m, rows) = sizes(&mut random);
        let (a, x) = constrained(&mut random, n, m, rows);
        let (_, m, rows) = sizes(&mut random);
        let (b, y) = constrained(&mut random, n, m, rows);
        let xi = [x.xi, y.xi].concat();
        let total = a.minkowski_sum(&b).unwrap();
        assert!(is_constrained_witness(&total, &xi, &sum(&x.x, &y.x)), "sum, seed {SEED}+2 case {case}: {a:?} {b:?}");
        let product = a.cartesian_product(&b);
        assert!(
            is_constrained_witness(&product, &xi, &[x.x, y.x].concat()),
            "product, seed {SEED}+2 case {case}: {a:?} {b:?}"
        );
        assert_eq!(
            (total.num_generators(), total.num_constraints()),
            (xi.len(), a.num_constraints() + b.num_constraints())
        );
    }
}

#[test]
fn translates_multiples_and_forms_contain_exact_ones() {
    for case in 0..cases(5_000) {
        let mut random = Random::new(SEED + 3, case);
        let (n, m, rows) = sizes(&mut random);
        let (set, member) = constrained(&mut random, n, m, rows);
        let shift: Vec<f64> = (0..n).map(|_| random.wide()).collect();
        let mut moved = set.clone();
        moved.translate(&shift).unwrap();
        let x: Vec<Dyadic> = member.x.iter().zip(&shift).map(|(x, &t)| x + &Dyadic::from(t)).collect();
        assert!(is_constrained_witness(&moved, &member.xi, &x), "translate, seed {SEED}+3 case {case}");
        let factor = random.wide();
        let mut scaled = set.clone();
        scaled.scale(factor).unwrap();
        let x: Vec<Dyadic> = member.x.iter().map(|x| &Dyadic::from(factor) * x).collect();
        assert!(is_constrained_witness(&scaled, &member.xi, &x), "scale, seed {SEED}+3 case {case}");
        let mut material = set.clone();
        material.materialize();
        assert!(
            is_extended_witness(&set, &material, &member, &[], &member.x),
            "materialize, seed {SEED}+3 case {case}"
        );
        assert!(material.remainder().iter().all(|&r| r == 0.0));
    }
}

/// The CZ-inclusion over the hull is tighter than over the set without its constraints by what the constraints cut off.
#[test]
fn the_inclusion_uses_the_hull() {
    let rows = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let set = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &rows, &[1.875]).unwrap();
    let mut workspace = Workspace::new();
    let hull = set.interval_hull(&mut workspace).unwrap();
    let map = IntervalMatrix::new(Matrix::zeros(1, 2), Matrix::from_rows(&[&[0.0, 1.0]]).unwrap()).unwrap();
    let (mut mid, mut image) = (set.clone(), set.clone());
    image.interval_map_in_place(&map, &hull, &mut workspace).unwrap();
    assert!((image.remainder()[0] - 1.0).abs() < 1e-14);
    // About the middle of the hull the magnitude is the radius, 1/16.
    mid.translate(&[-0.9375, -0.9375]).unwrap();
    let hull = mid.interval_hull(&mut workspace).unwrap();
    mid.interval_map_in_place(&map, &hull, &mut workspace).unwrap();
    assert!((mid.remainder()[0] - 0.0625).abs() < 1e-14);
}

/// The textbook form of a band has a slack for its range, and the same support: at most that of either with its ranges wider by
/// the rounding of their midpoints and radii and by what a linear program may miss, 12 roundings for each of 14 variables. In case 1186
/// one rounding of a range, 1e-16 of the row, moves the support by 5e-8 of its size.
#[test]
fn textbook_forms_have_the_same_support() {
    let mut workspace = Workspace::new();
    for case in (0..cases(300)).chain([1_186]) {
        let mut random = Random::new(SEED + 4, case);
        let (set, _) = constrained(&mut random, 3, 5, 2);
        let form = set.textbook_form().unwrap();
        assert!(form.ranges().iter().all(|b| b.width() == 0.0) && form.remainder().iter().all(|&r| r == 0.0));
        let reach = set.unconstrained().radius() + set.center().iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        for d in [[1.0, 0.0, 0.0], [1.0, -1.0, 0.5], [0.0, -0.25, 1.0]] {
            let (a, b) = (set.support(&d, &mut workspace).unwrap(), form.support(&d, &mut workspace).unwrap());
            let most = [&set, &form].map(|x| loosened(x, 3e-14).support(&d, &mut workspace).unwrap());
            let alike = b.max(a) - most[0].min(most[1]) <= 1e-9 * reach;
            assert!(alike, "seed {SEED}+4 case {case}: {a} {b} {most:?} {set:?}");
        }
    }
}
