//! Reduction of bundles, and bad input.

use setrep::{BundleComplexity, Matrix, Part, Reduction, SetError, Workspace, Zonotope, ZonotopeBundle};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::containment::{assert_member, bundle};

#[test]
fn reductions_contain_the_set_within_the_limit() {
    let mut workspace = Workspace::new();
    for case in 0..cases(1_500) {
        let mut random = Random::new(SEED + 10, case);
        let (n, members) = (random.between(1, 3), random.between(1, 5));
        let (set, x) = bundle(&mut random, n, members);
        let limit = BundleComplexity { members: random.between(1, 3), generators: n + random.below(3) };
        let mut reduced = set.clone();
        reduced.reduce(limit, [Reduction::Method4, Reduction::Girard][case % 2], &mut workspace).unwrap();
        assert!(reduced.num_members() <= limit.members.min(members));
        assert!(reduced.members().iter().all(|member| member.num_generators() <= limit.generators));
        assert_member(&reduced, &x, &mut random, &mut workspace, &format!("seed {SEED}+10 case {case} {limit:?}"));
    }
}

/// Twelve strips turned about the origin become two members of about the size of their intersection.
#[test]
fn what_is_dropped_still_counts() {
    let mut workspace = Workspace::new();
    let strip = |k: usize| {
        let (sin, cos) = (k as f64 * core::f64::consts::PI / 12.0).sin_cos();
        Zonotope::new(&[0.0, 0.0], &Matrix::from_columns(&[&[cos, sin], &[-8.0 * sin, 8.0 * cos]]).unwrap()).unwrap()
    };
    let mut set = ZonotopeBundle::new((0..12).map(strip).collect()).unwrap();
    set.reduce(BundleComplexity { members: 2, generators: 2 }, Reduction::Method4, &mut workspace).unwrap();
    assert_eq!((set.num_members(), set.num_generators()), (2, 4));
    for side in set.interval_hull(&mut workspace).unwrap().iter() {
        // The disc of radius 1, and the parallelotope around it.
        assert!(side.rad() >= 1.0 && side.rad() < 2.2, "{side:?}");
    }
}

#[test]
fn bad_input_is_refused() {
    let mut workspace = Workspace::new();
    let none = ZonotopeBundle::new(Vec::new());
    assert!(matches!(none, Err(SetError::Dimension { part: Part::Members, expected: 1, found: 0 })));
    let (line, plane) =
        (Zonotope::from_box(&[0.0], &[1.0]).unwrap(), Zonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap());
    assert!(ZonotopeBundle::new(vec![line.clone(), plane.clone()]).is_err());
    let mut set = ZonotopeBundle::from(plane.clone());
    set.intersect(&Zonotope::from_box(&[1e308, 0.0], &[1.0; 2]).unwrap()).unwrap();
    let before = set.clone();
    assert!(set.intersect(&line).is_err());
    assert!(set.linear_map_in_place(&Matrix::zeros(2, 3), &mut workspace).is_err());
    // Only the second member overflows.
    assert!(matches!(set.scale(1e3, &mut workspace), Err(SetError::Overflow { .. })));
    assert!(set.support(&[1.0], &mut workspace).is_err() && set.support(&[f64::NAN, 0.0], &mut workspace).is_err());
    let limit = |members, generators| BundleComplexity { members, generators };
    assert!(set.reduce(limit(0, 4), Reduction::Girard, &mut workspace).is_err());
    assert!(matches!(
        set.reduce(limit(1, 1), Reduction::Girard, &mut workspace),
        Err(SetError::TooFewGenerators { max_generators: 1, dim: 2 })
    ));
    assert_eq!(set, before);
}
