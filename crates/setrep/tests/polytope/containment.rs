//! Exact points of sets lie in what the operations return: 10^5 points and more.

use setrep::{HPolytope, SetError, VPolytope};

use crate::common::dyadic::Dyadic;
use crate::common::random::Random;
use crate::samples::{ALL_ENTRIES, Entries, cases, h_polytope, points, v_polytope, weights};

const SEED: u64 = 4;

/// A point of the hull of the columns plus a corner or inner point of the remainder, exactly.
fn member(random: &mut Random, set: &VPolytope) -> Vec<Dyadic> {
    let mut point = vec![Dyadic::zero(); set.dim()];
    for (column, weight) in weights(random, set.num_vertices()) {
        for (x, &v) in point.iter_mut().zip(set.vertices().col(column)) {
            *x += &(&Dyadic::from(v) * &Dyadic::from(weight));
        }
    }
    for (x, &r) in point.iter_mut().zip(set.remainder()) {
        *x += &(&Dyadic::from(r) * &Dyadic::from(random.unit()));
    }
    point
}

/// Whether `H x <= h`, exactly.
fn lies_in(point: &[Dyadic], set: &HPolytope) -> bool {
    (0..set.num_half_spaces()).all(|i| {
        let mut sum = -Dyadic::from(set.offsets()[i]);
        for (k, x) in point.iter().enumerate() {
            sum += &(&Dyadic::from(set.normals()[(i, k)]) * x);
        }
        sum.sign().is_le()
    })
}

#[test]
fn hulls_of_points() {
    for case in 0..cases(1200) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 5);
        let m = random.between(1, 14);
        let entries = ALL_ENTRIES[case % 3];
        let remainder: Vec<f64> =
            (0..n).map(|_| if case % 2 == 0 { 0.0 } else { random.unit().abs() * 1e-3 }).collect();
        let set = VPolytope::with_remainder(points(&mut random, n, m, entries), &remainder).unwrap();
        let half_spaces = set.to_h_polytope().unwrap();
        let hull = HPolytope::from_intervals(&set.interval_hull()).unwrap();
        for _ in 0..50 {
            let point = member(&mut random, &set);
            assert!(lies_in(&point, &half_spaces), "case {case} n {n} m {m} {entries:?}");
            assert!(lies_in(&point, &hull), "case {case}");
        }
    }
}

/// From half-spaces to vertices and back: every point of the middle form lies in both ends, up to its remainder.
#[test]
fn round_trips() {
    for case in 0..cases(200) {
        let mut random = Random::new(SEED + 1, case);
        let n = random.between(2, 4);
        let extra = random.between(0, 4);
        let entries = [Entries::Coarse, Entries::Generic][case % 2];
        let set = h_polytope(&mut random, n, extra, entries);
        let vertices = set.to_v_polytope().unwrap();
        let back = vertices.to_h_polytope().unwrap();
        for _ in 0..50 {
            assert!(lies_in(&member(&mut random, &vertices), &back), "case {case}");
        }
        // The exact vertices are within the remainder of the columns: twice the remainder covers what may stick out.
        let wider: Vec<f64> = (0..set.num_half_spaces())
            .map(|i| {
                let reach: f64 = (0..n).map(|k| set.normals()[(i, k)].abs() * vertices.remainder()[k]).sum();
                (set.offsets()[i] + 2.0 * reach).next_up()
            })
            .collect();
        let wider = HPolytope::new(set.normals().clone(), &wider).unwrap();
        for v in vertices.vertices().columns() {
            assert!(lies_in(&v.iter().map(|&x| Dyadic::from(x)).collect::<Vec<_>>(), &wider), "case {case}");
        }
    }
}

#[test]
fn linear_maps() {
    for case in 0..cases(400) {
        let mut random = Random::new(SEED + 2, case);
        let (n, p) = (random.between(1, 4), random.between(1, 4));
        let m = random.between(1, 10);
        let mut set = v_polytope(&mut random, n, m, ALL_ENTRIES[case % 3]);
        if case % 2 == 0 {
            set = VPolytope::with_remainder(set.vertices().clone(), &vec![1e-9; n]).unwrap();
        }
        let map = points(&mut random, p, n, Entries::Generic);
        let image = set.linear_map(&map).unwrap();
        let half_spaces = image.to_h_polytope().unwrap();
        for _ in 0..50 {
            let x = member(&mut random, &set);
            let y: Vec<Dyadic> = (0..p)
                .map(|i| {
                    x.iter().enumerate().fold(Dyadic::zero(), |sum, (k, x)| &sum + &(&Dyadic::from(map[(i, k)]) * x))
                })
                .collect();
            assert!(lies_in(&y, &half_spaces), "case {case}");
        }
    }
}

