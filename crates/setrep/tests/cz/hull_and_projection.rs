//! Convex hulls, projections, slices, and the inclusion by elimination.

use scalars::Interval;
use setrep::{ConstrainedZonotope, IntervalMatrix, Matrix, SetError, Workspace};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::random::{Random, cases};
use crate::inclusion::banded;
use crate::member::{around, assert_not_refuted, constrained, is_extended_witness, loosened};

fn sizes(random: &mut Random) -> (usize, usize) {
    (random.between(0, 5), random.between(0, 3))
}

/// Exact convex combinations of exact members are not refuted; the support is the larger one, but for what linear programs may
/// miss of the rows. Of a share `l` of a set they miss `1 / l` times as much; as supports are concave in what is missed, a hull
/// loses no more than its parts together. The remainder of the hull is the larger of both.
#[test]
fn convex_hulls_contain_combinations() {
    let mut workspace = Workspace::new();
    for case in (0..cases(2_500)).chain([10_379]) {
        let mut random = Random::new(SEED + 70, case);
        let n = random.between(1, 3);
        let ((m, rows), (k, others)) = (sizes(&mut random), sizes(&mut random));
        let (a, x) = constrained(&mut random, n, m, rows);
        let (b, y) = constrained(&mut random, n, k, others);
        let hull = a.convex_hull(&b).unwrap();
        let weight = [0.0, 1.0, 0.5, 0.3][random.below(4)];
        let rest = &Dyadic::from(1.0) - &Dyadic::from(weight);
        let z: Vec<Dyadic> = x.x.iter().zip(&y.x).map(|(x, y)| &(&Dyadic::from(weight) * x) + &(&rest * y)).collect();
        let context = || format!("seed {SEED}+70 case {case}: weight {weight} {a:?} {b:?} {hull:?}");
        assert_not_refuted(&hull, &z, &mut random, &mut workspace, &context);
        let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let supports = [&a, &b, &hull].map(|set| set.support(&d, &mut workspace).unwrap());
        let losses = [&a, &b].map(|set| loosened(set, 1e-13).support(&d, &mut workspace).unwrap());
        let reach = |set: &ConstrainedZonotope| {
            let body = set.unconstrained().interval_hull();
            body.iter().map(Interval::mag).fold(0.0, f64::max)
        };
        let size = reach(&a) + reach(&b);
        let parts = losses[0] - supports[0] + losses[1] - supports[1];
        let remainder: f64 = d.iter().zip(hull.remainder()).map(|(d, r)| d.abs() * r).sum();
        let loss = supports[2] - supports[0].max(supports[1]) - parts - remainder;
        assert!(
            loss <= 1e-9 * size,
            "wider by {loss:e} of {size:e} along {d:?}, {supports:?}, {losses:?}: {}",
            context()
        );
    }
}

/// Two squares side by side span a rectangle; a square and a point the shape of an envelope; a set and an empty set the set.
#[test]
fn convex_hulls_have_the_right_size() {
    let mut workspace = Workspace::new();
    let square = |x: f64| ConstrainedZonotope::from_box(&[x, 0.0], &[1.0, 1.0]).unwrap();
    let volume = |set: &ConstrainedZonotope| set.to_h_polytope().unwrap().volume().unwrap().mid();
    assert!((volume(&square(-2.0).convex_hull(&square(2.0)).unwrap()) - 12.0).abs() < 1e-9);
    let point = ConstrainedZonotope::from_box(&[4.0, 0.0], &[0.0, 0.0]).unwrap();
    let envelope = square(0.0).convex_hull(&point).unwrap();
    assert!((volume(&envelope) - 7.0).abs() < 1e-9);
    assert_eq!(envelope.num_generators(), 3);
    let mut empty = square(10.0);
    empty.intersect_half_space(&[1.0, 1.0], 5.0, &mut workspace).unwrap();
    assert!(empty.is_proven_empty(&mut workspace).unwrap());
    let hull = empty.convex_hull(&square(0.0)).unwrap().interval_hull(&mut workspace).unwrap();
    assert!(hull[0].hi() < 1.0 + 1e-12, "{hull:?}");
}

