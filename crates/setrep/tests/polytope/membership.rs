//! Three-valued membership against exact arithmetic.

use scalars::Interval;
use setrep::{HPolytope, IntervalVector, Membership, VPolytope};

use crate::common::random::Random;
use crate::oracle::{Q, facets, lies_in, q};
use crate::samples::{ALL_ENTRIES, Entries, cases, h_polytope, v_polytope};

#[test]
fn points_are_always_decided() {
    let (mut inside, mut outside) = (0, 0);
    for case in 0..cases(300) {
        let mut random = Random::new(11, case);
        let n = random.between(1, 3);
        let entries = ALL_ENTRIES[case % 3];
        let set = h_polytope(&mut random, n, 3, entries);
        let m = n + 1 + random.below(5);
        let hull = v_polytope(&mut random, n, m, Entries::Coarse);
        let (exact, _) = facets(hull.vertices());
        for _ in 0..10 {
            let x: Vec<f64> = (0..n).map(|_| random.between(0, 8) as f64 / 4.0 - 1.0).collect();
            let exact_x: Vec<Q> = x.iter().map(|&x| q(x)).collect();
            let expected = |inside| if inside { Membership::ProvenInside } else { Membership::ProvenOutside };
            let point = IntervalVector::point(&x);
            assert_eq!(set.membership(&point).unwrap(), expected(lies_in(&exact_x, &set)), "case {case}");
            let found = hull.membership(&point).unwrap();
            let holds = |facet: &Vec<Q>| crate::oracle::dot(&facet[1..], &exact_x) <= facet[0];
            if hull.volume().unwrap().lo() > 0.0 {
                assert_eq!(found, expected(exact.iter().all(holds)), "case {case}");
            }
            inside += usize::from(found == Membership::ProvenInside);
            outside += usize::from(found == Membership::ProvenOutside);
        }
        for v in hull.vertices().columns() {
            assert_eq!(hull.membership(&IntervalVector::point(v)).unwrap(), Membership::ProvenInside, "case {case}");
        }
    }
    assert!(inside > 100 && outside > 100, "{inside} {outside}");
}

#[test]
fn boxes_are_inside_outside_or_undecided() {
    let sides = IntervalVector::from_center(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let (h, v) = (HPolytope::from_intervals(&sides).unwrap(), VPolytope::from_intervals(&sides).unwrap());
    let soft = VPolytope::with_remainder(v.vertices().clone(), &[0.5, 0.5]).unwrap();
    let cases = [
        (0.5, 0.5, Membership::ProvenInside, Membership::ProvenInside),
        (0.5, 0.6, Membership::Undecided, Membership::Undecided),
        (3.0, 0.5, Membership::ProvenOutside, Membership::ProvenOutside),
        (1.25, 0.0, Membership::ProvenOutside, Membership::Undecided),
    ];
    for (center, radius, expected, with_remainder) in cases {
        let point = IntervalVector::from_center(&[center, 0.0], &[radius, 0.1]).unwrap();
        assert_eq!(h.membership(&point).unwrap(), expected, "{center}");
        assert_eq!(v.membership(&point).unwrap(), expected, "{center}");
        assert_eq!(soft.membership(&point).unwrap(), with_remainder, "{center}");
    }
}

/// On a flat set the points of its plane are inside, those one ulp off it are outside.
#[test]
fn flat_sets() {
    let columns: [&[f64]; 3] = [&[0.0, 0.0, 0.5], &[1.0, 0.0, 0.75], &[0.0, 1.0, 1.0]];
    let triangle = VPolytope::new(setrep::Matrix::from_columns(&columns).unwrap()).unwrap();
    let at = |z: f64| triangle.membership(&IntervalVector::point(&[0.25, 0.25, z])).unwrap();
    assert_eq!(at(0.6875), Membership::ProvenInside);
    assert_eq!(at(0.6875_f64.next_up()), Membership::ProvenOutside);
    let fat = IntervalVector::new(vec![Interval::point(0.25), Interval::point(0.25), Interval::new(0.6, 0.7).unwrap()]);
    assert_eq!(triangle.membership(&fat).unwrap(), Membership::Undecided);
}
