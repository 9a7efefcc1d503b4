//! Sets with fewer columns, without a remainder, cut by values: supersets, exactly, and not much larger.

use num_traits::{Signed, Zero};
use scalars::Interval;
use setrep::{HPolytope, Matrix, SetError, VPolytope, Workspace};

use crate::common::random::Random;
use crate::oracle::{Q, dot, facets, q};
use crate::samples::{ALL_ENTRIES, Entries, cases, points, v_polytope, weights};

const SEED: u64 = 52;

/// The facets `(b, a)` of the hull of some columns, none for a flat one.
fn full_facets(columns: &Matrix) -> Vec<Vec<Q>> {
    if columns.cols() <= columns.rows() {
        return Vec::new();
    }
    let (facets, size) = facets(columns);
    if size.is_zero() { Vec::new() } else { facets }
}

/// By how much a point is beyond a facet that is moved outward by a box.
fn excess(facet: &[Q], x: &[Q], lengths: &[f64]) -> Q {
    let reach = facet[1..].iter().zip(lengths).fold(facet[0].clone(), |sum, (a, &r)| sum + a.abs() * q(r));
    dot(&facet[1..], x) - reach
}

fn exact(x: &[f64]) -> Vec<Q> {
    x.iter().map(|&x| q(x)).collect()
}

#[test]
fn dropped_columns_lie_within_the_remainder() {
    for case in 0..cases(60) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 3);
        let m = random.between(1, 12);
        let set = v_polytope(&mut random, n, m, ALL_ENTRIES[case % 3]);
        let share = [0.0, 1e-12, 1e-3, 0.2][random.below(4)];
        let thin = set.thinned(share);
        let hull = set.interval_hull();
        assert!(thin.num_vertices() <= m);
        for (k, &r) in thin.remainder().iter().enumerate() {
            assert!(r <= share * hull[k].width() + 1e-14 * hull[k].mag(), "case {case}: {r:e}");
        }
        for facet in full_facets(thin.vertices()) {
            for v in set.vertices().columns() {
                assert!(!excess(&facet, &exact(v), thin.remainder()).is_positive(), "case {case}");
            }
        }
    }
}

/// Points in general position lose those inside and no vertex; grids and points near a facet leave their corners.
#[test]
fn the_vertices_are_kept_and_only_they() {
    for case in 0..cases(100) {
        let mut random = Random::new(SEED + 1, case);
        let n = random.between(1, 4);
        let m = random.between(n + 2, 24);
        let set = v_polytope(&mut random, n, m, Entries::Generic);
        assert_eq!(set.thinned(0.0).num_vertices(), set.remove_redundant().unwrap().num_vertices(), "case {case}");
    }
    for n in 1..=4_usize {
        // Corners and middles of a cube, turned so that nothing is a float: 3^n points.
        let mut grid = Matrix::zeros(n, 0);
        for code in 0..3_usize.pow(n as u32) {
            let z: Vec<f64> = (0..n).map(|k| (code / 3_usize.pow(k as u32) % 3) as f64 / 3.0).collect();
            let x: Vec<f64> = (0..n).map(|k| 0.6 * z[k] - 0.8 * z[(k + 1) % n] + 0.1 * z[0]).collect();
            grid.push_col(&x).unwrap();
        }
        let thin = VPolytope::new(grid).unwrap().thinned(1e-13);
        assert_eq!(thin.num_vertices(), 1 << n, "{n}");
        assert!(thin.remainder().iter().all(|&r| r < 4e-15), "{:?}", thin.remainder());
    }
}

/// A flat set, a segment, a point, duplicates.
#[test]
fn flat_sets_are_thinned_as_well() {
    let mut plane = Matrix::zeros(3, 0);
    for k in 0..25 {
        let (s, t) = (f64::from(k % 5), f64::from(k / 5));
        plane.push_col(&[s, t, 0.5 * s - 0.25 * t]).unwrap();
    }
    assert_eq!(VPolytope::new(plane).unwrap().thinned(1e-12).num_vertices(), 4);
    let line: Vec<f64> = (0..9).flat_map(|k| [f64::from(k) * 0.1, 1.0 - f64::from(k) * 0.3]).collect();
    let line = VPolytope::new(Matrix::from_column_slice(2, 9, &line).unwrap()).unwrap().thinned(1e-12);
    assert_eq!(line.num_vertices(), 2);
    let same = VPolytope::new(Matrix::from_column_slice(2, 3, &[0.1, 0.2, 0.1, 0.2, 0.1, 0.2]).unwrap()).unwrap();
    assert_eq!((same.thinned(0.0).num_vertices(), same.thinned(0.0).remainder()), (1, &[0.0, 0.0][..]));
    let huge = VPolytope::new(Matrix::from_columns(&[&[f64::MAX, 0.0], &[-f64::MAX, 1.0]]).unwrap()).unwrap();
    assert_eq!(huge.thinned(f64::NAN), huge);
}

