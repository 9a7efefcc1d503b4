//! Box, zonotope, constrained zonotope, half-spaces, vertices, and back.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, Directions, HPolytope, Matrix, Membership, SetError, VPolytope, Workspace, Zonotope,
};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::random::{Random, cases};
use crate::member::{around, assert_not_refuted, constrained, dot};

/// Around the circle of forms: an exact member is refuted by none of them.
#[test]
fn every_form_contains_the_set() {
    let mut workspace = Workspace::new();
    let mut converted = 0;
    for case in 0..cases(600) {
        let mut random = Random::new(SEED + 80, case);
        let (n, m, rows) = (random.between(1, 3), random.between(0, 5), random.between(0, 2));
        let (set, member) = constrained(&mut random, n, m, rows);
        let context = || format!("seed {SEED}+80 case {case}: {set:?} {member:?}");
        let point: Vec<Interval> = member.x.iter().map(|x| around(x, 0.0, 0.0)).collect();
        let mut directions = Directions::new(n);
        directions.push(&(0..n).map(|_| random.moderate()).collect::<Vec<_>>()).unwrap();
        let outer = set.outer_h_polytope(&directions, &mut workspace).unwrap();
        assert!(outer.membership(&point).unwrap() != Membership::ProvenOutside, "outer: {}", context());
        let vertices = set.to_v_polytope().unwrap();
        let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let h = Dyadic::from(vertices.support(&d).unwrap());
        assert!(dot(&d, &member.x) <= h, "vertices: {}", context());
        let back = ConstrainedZonotope::from_v_polytope(&vertices).unwrap();
        assert_not_refuted(&back, &member.x, &mut random, &mut workspace, &context);
        let half_spaces = set.to_h_polytope().unwrap();
        assert!(half_spaces.membership(&point).unwrap() != Membership::ProvenOutside, "half-spaces: {}", context());
        // The box of a thin polytope may not be found.
        match ConstrainedZonotope::from_h_polytope(&half_spaces, &mut workspace) {
            Ok(back) => {
                converted += 1;
                assert_not_refuted(&back, &member.x, &mut random, &mut workspace, &context);
            }
            Err(error) => assert!(matches!(error, SetError::Unbounded | SetError::Overflow { .. }), "{error}"),
        }
    }
    assert!(converted > cases(600) / 2, "{converted}");
}

/// A triangle of area 2 keeps its area, facets and vertices around the circle.
#[test]
fn a_triangle_keeps_its_size() {
    let mut workspace = Workspace::new();
    let sides = [Interval::new(-1.0, 1.0).unwrap(); 2];
    let square = Zonotope::from_intervals(&sides).unwrap();
    assert_eq!(square.to_v_polytope().unwrap().num_vertices(), 1, "a box is a remainder");
    let mut set = ConstrainedZonotope::from(square);
    set.intersect_half_space(&[1.0, 1.0], 0.0, &mut workspace).unwrap();
    for _ in 0..3 {
        // The rounding of a row may split a vertex.
        let half_spaces = set.to_h_polytope().unwrap();
        assert!((3..=5).contains(&half_spaces.num_half_spaces()), "{half_spaces:?}");
        assert!((half_spaces.volume().unwrap().mid() - 2.0).abs() < 1e-12);
        let vertices =
            ConstrainedZonotope::from_h_polytope(&half_spaces, &mut workspace).unwrap().to_v_polytope().unwrap();
        set = ConstrainedZonotope::from_v_polytope(&vertices).unwrap();
        assert_eq!((set.num_generators(), set.num_constraints()), (vertices.num_vertices(), 1));
    }
    let outer = set.outer_h_polytope(&Directions::new(2), &mut workspace).unwrap();
    assert!((outer.volume().unwrap().mid() - 4.0).abs() < 1e-12);
}

#[test]
fn degenerate_sets_are_converted() {
    let mut workspace = Workspace::new();
    let point = ConstrainedZonotope::from_box(&[1.0, 2.0], &[0.0, 0.0]).unwrap();
    assert_eq!(point.to_v_polytope().unwrap().vertices().as_slice(), [1.0, 2.0]);
    let row = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let segment = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &row, &[1.0]).unwrap();
    let vertices = segment.to_v_polytope().unwrap();
    assert_eq!(vertices.num_vertices(), 2);
    assert_eq!(vertices.support(&[1.0, 0.0]).unwrap(), 1.0);
    assert!(
        segment.to_h_polytope().unwrap().membership(&[Interval::point(0.5); 2]).unwrap() == Membership::ProvenInside
    );
    let empty = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &row, &[3.0]).unwrap();
    assert_eq!(empty.to_v_polytope(), Err(SetError::EmptySet));
    assert_eq!(empty.outer_h_polytope(&Directions::new(2), &mut workspace), Err(SetError::EmptySet));
    let nothing = ConstrainedZonotope::from_cg_rep(&[1.0], &Matrix::zeros(1, 0), &Matrix::zeros(1, 0), &[1.0]).unwrap();
    assert_eq!(nothing.to_v_polytope(), Err(SetError::EmptySet));
    let half_plane = HPolytope::new(Matrix::from_rows(&[&[1.0, 1.0]]).unwrap(), &[1.0]).unwrap();
    assert_eq!(ConstrainedZonotope::from_h_polytope(&half_plane, &mut workspace), Err(SetError::Unbounded));
    let contradiction = Matrix::from_rows(&[&[1.0, 0.0], &[-1.0, 0.0], &[0.0, 1.0], &[0.0, -1.0]]).unwrap();
    let contradiction = HPolytope::new(contradiction, &[-1.0, -1.0, 1.0, 1.0]).unwrap();
    let set = ConstrainedZonotope::from_h_polytope(&contradiction, &mut workspace).unwrap();
    assert!(set.is_proven_empty(&mut workspace).unwrap());
    let one = VPolytope::new(Matrix::from_columns(&[&[1.0, 2.0]]).unwrap()).unwrap();
    let hull = ConstrainedZonotope::from_v_polytope(&one).unwrap().interval_hull(&mut workspace).unwrap();
    assert!(hull.contains(&[1.0, 2.0]) && hull.iter().all(|side| side.width() < 1e-14));
}
