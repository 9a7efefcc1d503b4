//! Flat sets, duplicates, single points, huge and tiny scales, far-away sets.

use scalars::Interval;
use setrep::{Feasibility, HPolytope, IntervalVector, Matrix, Membership, VPolytope};

use crate::common::random::Random;
use crate::oracle::{Q, lies_in, q};
use crate::samples::{Entries, points};

#[test]
fn a_single_point() {
    for n in 1..=6 {
        let x: Vec<f64> = (0..n).map(|k| 0.1 + k as f64).collect();
        let set = VPolytope::new(Matrix::from_columns(&[&x, &x, &x]).unwrap()).unwrap();
        assert_eq!(set.remove_redundant().unwrap().num_vertices(), 1);
        assert_eq!(set.volume().unwrap(), Interval::ZERO);
        let half_spaces = set.to_h_polytope().unwrap();
        assert_eq!(half_spaces.num_half_spaces(), 2 * n);
        assert_eq!(half_spaces.interval_hull().unwrap(), IntervalVector::point(&x));
        assert_eq!(set.membership(&IntervalVector::point(&x)).unwrap(), Membership::ProvenInside);
    }
}

/// Hulls of `k + 1` and more points within a `k`-dimensional integer subspace of `R^n`.
#[test]
fn flat_hulls() {
    for case in 0..60 {
        let mut random = Random::new(21, case);
        let n = random.between(2, 5);
        let k = random.between(1, n - 1);
        let low = points(&mut random, k, k + 4, Entries::Coarse);
        let data: Vec<f64> = (0..n * k).map(|_| random.between(0, 6) as f64 - 3.0).collect();
        let map = Matrix::from_column_slice(n, k, &data).unwrap();
        let set = VPolytope::new(low).unwrap().linear_map(&map).unwrap();
        assert_eq!(set.remainder(), vec![0.0; n], "small numbers are exact");
        assert_eq!(set.volume().unwrap(), Interval::ZERO, "case {case}");
        let half_spaces = set.to_h_polytope().unwrap();
        for v in set.vertices().columns() {
            assert!(lies_in(&v.iter().map(|&x| q(x)).collect::<Vec<Q>>(), &half_spaces), "case {case}");
        }
        // No direction is left open, and the bounds are tight.
        let (hull, expected) = (half_spaces.interval_hull().unwrap(), set.interval_hull());
        for (found, exact) in hull.iter().zip(expected.iter()) {
            assert!(exact.subset_of(found) && found.subset_of(&exact.inflate(1e-9)), "case {case} {found:?} {exact:?}");
        }
    }
}

#[test]
fn flat_half_spaces() {
    // The square 0 <= x, y <= 1 in the plane z = 1/3 (rounded), each equation a pair of rows.
    let third = 1.0 / 3.0;
    let rows: [&[f64]; 6] =
        [&[1.0, 0.0, 0.0], &[-1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, -1.0, 0.0], &[0.0, 0.0, 1.0], &[0.0, 0.0, -1.0]];
    let set = HPolytope::new(Matrix::from_rows(&rows).unwrap(), &[1.0, 0.0, 1.0, 0.0, third, -third]).unwrap();
    let vertices = set.to_v_polytope().unwrap();
    assert_eq!((vertices.num_vertices(), vertices.remainder()), (4, &[0.0; 3][..]));
    assert_eq!(set.volume().unwrap(), Interval::ZERO);
    assert_eq!(set.remove_redundant().unwrap().to_v_polytope().unwrap().num_vertices(), 4);
    // One ulp apart the wrong way: empty, and two rows say why.
    let apart =
        HPolytope::new(Matrix::from_rows(&rows).unwrap(), &[1.0, 0.0, 1.0, 0.0, third, -third.next_up()]).unwrap();
    assert_eq!(apart.emptiness().unwrap(), Feasibility::ProvenEmpty { rows: vec![4, 5] });
    // One ulp apart the other way: a slab of that thickness.
    let slab =
        HPolytope::new(Matrix::from_rows(&rows).unwrap(), &[1.0, 0.0, 1.0, 0.0, third, -third.next_down()]).unwrap();
    assert_eq!(slab.to_v_polytope().unwrap().num_vertices(), 8);
    assert!(slab.volume().unwrap().contains(third - third.next_down()));
}