#[test]
fn projections_are_exact() {
    for case in 0..cases(2_000) {
        let mut random = Random::new(SEED + 71, case);
        let n = random.between(1, 5);
        let (m, rows) = sizes(&mut random);
        let (set, member) = constrained(&mut random, n, m, rows);
        let mut kept: Vec<usize> = (0..n).filter(|_| random.below(2) == 0).collect();
        kept.reverse();
        if kept.is_empty() {
            kept.push(random.below(n));
        }
        let image = set.project(&kept).unwrap();
        let x: Vec<Dyadic> = kept.iter().map(|&k| member.x[k].clone()).collect();
        assert!(is_extended_witness(&set, &image, &member, &[], &x), "seed {SEED}+71 case {case}");
        for (i, &k) in kept.iter().enumerate() {
            assert!(image.center()[i] == set.center()[k] && image.remainder()[i] == set.remainder()[k]);
        }
    }
    let set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    assert!(matches!(set.project(&[]), Err(SetError::ZeroDimension { .. })));
    assert!(matches!(set.project(&[0, 2]), Err(SetError::NoSuchCoordinate { index: 2, dim: 2 })));
}

#[test]
fn slices_contain_members_with_those_values() {
    let mut workspace = Workspace::new();
    for case in 0..cases(2_000) {
        let mut random = Random::new(SEED + 72, case);
        let n = random.between(2, 4);
        let (m, rows) = sizes(&mut random);
        let (set, member) = constrained(&mut random, n, m, rows);
        let fixed = random.below(n);
        let range = around(&member.x[fixed], 0.0, 0.0);
        let slice = set.slice(&[fixed], &[range], &mut workspace).unwrap();
        let x: Vec<Dyadic> = (0..n).filter(|&k| k != fixed).map(|k| member.x[k].clone()).collect();
        let context = || format!("seed {SEED}+72 case {case}: {set:?} {fixed} {range:?} {slice:?}");
        assert_eq!((slice.dim(), slice.num_constraints()), (n - 1, rows + 1));
        assert_not_refuted(&slice, &x, &mut random, &mut workspace, &context);
    }
    let set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let ranges = [Interval::ZERO; 2];
    assert!(matches!(set.slice(&[0, 1], &ranges, &mut workspace), Err(SetError::ZeroDimension { .. })));
    assert!(matches!(set.slice(&[0], &ranges, &mut workspace), Err(SetError::Dimension { .. })));
    assert!(matches!(set.slice(&[5], &ranges[..1], &mut workspace), Err(SetError::NoSuchCoordinate { .. })));
}

/// The paper's inclusion contains exact images.
#[test]
fn inclusions_by_elimination_contain_images() {
    let mut workspace = Workspace::new();
    for case in 0..cases(2_000) {
        let mut random = Random::new(SEED + 73, case);
        let n = random.between(1, 4);
        let (m, rows) = (random.between(0, 7), random.between(0, 4));
        let (set, member) = constrained(&mut random, n, m, rows);
        let p = random.between(1, 3);
        let (mid, mut rad) = (random.matrix(p, n), random.matrix(p, n));
        rad.as_mut_slice().iter_mut().for_each(|r| *r = r.abs());
        let x: Vec<Dyadic> = (0..p)
            .map(|i| {
                (0..n).fold(Dyadic::zero(), |sum, k| {
                    let shift = &Dyadic::from(rad[(i, k)]) * &Dyadic::from(random.unit());
                    &sum + &(&(&Dyadic::from(mid[(i, k)]) + &shift) * &member.x[k])
                })
            })
            .collect();
        let map = IntervalMatrix::new(mid, rad).unwrap();
        let mut by_elimination = set.clone();
        by_elimination.interval_map_by_elimination_in_place(&map, &mut workspace).unwrap();
        let proven = is_extended_witness(&set, &by_elimination, &member, &[], &x);
        assert!(proven, "seed {SEED}+73 case {case}: {set:?} {map:?} {by_elimination:?}");
    }
}

/// `P` of the paper is never below that of the hull, and often well above it.
#[test]
fn inclusions_over_the_hull_are_narrower() {
    let mut workspace = Workspace::new();
    let mut strictly = 0;
    for case in 0..cases(500) {
        let mut random = Random::new(SEED + 74, case);
        let n = random.between(1, 3);
        let set = banded(&mut random, n, 6, 3);
        let map = IntervalMatrix::new(Matrix::identity(n), Matrix::identity(n)).unwrap();
        let hull = set.interval_hull(&mut workspace).unwrap();
        let (mut by_hull, mut by_elimination) = (set.clone(), set.clone());
        by_hull.interval_map_in_place(&map, &hull, &mut workspace).unwrap();
        by_elimination.interval_map_by_elimination_in_place(&map, &mut workspace).unwrap();
        for (narrow, wide) in by_hull.remainder().iter().zip(by_elimination.remainder()) {
            assert!(*narrow <= wide * (1.0 + 1e-9), "seed {SEED}+74 case {case}: {narrow} {wide} {set:?}");
            strictly += usize::from(*narrow < 0.9 * wide);
        }
    }
    assert!(strictly > cases(500) / 4, "{strictly}");
}
