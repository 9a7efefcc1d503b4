//! Strips, half-spaces and polytopes cut a bundle as they cut its constrained zonotope.

use scalars::Interval;
use setrep::{Emptiness, HPolytope, Matrix, SetError, Strip, Workspace, Zonotope, ZonotopeBundle};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::containment::{assert_member, bundle};
use crate::member::{around, dot};

#[test]
fn cuts_contain_the_exact_intersection() {
    let mut workspace = Workspace::new();
    for case in 0..cases(1_500) {
        let mut random = Random::new(SEED + 20, case);
        let (n, members, count) = (random.between(1, 3), random.between(1, 2), random.between(1, 2));
        let (mut set, x) = bundle(&mut random, n, members);
        let rows = random.matrix(count, n);
        // The member lies on the boundary, or inside.
        let ranges: Vec<Interval> = (0..count)
            .map(|i| {
                let a: Vec<f64> = rows.columns().map(|column| column[i]).collect();
                let place = around(&dot(&a, &x), 0.0, 0.0);
                match random.below(4) {
                    0 => place,
                    1 => Interval::new(place.lo(), f64::INFINITY).unwrap(),
                    2 => Interval::new(f64::NEG_INFINITY, place.hi()).unwrap(),
                    _ => place.inflate(random.wide().abs()),
                }
            })
            .collect();
        set.intersect_rows(&rows, &ranges, &mut workspace).unwrap();
        assert!(set.num_members() <= members + count);
        assert_member(&set, &x, &mut random, &mut workspace, &format!("seed {SEED}+20 case {case}"));
    }
}

#[test]
fn cuts_are_as_tight_as_those_of_constrained_zonotopes() {
    let mut workspace = Workspace::new();
    for case in 0..cases(150) {
        let mut random = Random::new(SEED + 21, case);
        let n = random.between(1, 4);
        let entries = |random: &mut Random, rows: usize, cols: usize| -> Vec<f64> {
            (0..rows * cols).map(|_| random.moderate()).collect()
        };
        let body = |random: &mut Random| {
            let generators = Matrix::from_column_slice(n, n + 2, &entries(random, n, n + 2)).unwrap();
            Zonotope::new(&vec![0.0; n], &generators).unwrap()
        };
        let mut set = ZonotopeBundle::new(vec![body(&mut random), body(&mut random)]).unwrap();
        let mut expected = set.to_constrained_zonotope().unwrap();
        let strips: Vec<Strip> = (0..3)
            .map(|_| {
                Strip::new(&entries(&mut random, 1, n), Interval::point(random.moderate() / 8.0).inflate(0.3)).unwrap()
            })
            .collect();
        set.intersect_strips(&strips, &mut workspace).unwrap();
        expected.intersect_strips(&strips, &mut workspace).unwrap();
        let d = entries(&mut random, 1, n);
        let (a, b) = (set.support(&d, &mut workspace).unwrap(), expected.support(&d, &mut workspace).unwrap());
        assert!((a - b).abs() < 1e-11, "seed {SEED}+21 case {case}: {a} against {b}, {set:?} {strips:?}");
    }
}

/// Three sides cut the square to a triangle; rows that do not cut leave no trace, and those that leave nothing prove it.
#[test]
fn a_square_cut_to_a_triangle_and_to_nothing() {
    let mut workspace = Workspace::new();
    let rows = Matrix::from_rows(&[&[1.0, 1.0], &[-1.0, 0.0], &[0.0, -1.0], &[1.0, -1.0]]).unwrap();
    let triangle = HPolytope::new(rows, &[1.0, -0.25, -0.25, 2.5]).unwrap();
    let square = ZonotopeBundle::from(Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap());
    let mut set = square.clone();
    set.intersect_h_polytope(&triangle, &mut workspace).unwrap();
    assert_eq!(set.num_members(), 4);
    for side in set.interval_hull(&mut workspace).unwrap().iter() {
        assert!((side.lo() - 0.25).abs() < 1e-13 && (side.hi() - 0.75).abs() < 1e-13, "{side}");
    }
    // Both rows reach into the triangle, but not together; a row of zeros has no point at all.
    let before = set.num_members();
    set.intersect_half_space(&[-1.0, -3.0], -2.25, &mut workspace).unwrap();
    set.intersect_strip(&[1.0, 0.0], Interval::point(0.5), &mut workspace).unwrap();
    assert_eq!(set.num_members(), before + 2);
    assert!(matches!(set.emptiness(&mut workspace).unwrap(), Emptiness::ProvenEmpty(_)));
    for (row, offset) in [([0.0, 0.0], -1.0), ([1.0, 1.0], -3.0)] {
        let mut nothing = square.clone();
        nothing.intersect_half_space(&row, offset, &mut workspace).unwrap();
        assert!(nothing.is_proven_empty(&mut workspace).unwrap(), "{nothing:?}");
        // A cut of nothing is nothing, whatever it is cut by.
        nothing.intersect_half_space(&[1.0, 0.0], 0.5, &mut workspace).unwrap();
        assert!(nothing.is_proven_empty(&mut workspace).unwrap());
    }
}

#[test]
fn bad_cuts_are_refused() {
    let mut workspace = Workspace::new();
    let mut set = ZonotopeBundle::from(Zonotope::from_box(&[0.0, 0.0], &[1.0, 1e-300]).unwrap());
    let before = set.clone();
    let half = Interval::point(0.0).inflate(0.5);
    assert!(matches!(set.intersect_strip(&[1.0], half, &mut workspace), Err(SetError::Dimension { .. })));
    assert!(matches!(set.intersect_strip(&[f64::NAN, 0.0], half, &mut workspace), Err(SetError::NonFinite { .. })));
    let ranges = [half, Interval::EMPTY];
    let refused = set.intersect_rows(&Matrix::identity(2), &ranges, &mut workspace);
    assert!(matches!(refused, Err(SetError::EmptyInterval { row: 1, .. })));
    // The first row cuts, the second asks for x_1 = 1e308 * 1e300.
    let rows = Matrix::from_rows(&[&[1.0, 0.0], &[1e-300, 0.0]]).unwrap();
    let refused = set.intersect_rows(&rows, &[half, Interval::point(1e308)], &mut workspace);
    assert!(matches!(refused, Err(SetError::Overflow { row: 1 })));
    assert_eq!(set, before);
}
