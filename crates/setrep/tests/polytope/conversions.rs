//! Random polytopes against brute force: counts, enclosures of every vertex, normals of every facet, volumes.

use num_traits::Signed;
use scalars::Interval;
use setrep::{Feasibility, SetError};

use crate::common::random::Random;
use crate::oracle::{self, Q, float, q};
use crate::samples::{ALL_ENTRIES, Entries, cases, h_polytope, v_polytope};

const SEED: u64 = 20_261_122;

/// Polytopes for one dimension: half-spaces beside the box, or points beside a simplex.
const SIZES: [(usize, usize, usize); 5] = [(2, 40, 7), (3, 20, 5), (4, 6, 3), (5, 2, 1), (6, 1, 0)];

/// `lo <= x <= hi`, and the middle within `1e-12 x`.
pub(crate) fn assert_encloses(volume: Interval, exact: &Q) {
    assert!(q(volume.lo()) <= *exact && *exact <= q(volume.hi()), "{volume:?} misses {}", float(exact));
    assert!((q(volume.mid()) - exact).abs() <= exact * q(1e-12), "{volume:?} is far from {}", float(exact));
}

#[test]
fn every_vertex_is_found_once_and_enclosed() {
    for (n, count, extra) in SIZES {
        for case in 0..cases(count) {
            for entries in ALL_ENTRIES {
                let mut random = Random::new(SEED, 1000 * n + case);
                let extra = random.between(0, extra);
                let set = h_polytope(&mut random, n, extra, entries);
                let exact = oracle::vertices(&set);
                let vertices = set.to_v_polytope().unwrap();
                assert_eq!(vertices.num_vertices(), exact.len(), "n {n} case {case} {entries:?}");
                assert!(oracle::match_columns(&exact, &vertices), "n {n} case {case} {entries:?}");
                let (volume, again) = (set.volume().unwrap(), vertices.volume().unwrap());
                assert!(!volume.disjoint(&again) && volume.lo() > 0.0, "n {n} case {case} {entries:?}");
                assert!(
                    volume.width().max(again.width()) <= 1e-10 * volume.hi(),
                    "n {n} case {case} {volume:?} {again:?}"
                );
                for k in 0..n {
                    let extent = vertices.vertices().columns().map(|v| v[k].abs()).fold(0.0, f64::max);
                    assert!(vertices.remainder()[k] <= 1e-15 * extent, "loose: n {n} case {case} {entries:?}");
                }
                // Dropping any row that was kept changes the set; the dropped ones do not.
                let slim = set.remove_redundant().unwrap();
                assert_eq!(oracle::vertices(&slim), exact);
                let facets = oracle::half_spaces(&slim);
                for (a, b) in &facets {
                    let tight: Vec<&Vec<Q>> = exact.iter().filter(|x| oracle::dot(a, x) == *b).collect();
                    assert!(tight.len() >= n, "a row that is no facet: n {n} case {case} {entries:?}");
                }
                assert!(matches!(set.emptiness().unwrap(), Feasibility::ProvenNonEmpty { .. }));
                let (center, radius) = set.interior_point().unwrap();
                assert!(radius > 0.0, "n {n} case {case} {entries:?}");
                for (i, &offset) in set.offsets().iter().enumerate() {
                    let a: Vec<Q> = (0..n).map(|k| q(set.normals()[(i, k)])).collect();
                    let slack = q(offset) - oracle::dot(&a, &center.iter().map(|&x| q(x)).collect::<Vec<_>>());
                    assert!(slack.is_positive() && &slack * &slack >= oracle::dot(&a, &a) * q(radius) * q(radius));
                }
            }
        }
    }
}