#[test]
fn planar_sums() {
    for case in 0..cases(400) {
        let mut random = Random::new(SEED + 3, case);
        let (m, k) = (random.between(1, 9), random.between(1, 9));
        let (a, b) = (
            v_polytope(&mut random, 2, m, ALL_ENTRIES[case % 3]),
            v_polytope(&mut random, 2, k, ALL_ENTRIES[case / 3 % 3]),
        );
        let sum = a.minkowski_sum_2d(&b).unwrap();
        assert!(sum.num_vertices() <= m + k, "case {case}");
        let half_spaces = sum.to_h_polytope().unwrap();
        for _ in 0..50 {
            let (x, y) = (member(&mut random, &a), member(&mut random, &b));
            let z: Vec<Dyadic> = x.iter().zip(&y).map(|(x, y)| x + y).collect();
            assert!(lies_in(&z, &half_spaces), "case {case}");
        }
        // Support functions add, up to rounding: the sum is not larger than it must be.
        for direction in [[1.0, 0.0], [-0.3, 1.0], [0.5, -0.25], [-1.0, -1.0]] {
            let (left, right) =
                (sum.support(&direction).unwrap(), a.support(&direction).unwrap() + b.support(&direction).unwrap());
            let scale =
                1.0 + a.interval_hull().iter().chain(b.interval_hull().iter()).map(scalars::Interval::mag).sum::<f64>();
            assert!((left - right).abs() <= 1e-14 * scale, "case {case}: {left} {right}");
        }
    }
}

/// A hull cut by half-spaces holds every point of both, and none that is far from either.
#[test]
fn cut_hulls() {
    let mut inside = 0;
    for case in 0..cases(500) {
        let mut random = Random::new(SEED + 6, case);
        let n = random.between(2, 4);
        let m = random.between(2, n + 6);
        let remainder = if case % 2 == 0 { 0.0 } else { 0.01 };
        let entries = ALL_ENTRIES[case % 2];
        let hull = VPolytope::with_remainder(points(&mut random, n, m, entries), &vec![remainder; n]).unwrap();
        let (bounds, extra) = (h_polytope(&mut random, n, 0, entries), random.between(0, 3));
        let cut = h_polytope(&mut random, n, extra, entries).intersection(&bounds).unwrap();
        let both = match hull.intersection(&cut) {
            Ok(both) => both,
            Err(SetError::EmptySet) => {
                for _ in 0..50 {
                    assert!(!lies_in(&member(&mut random, &hull), &cut), "case {case}");
                }
                continue;
            }
            Err(error) => panic!("case {case}: {error}"),
        };
        let (found, other_way) =
            (both.to_h_polytope().unwrap(), hull.to_h_polytope().unwrap().intersection(&cut).unwrap());
        for _ in 0..50 {
            let point = member(&mut random, &hull);
            if lies_in(&point, &cut) {
                inside += 1;
                assert!(lies_in(&point, &found), "case {case}");
            }
        }
        if remainder == 0.0 && hull.volume().unwrap().lo() > 0.0 {
            let (left, right) = (both.interval_hull(), other_way.interval_hull().unwrap());
            for (left, right) in left.iter().zip(right.iter()) {
                assert!(
                    (left.hi() - right.hi()).abs() + (left.lo() - right.lo()).abs() < 1e-11,
                    "case {case} {left:?} {right:?}"
                );
            }
            let (left, right) = (both.volume().unwrap(), other_way.volume().unwrap());
            let (width, distance) = (left.width() + right.width(), (left.mid() - right.mid()).abs());
            assert!(distance <= width + 1e-10 * right.mid(), "case {case} {left:?} {right:?}");
        }
    }
    assert!(inside > 2000, "{inside}");
}

/// Intersections and emptied redundancy keep every point of both operands, and no other.
#[test]
fn intersections() {
    for case in 0..cases(400) {
        let mut random = Random::new(SEED + 4, case);
        let n = random.between(2, 4);
        let (a, b) = (h_polytope(&mut random, n, 3, Entries::Generic), h_polytope(&mut random, n, 3, Entries::Coarse));
        let both = a.intersection(&b).unwrap();
        let slim = both.remove_redundant().unwrap();
        for _ in 0..50 {
            let x: Vec<Dyadic> = (0..n).map(|_| Dyadic::from(random.moderate() / 2.0)).collect();
            let inside = lies_in(&x, &a) && lies_in(&x, &b);
            assert_eq!((lies_in(&x, &both), lies_in(&x, &slim)), (inside, inside), "case {case}");
        }
    }
}

/// A hull's half-space form is no larger than rounding makes it: its vertices are those of the hull.
#[test]
fn half_space_forms_are_tight() {
    for case in 0..cases(200) {
        let mut random = Random::new(SEED + 5, case);
        let n = random.between(2, 4);
        let m = n + 1 + random.below(4);
        let set = v_polytope(&mut random, n, m, Entries::Generic);
        let half_spaces = set.to_h_polytope().unwrap();
        for i in 0..half_spaces.num_half_spaces() {
            let direction: Vec<f64> = (0..n).map(|k| half_spaces.normals()[(i, k)]).collect();
            let on_it = set.vertices().columns().filter(|v| {
                let value: f64 = v.iter().zip(&direction).map(|(x, d)| x * d).sum();
                half_spaces.offsets()[i] - value <= 1e-11
            });
            assert!(on_it.count() >= n, "case {case}");
        }
    }
}
