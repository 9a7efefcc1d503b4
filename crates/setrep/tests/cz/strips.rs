//! Strips, half-spaces and polytopes cut as their rows do; membership and forms of strips.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, HPolytope, HalfSpace, IntervalVector, Matrix, Membership, SetError, Strip, Workspace, Zonotope,
};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::member::constrained;

#[test]
fn typed_cuts_are_the_cuts_by_rows() {
    let mut workspace = Workspace::new();
    for case in 0..cases(1_250) {
        let mut random = Random::new(SEED + 60, case);
        let n = random.between(1, 4);
        let (m, count) = (random.between(0, 6), random.between(1, 4));
        let (set, _) = constrained(&mut random, n, m, 1);
        let rows = random.matrix(count, n);
        let offsets: Vec<f64> = (0..count).map(|_| random.wide()).collect();
        let polytope = HPolytope::new(rows.clone(), &offsets).unwrap();
        let half_spaces: Vec<HalfSpace> = (0..count).map(|i| polytope.half_space(i).unwrap()).collect();
        assert_eq!(HPolytope::from_half_spaces(&half_spaces).unwrap(), polytope);
        assert!(polytope.half_space(count).is_none());
        let strips: Vec<Strip> = half_spaces.into_iter().map(Strip::from).collect();
        assert_eq!(HPolytope::from_strips(n, &strips).unwrap(), polytope);
        let ranges: Vec<Interval> = strips.iter().map(Strip::range).collect();
        let cut = |by: &dyn Fn(&mut ConstrainedZonotope, &mut Workspace), workspace: &mut Workspace| {
            let mut cut = set.clone();
            by(&mut cut, workspace);
            cut
        };
        let expected = cut(&|set, workspace| set.intersect_rows(&rows, &ranges, workspace).unwrap(), &mut workspace);
        let by_strips = cut(&|set, workspace| set.intersect_strips(&strips, workspace).unwrap(), &mut workspace);
        let by_polytope =
            cut(&|set, workspace| set.intersect_h_polytope(&polytope, workspace).unwrap(), &mut workspace);
        assert!(expected == by_strips && expected == by_polytope, "seed {SEED}+60 case {case}");
        let body: Zonotope = set.unconstrained().clone();
        let plain = ConstrainedZonotope::from(body.clone());
        let mut by_rows = plain.clone();
        by_rows.intersect_rows(&rows, &ranges, &mut workspace).unwrap();
        assert_eq!(body.intersection(&strips, &mut workspace).unwrap(), by_rows);
    }
}

/// Three sides cut the square to a triangle: hull, and the corner is gone.
#[test]
fn a_square_cut_to_a_triangle() {
    let mut workspace = Workspace::new();
    let rows = Matrix::from_rows(&[&[1.0, 1.0], &[-1.0, 0.0], &[0.0, -1.0]]).unwrap();
    let triangle = HPolytope::new(rows, &[1.0, -0.25, -0.25]).unwrap();
    let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    set.intersect_h_polytope(&triangle, &mut workspace).unwrap();
    for side in set.interval_hull(&mut workspace).unwrap().iter() {
        assert!((side.lo() - 0.25).abs() < 1e-13 && (side.hi() - 0.75).abs() < 1e-13, "{side}");
    }
}

#[test]
fn strips_know_their_points_and_refuse_bad_input() {
    let strip = Strip::new(&[1.0, -1.0], Interval::point(0.0).inflate(0.5)).unwrap();
    let ask = |x: f64, y: f64| strip.membership(&IntervalVector::point(&[x, y])).unwrap();
    assert_eq!(
        [ask(3.0, 2.5), ask(3.0, 2.4), ask(-3.0, -2.4)].map(|answer| answer == Membership::ProvenInside),
        [true, false, false]
    );
    let half_space = HalfSpace::new(&[0.0, 2.0], 1.0).unwrap();
    let inside = half_space.membership(&IntervalVector::point(&[7.0, 0.5])).unwrap();
    let outside = half_space.membership(&IntervalVector::point(&[7.0, 0.6])).unwrap();
    assert_eq!((inside, outside), (Membership::ProvenInside, Membership::ProvenOutside));
    assert_eq!(
        HPolytope::from_strips(2, &[Strip::new(&[1.0, 0.0], Interval::ENTIRE).unwrap()]).unwrap().num_half_spaces(),
        0
    );
    assert!(matches!(Strip::new(&[], Interval::ZERO), Err(SetError::ZeroDimension { .. })));
    assert!(matches!(Strip::new(&[f64::NAN], Interval::ZERO), Err(SetError::NonFinite { .. })));
    assert!(matches!(Strip::new(&[1.0], Interval::EMPTY), Err(SetError::EmptyInterval { .. })));
    assert!(matches!(HalfSpace::new(&[1.0], f64::INFINITY), Err(SetError::NonFinite { .. })));
    assert!(matches!(HPolytope::from_half_spaces(&[]), Err(SetError::ZeroDimension { .. })));
    let other = HalfSpace::new(&[1.0], 1.0).unwrap();
    assert!(matches!(HPolytope::from_half_spaces(&[half_space, other]), Err(SetError::Dimension { .. })));
    let mut set = ConstrainedZonotope::from_box(&[0.0], &[1.0]).unwrap();
    let before = set.clone();
    assert!(matches!(set.intersect_strips(&[strip], &mut Workspace::new()), Err(SetError::Dimension { .. })));
    assert_eq!(set, before);
}