#[test]
fn every_facet_is_found_once_and_contains_the_points() {
    for (n, count, extra) in SIZES {
        for case in 0..cases(count) {
            for entries in ALL_ENTRIES {
                let mut random = Random::new(SEED, 1000 * n + case);
                let m = n + 1 + random.between(0, extra + 2);
                let set = v_polytope(&mut random, n, m, entries);
                let (exact, sum) = oracle::facets(set.vertices());
                if exact.is_empty() {
                    continue; // flat by coincidence of coarse entries
                }
                let half_spaces = set.to_h_polytope().unwrap();
                if exact.len() != half_spaces.num_half_spaces() {
                    // Flat sets: the brute force finds other hyperplanes, the library pairs of opposite half-spaces.
                    assert!(
                        entries == Entries::Coarse && set.volume().unwrap() == Interval::ZERO,
                        "n {n} case {case} {entries:?}"
                    );
                    continue;
                }
                for v in set.vertices().columns() {
                    let point: Vec<Q> = v.iter().map(|&x| q(x)).collect();
                    assert!(oracle::lies_in(&point, &half_spaces), "n {n} case {case} {entries:?}");
                }
                for facet in &exact {
                    let normal: Vec<f64> = facet[1..].iter().map(float).collect();
                    let near = |i: usize| {
                        let row: Vec<f64> = (0..n).map(|k| half_spaces.normals()[(i, k)]).collect();
                        let length: f64 = row.iter().copied().map(f64::abs).sum();
                        (0..n).all(|k| (row[k] / length - normal[k]).abs() <= 1e-9)
                    };
                    assert_eq!((0..exact.len()).filter(|&i| near(i)).count(), 1, "n {n} case {case} {entries:?}");
                }
                if entries != Entries::Coarse {
                    assert_encloses(set.volume().unwrap(), &(sum * oracle::inverse_factorial(n)));
                }
                let slim = set.remove_redundant().unwrap();
                assert_eq!(oracle::facets(slim.vertices()).0, exact, "n {n} case {case} {entries:?}");
                if slim.num_vertices() > n + 1 && case < 4 {
                    let fewer =
                        setrep::Matrix::from_columns(&slim.vertices().columns().skip(1).collect::<Vec<_>>()).unwrap();
                    assert_ne!(
                        oracle::facets(&fewer).0,
                        exact,
                        "a column that is no vertex: n {n} case {case} {entries:?}"
                    );
                }
            }
        }
    }
}

/// Half-spaces without the box: unbounded, bounded or empty, whatever comes; the verdict is the brute force's.
#[test]
fn emptiness_is_decided() {
    let (mut empty, mut unbounded, mut bounded) = (0, 0, 0);
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 1, case);
        let n = random.between(1, 3);
        let m = random.between(n, n + 4);
        let coarse = case % 2 == 0;
        let entry = |random: &mut Random| if coarse { random.between(0, 4) as f64 - 2.0 } else { random.moderate() };
        let data: Vec<f64> = (0..n * m).map(|_| entry(&mut random)).collect();
        let offsets: Vec<f64> = (0..m).map(|_| entry(&mut random)).collect();
        let set = setrep::HPolytope::new(setrep::Matrix::from_column_slice(m, n, &data).unwrap(), &offsets).unwrap();
        // A large box cuts off no vertex of these, so it tells empty sets from others.
        let sides = vec![Interval::new(-1e12, 1e12).unwrap(); n];
        let boxed = set.intersection(&setrep::HPolytope::from_intervals(&sides).unwrap()).unwrap();
        let exact = oracle::vertices(&boxed);
        match set.to_v_polytope() {
            Ok(vertices) => {
                bounded += 1;
                assert_eq!(vertices.num_vertices(), exact.len(), "case {case}");
            }
            Err(SetError::Unbounded) => {
                unbounded += 1;
                assert!(exact.iter().any(|x| x.iter().any(|x| x.abs() >= q(1e11))), "case {case}");
                assert_eq!(set.emptiness().unwrap(), Feasibility::ProvenUnbounded);
            }
            Err(SetError::EmptySet) => {
                empty += 1;
                assert!(exact.is_empty(), "case {case}");
                let Feasibility::ProvenEmpty { rows } = set.emptiness().unwrap() else { panic!("case {case}") };
                assert!(rows.len() <= n + 1, "case {case}");
                let mut normals = setrep::Matrix::zeros(rows.len(), n);
                for (i, &row) in rows.iter().enumerate() {
                    for k in 0..n {
                        normals[(i, k)] = set.normals()[(row, k)];
                    }
                }
                let few: Vec<f64> = rows.iter().map(|&i| offsets[i]).collect();
                let few = setrep::HPolytope::new(normals, &few).unwrap();
                let boxed = few.intersection(&setrep::HPolytope::from_intervals(&sides).unwrap()).unwrap();
                assert!(oracle::vertices(&boxed).is_empty(), "a wrong certificate: case {case}");
            }
            Err(error) => panic!("case {case}: {error}"),
        }
    }
    assert!(empty > 10 && unbounded > 10 && bounded > 10, "{empty} {unbounded} {bounded}");
}