#[test]
fn duplicates_and_inner_points_change_nothing() {
    for n in 2..=5 {
        let corners = VPolytope::from_intervals(&vec![Interval::new(-1.0, 1.0).unwrap(); n]).unwrap();
        let mut vertices = corners.vertices().clone();
        for j in 0..corners.num_vertices() {
            vertices.push_col(corners.vertices().col(j)).unwrap();
            let half: Vec<f64> = corners.vertices().col(j).iter().map(|x| x / 2.0).collect();
            vertices.push_col(&half).unwrap();
        }
        // Centres of facets and edges lie on the boundary but are no vertices.
        let mut middle = corners.vertices().col(0).to_vec();
        middle[0] = 0.0;
        vertices.push_col(&middle).unwrap();
        let set = VPolytope::new(vertices).unwrap();
        assert_eq!(set.to_h_polytope().unwrap().num_half_spaces(), 2 * n);
        assert_eq!(set.remove_redundant().unwrap().num_vertices(), 1 << n);
        assert!(set.volume().unwrap().contains(f64::from(1 << n)));
    }
}

#[test]
fn scales_of_all_sizes() {
    for scale in [1e-300, 1e-150, 1e-20, 1e20, 1e150, 1e300] {
        let sides = vec![
            Interval::new(-scale, 0.5 * scale).unwrap(),
            Interval::new(-1.0, 2.0).unwrap(),
            Interval::new(0.0, 3.0 * scale).unwrap(),
        ];
        let corners = VPolytope::from_intervals(&sides).unwrap();
        let half_spaces = corners.to_h_polytope().unwrap();
        assert_eq!(half_spaces.num_half_spaces(), 6, "{scale}");
        assert_eq!(half_spaces.interval_hull().unwrap(), IntervalVector::new(sides.clone()), "{scale}");
        let oblique = corners
            .linear_map(&Matrix::from_rows(&[&[1.0, scale, 0.0], &[0.0, 1.0, 0.0], &[0.5, 0.0, 1.0]]).unwrap())
            .unwrap();
        let half_spaces = oblique.to_h_polytope().unwrap();
        for v in oblique.vertices().columns() {
            assert!(lies_in(&v.iter().map(|&x| q(x)).collect::<Vec<Q>>(), &half_spaces), "{scale}");
        }
    }
}

/// A small polytope far from the origin keeps its facets, and each is tight.
#[test]
fn far_away_sets() {
    let mut random = Random::new(5, 0);
    let near = points(&mut random, 3, 12, Entries::Coarse);
    let mut far = near.clone();
    for x in far.as_mut_slice() {
        *x += 2f64.powi(40);
    }
    let (near, far) = (VPolytope::new(near).unwrap(), VPolytope::new(far).unwrap());
    assert_eq!(near.to_h_polytope().unwrap().num_half_spaces(), far.to_h_polytope().unwrap().num_half_spaces());
    let (a, b) = (near.volume().unwrap(), far.volume().unwrap());
    assert!(!a.disjoint(&b) && b.width() < 1e-10, "{a:?} {b:?}");
}

/// Rotated boxes are degenerate but for rounding: many nearly equal facets, and a hull that is no larger for it.
#[test]
fn nearly_degenerate_boxes() {
    let (c, s) = (0.6_f64.cos(), 0.6_f64.sin());
    let turn = Matrix::from_rows(&[
        &[c, -s, 0.0, 0.0],
        &[s * c, c * c, -s, 0.0],
        &[s * s, c * s, c, 0.1],
        &[0.3, 0.0, 0.0, 1.0],
    ])
    .unwrap();
    let cube = VPolytope::from_intervals(&[Interval::new(-1.0, 1.0).unwrap(); 4]).unwrap();
    let turned = cube.linear_map(&turn).unwrap();
    let half_spaces = turned.to_h_polytope().unwrap();
    assert!(half_spaces.num_half_spaces() >= 8);
    for v in turned.vertices().columns() {
        assert!(lies_in(&v.iter().map(|&x| q(x)).collect::<Vec<Q>>(), &half_spaces));
    }
    let volume = turned.volume().unwrap();
    assert!(volume.lo() > 0.0 && volume.width() < 1e-11 * volume.hi(), "{volume:?}");
}

/// Flat but for its remainder: no facets of all coordinates, the volume is between nothing and that of the hull.
#[test]
fn volume_of_a_flat_polytope_with_a_remainder() {
    let segment = Matrix::from_rows(&[&[0.0, 1.0], &[0.0, 0.0]]).unwrap();
    let set = VPolytope::with_remainder(segment, &[1e-3, 1e-3]).unwrap();
    let volume = set.volume().unwrap();
    // (1 + 2e-3) 2e-3.
    assert!(volume.contains(2.004e-3) && volume.lo() == 0.0 && volume.hi() < 2.005e-3, "{volume:?}");
}