/// `conv V + [-r, r]` fulfils every facet of the new hull, exactly.
#[test]
fn absorbed_remainders_are_in_the_hull() {
    let mut absorbed = 0;
    for case in 0..cases(60) {
        let mut random = Random::new(SEED + 2, case);
        let n = random.between(1, 3);
        let m = random.between(n + 1, 10);
        let columns = points(&mut random, n, m, ALL_ENTRIES[case % 3]);
        let size = [1e-17, 1e-12, 1e-6, 1e-3][random.below(4)];
        let widths: Vec<f64> =
            VPolytope::new(columns.clone()).unwrap().interval_hull().iter().map(Interval::width).collect();
        let remainder: Vec<f64> = widths.iter().map(|w| size * w * random.moderate().abs()).collect();
        let set = VPolytope::with_remainder(columns, &remainder).unwrap();
        let hull = set.absorb_remainder();
        if hull.remainder().iter().any(|&r| r != 0.0) {
            assert_eq!(hull, set);
            continue;
        }
        absorbed += 1;
        assert_eq!(hull.num_vertices(), m);
        for facet in full_facets(hull.vertices()) {
            for v in set.vertices().columns() {
                let reach = facet[1..].iter().zip(&remainder).fold(Q::zero(), |sum, (a, &r)| sum + a.abs() * q(r));
                assert!(dot(&facet[1..], &exact(v)) + reach <= facet[0], "case {case}");
            }
        }
    }
    assert!(absorbed >= cases(60) / 2, "{absorbed}");
    // A triangle grows by what it must, about.
    let triangle = Matrix::from_columns(&[&[0.0, 0.0], &[3.0, 0.0], &[0.0, 3.0]]).unwrap();
    let grown = VPolytope::with_remainder(triangle, &[1e-9, 1e-9]).unwrap().absorb_remainder();
    assert!(grown.volume().unwrap().mid() < 4.5 + 2e-8);
    let flat =
        VPolytope::with_remainder(Matrix::from_columns(&[&[0.0, 0.0], &[1.0, 1.0]]).unwrap(), &[1e-9, 0.0]).unwrap();
    assert_eq!(flat.absorb_remainder(), flat);
}

/// Combinations with exact weights whose values combine to less than the level stay.
#[test]
fn combinations_below_the_level_are_kept() {
    let mut kept = 0;
    for case in 0..cases(40) {
        let mut random = Random::new(SEED + 3, case);
        let n = random.between(1, 3);
        let m = random.between(n + 1, 9);
        let set = v_polytope(&mut random, n, m, ALL_ENTRIES[case % 3]);
        let values: Vec<f64> = (0..m).map(|_| random.moderate()).collect();
        let level = 0.3 * random.moderate();
        let cut = match set.cut_by_values(&values, level, 1e-12) {
            Ok(cut) => cut,
            Err(error) => {
                assert!(error == SetError::EmptySet && values.iter().all(|&a| a > level), "case {case}: {error}");
                continue;
            }
        };
        let facets = full_facets(cut.vertices());
        for _ in 0..20 {
            let weights = weights(&mut random, m);
            let value = weights.iter().fold(Q::zero(), |sum, &(j, w)| sum + q(w) * q(values[j]));
            if value > q(level) {
                continue;
            }
            let x: Vec<Q> = (0..n)
                .map(|k| weights.iter().fold(Q::zero(), |sum, &(j, w)| sum + q(w) * q(set.vertices()[(k, j)])))
                .collect();
            assert!(facets.iter().all(|facet| !excess(facet, &x, cut.remainder()).is_positive()), "case {case}");
            kept += 1;
        }
    }
    assert!(kept > cases(80));
}

/// With the values of a linear function the cut is the intersection with a half-space.
#[test]
fn linear_values_cut_like_half_spaces() {
    for case in 0..cases(60) {
        let mut random = Random::new(SEED + 4, case);
        let n = random.between(2, 4);
        let set = v_polytope(&mut random, n, 12, Entries::Generic);
        let normal: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let level = 0.2 * random.moderate();
        let values: Vec<f64> =
            set.vertices().columns().map(|v| v.iter().zip(&normal).map(|(x, a)| x * a).sum()).collect();
        let half_space = HPolytope::new(Matrix::from_rows(&[&normal]).unwrap(), &[level]).unwrap();
        match (set.cut_by_values(&values, level, 1e-12), set.intersection(&half_space)) {
            (Ok(cut), Ok(exact)) => {
                let (cut, volume) = (cut.volume().unwrap().mid(), exact.volume().unwrap().mid());
                assert!((cut - volume).abs() <= 1e-9 * (1.0 + volume), "case {case}: {cut} {volume}");
            }
            (Err(error), Err(other)) => assert_eq!(error, other),
            (cut, exact) => panic!("case {case}: {cut:?} {exact:?}"),
        }
    }
}

#[test]
fn outer_polytopes_have_few_vertices() {
    let mut workspace = Workspace::new();
    for case in 0..cases(40) {
        let mut random = Random::new(SEED + 5, case);
        let n = random.between(1, 4);
        let m = [4, 30, 60, 120][n - 1];
        let set = v_polytope(&mut random, n, m, ALL_ENTRIES[case % 2]);
        let limit = (1 << n) + random.below(20);
        let outer = set.enclosed_within(limit, &mut workspace).unwrap();
        assert!(outer.num_vertices() <= limit, "case {case}: {} {limit}", outer.num_vertices());
        for _ in 0..20 {
            let direction: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
            let (inner, outer) = (set.support(&direction).unwrap(), outer.support(&direction).unwrap());
            assert!(outer >= inner - 1e-15, "case {case}: {inner} {outer}");
        }
        let hull = set.interval_hull();
        let outer = outer.interval_hull();
        assert!(
            hull.iter().zip(outer.iter()).all(|(a, b)| a.subset_of(b) && b.width() <= a.width() + 1e-9),
            "case {case}"
        );
    }
    let square = v_polytope(&mut Random::new(1, 1), 2, 9, Entries::Generic);
    assert_eq!(square.enclosed_within(3, &mut workspace), Err(SetError::OverBudget { count: 4, limit: 3 }));
}
