//! Support, hull and membership.

use scalars::Interval;
use setrep::{ConstrainedZonotope, IntervalVector, Matrix, Membership, Workspace, Zonotope};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::member::{assert_not_refuted, constrained};

/// Exact members are below every support value, in the hull, and never proven outside.
#[test]
fn members_are_never_refuted() {
    let mut workspace = Workspace::new();
    for case in 0..cases(10_000) {
        let mut random = Random::new(SEED + 20, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 9), random.between(0, 5));
        let (set, member) = constrained(&mut random, n, m, rows);
        let context = || format!("seed {SEED}+20 case {case}: {set:?} {member:?}");
        assert_not_refuted(&set, &member.x, &mut random, &mut workspace, &context);
    }
}

/// Members with room around them are proven inside, points beyond a support value outside.
#[test]
fn membership_decides_away_from_the_boundary() {
    let mut workspace = Workspace::new();
    let (mut inside, mut outside, mut asked) = (0, 0, 0);
    for case in 0..cases(2_500) {
        let mut random = Random::new(SEED + 21, case);
        let (n, m) = (random.between(1, 3), random.between(5, 9));
        // Of full dimension: flat sets have no room.
        let mut entries = |count: usize| -> Vec<f64> { (0..count).map(|_| random.moderate()).collect() };
        let (center, generators) = (entries(n), Matrix::from_column_slice(n, m, &entries(n * m)).unwrap());
        let mut set = ConstrainedZonotope::from(Zonotope::new(&center, &generators).unwrap());
        let c: Vec<f64> = (0..n).map(|_| 1.0 + 0.5 * random.moderate()).collect();
        let value = set.center().iter().zip(&c).map(|(x, c)| x * c).sum::<f64>();
        set.intersect_half_space(&c, value, &mut workspace).unwrap();
        let hull = set.interval_hull(&mut workspace).unwrap();
        let widest = hull.iter().map(Interval::width).fold(0.0, f64::max);
        if hull.iter().any(|side| side.width() < 1e-3 * side.mag() || side.width() < 0.01 * widest) {
            continue;
        }
        asked += 1;
        // A point just inside the half-space, near the center; and one beyond it.
        let scale = hull.iter().map(Interval::width).fold(f64::INFINITY, f64::min);
        let at = |t: f64| -> Vec<f64> { set.center().iter().zip(&c).map(|(x, c)| x - t * scale * c).collect() };
        let near = set.membership(&IntervalVector::point(&at(1e-9)), &mut workspace).unwrap();
        assert!(near != Membership::ProvenOutside, "seed {SEED}+21 case {case}");
        inside += usize::from(near == Membership::ProvenInside);
        let beyond = set.membership(&IntervalVector::point(&at(-0.01)), &mut workspace).unwrap();
        assert!(
            beyond != Membership::ProvenInside,
            "seed {SEED}+21 case {case}: {set:?} {c:?} {value} {scale} {:?}",
            at(-0.01)
        );
        outside += usize::from(beyond == Membership::ProvenOutside);
    }
    assert!(asked > 300 && 10 * inside > 9 * asked && 10 * outside > 9 * asked, "{inside} {outside} of {asked}");
}
