//! Intersections with rows and with other sets.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Workspace, Zonotope};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{image, times};
use crate::common::random::{Random, cases};
use crate::member::{around, assert_not_refuted, constrained, is_constrained_witness, is_extended_witness};

#[test]
fn cuts_contain_exact_intersections() {
    let mut workspace = Workspace::new();
    let (mut stripped, mut narrow_cuts) = (0, 0);
    for case in 0..cases(10_000) {
        let mut random = Random::new(SEED + 10, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 7), random.between(0, 3));
        let (set, member) = constrained(&mut random, n, m, rows);
        let count = random.between(1, 3);
        let c = random.matrix(count, n);
        let ranges: Vec<Interval> = image(&c, &member.x)
            .iter()
            .map(|value| {
                let reach = value.approx().abs() + 1e-6;
                let range = around(value, [0.0, reach][random.below(2)], [0.0, 1e-3 * reach][random.below(2)]);
                match random.below(4) {
                    0 => Interval::new(f64::NEG_INFINITY, range.hi()).unwrap(),
                    1 => Interval::new(range.lo(), f64::INFINITY).unwrap(),
                    _ => range,
                }
            })
            .collect();
        let mut cut = set.clone();
        cut.intersect_rows(&c, &ranges, &mut workspace).unwrap();
        let proven = is_extended_witness(&set, &cut, &member, &[], &member.x);
        assert!(proven, "seed {SEED}+10 case {case}: {set:?} {c:?} {ranges:?} {cut:?}");
        assert!(cut.num_generators() <= m + n && cut.num_constraints() == rows + count);
        // With the plain shifted range instead of the outward one, narrow cuts lose members.
        let narrow = ranges[0].width() <= 1e-15 * ranges[0].mag();
        if count == 1 && narrow && set.remainder().iter().all(|&r| r == 0.0) {
            let shift: f64 = (0..n).map(|k| c[(0, k)] * set.center()[k]).sum();
            let mut bare: Vec<Interval> = cut.ranges().to_vec();
            bare[rows] = Interval::new(ranges[0].lo() - shift, ranges[0].hi() - shift).unwrap();
            let bare = ConstrainedZonotope::with_constraints(cut.unconstrained(), cut.constraints(), &bare).unwrap();
            narrow_cuts += 1;
            stripped += usize::from(!is_constrained_witness(&bare, &member.xi, &member.x));
        }
    }
    assert!(
        20 * stripped > narrow_cuts && narrow_cuts > 20,
        "only {stripped} of {narrow_cuts} narrow cuts need their rounding"
    );
}

#[test]
fn generalised_intersections_contain_exact_ones() {
    let mut workspace = Workspace::new();
    for case in 0..cases(7_500) {
        let mut random = Random::new(SEED + 11, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 6), random.between(0, 3));
        let (set, member) = constrained(&mut random, n, m, rows);
        let p = random.between(1, 3);
        let map = random.matrix(p, n);
        let x = image(&map, &member.x);
        // A set around the image of the member: center = image - H eta, its rounding in the remainder.
        let k = random.between(0, 4);
        let (h, eta) = (random.matrix(p, k), random.cube(k));
        let inner = times(&h, &eta);
        let offsets: Vec<Dyadic> = x.iter().zip(&inner).map(|(x, h)| x - h).collect();
        let center: Vec<f64> = offsets.iter().map(Dyadic::approx).collect();
        let wide = random.below(2) == 0;
        let remainder: Vec<f64> = offsets
            .iter()
            .zip(&center)
            .map(|(x, &c)| around(&(x - &Dyadic::from(c)).abs(), 0.0, 0.0).hi() + if wide { c.abs() } else { 0.0 })
            .collect();
        let body = Zonotope::with_remainder(&center, &h, &remainder).unwrap();
        let a = random.matrix(1, k);
        let ranges = [around(&times(&a, &eta)[0], 0.0, 0.0)];
        let other = ConstrainedZonotope::with_constraints(&body, &a, &ranges).unwrap();
        let mut cut = set.clone();
        cut.intersect(&map, &other, &mut workspace).unwrap();
        let proven = is_extended_witness(&set, &cut, &member, &eta, &member.x);
        assert!(proven, "seed {SEED}+11 case {case}: {set:?} {map:?} {other:?} {cut:?}");
        assert_eq!(cut.num_constraints(), rows + 1 + p);
        if case % 4 == 0 {
            let context = || format!("seed {SEED}+11 case {case}: {set:?} {map:?} {other:?}");
            assert_not_refuted(&cut, &member.x, &mut random, &mut workspace, &context);
        }
    }
}

/// Two squares meet in a square: size, not only containment.
#[test]
fn intersections_have_the_right_size() {
    let mut workspace = Workspace::new();
    let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let other = ConstrainedZonotope::from_box(&[1.5, 0.5], &[1.0, 1.0]).unwrap();
    set.intersect(&Matrix::identity(2), &other, &mut workspace).unwrap();
    let hull = set.interval_hull(&mut workspace).unwrap();
    for (side, (lo, hi)) in hull.iter().zip([(0.5, 1.0), (-0.5, 1.0)]) {
        assert!((side.lo() - lo).abs() < 1e-14 && (side.hi() - hi).abs() < 1e-14, "{hull:?}");
    }
    // The box of `other` cost no generator.
    assert_eq!((set.num_generators(), set.num_constraints()), (2, 2));
    // A remainder of rounding size stays where it is.
    let body = Zonotope::with_remainder(&[0.0, 0.0], &Matrix::identity(2), &[1e-16, 1e-16]).unwrap();
    let mut thin = ConstrainedZonotope::from(body);
    thin.intersect_strip(&[1.0, 1.0], Interval::point(1.0), &mut workspace).unwrap();
    assert_eq!(thin.num_generators(), 2);
    let width = thin.interval_hull(&mut workspace).unwrap()[0].width();
    assert!((width - 1.0).abs() < 1e-14);
    // One of model size takes part exactly: the strip cuts it.
    let mut square = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    square.intersect_half_space(&[1.0, 1.0], -1.0, &mut workspace).unwrap();
    assert!((square.interval_hull(&mut workspace).unwrap()[0].hi()).abs() < 1e-14);
}
