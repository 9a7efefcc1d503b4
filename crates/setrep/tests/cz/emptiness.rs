//! Emptiness and its proofs.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Emptiness, IntervalVector, Matrix, Membership, Workspace};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::member::{constrained, loosened};

/// Sets with a member are never called empty; a witness box meets the set.
#[test]
fn sets_with_members_are_not_empty() {
    let mut workspace = Workspace::new();
    let mut proven = 0;
    for case in 0..cases(5_000) {
        let mut random = Random::new(SEED + 30, case);
        let (n, m, rows) = (random.between(1, 4), random.between(1, 8), random.between(0, 4));
        let (set, _) = constrained(&mut random, n, m, rows);
        match set.emptiness(&mut workspace).unwrap() {
            Emptiness::ProvenEmpty(proof) => panic!("seed {SEED}+30 case {case}: {proof:?} {set:?}"),
            Emptiness::ProvenNonEmpty(point) => {
                proven += 1;
                let verdict = set.membership(&point, &mut workspace).unwrap();
                assert!(verdict != Membership::ProvenOutside, "seed {SEED}+30 case {case}: {point:?} {set:?}");
            }
            Emptiness::Undecided => {}
        }
        assert!(!set.is_proven_empty(&mut workspace).unwrap());
    }
    assert!(proven > cases(5_000) / 3, "{proven}");
}

/// Contradictions are found, their proofs verify, and prove nothing of the set without the contradiction.
///
/// Those by less than 1e-12 of the rows' 1-norms are not claimed: the set has points then if its ranges are wider by that much.
#[test]
fn contradictions_are_proven() {
    let mut workspace = Workspace::new();
    for case in (0..cases(2_500)).chain([3_193]) {
        let mut random = Random::new(SEED + 31, case);
        let (n, m, rows) = (random.between(1, 4), random.between(1, 8), random.between(0, 4));
        let (set, _) = constrained(&mut random, n, m, rows);
        let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let beyond = set.support(&d, &mut workspace).unwrap();
        let reach = set.unconstrained().support(&d).unwrap() - beyond;
        let extent =
            set.unconstrained().radius() + set.unconstrained().center().iter().fold(0.0, |s: f64, c| s.max(c.abs()));
        let mut cut = set.clone();
        let normal: Vec<f64> = d.iter().map(|d| -d).collect();
        let gap = 1e-3 * (extent + reach) + 1e-9;
        cut.intersect_half_space(&normal, -(beyond + gap), &mut workspace).unwrap();
        let Emptiness::ProvenEmpty(proof) = cut.emptiness(&mut workspace).unwrap() else {
            let reached = loosened(&set, 2e-12).support(&d, &mut workspace).unwrap() >= beyond + gap;
            assert!(reached, "missed, seed {SEED}+31 case {case}: {set:?} {d:?} {beyond}");
            continue;
        };
        assert!(proof.verify(&cut) && !proof.verify(&set) && !proof.multipliers().is_empty());
        assert!(cut.is_proven_empty(&mut workspace).unwrap());
        assert!(cut.interval_hull(&mut workspace).unwrap().iter().all(Interval::is_empty));
        assert_eq!(cut.support(&d, &mut workspace).unwrap(), f64::NEG_INFINITY);
        // Operations on an empty set are valid, and it stays so.
        let image = cut.linear_map(&Matrix::identity(n)).unwrap().minkowski_sum(&set).unwrap();
        assert!(image.is_proven_empty(&mut workspace).unwrap());
    }
}

/// Without generators the constraints say whether zero lies in their ranges.
#[test]
fn sets_without_generators() {
    let mut workspace = Workspace::new();
    let point = ConstrainedZonotope::from_cg_rep(&[1.0], &Matrix::zeros(1, 0), &Matrix::zeros(1, 0), &[0.0]).unwrap();
    assert!(matches!(point.emptiness(&mut workspace).unwrap(), Emptiness::ProvenNonEmpty(x) if x.contains(&[1.0])));
    assert_eq!(point.membership(&IntervalVector::point(&[1.0]), &mut workspace).unwrap(), Membership::ProvenInside);
    assert_eq!(point.membership(&IntervalVector::point(&[1.5]), &mut workspace).unwrap(), Membership::ProvenOutside);
    let nothing = ConstrainedZonotope::from_cg_rep(&[1.0], &Matrix::zeros(1, 0), &Matrix::zeros(1, 0), &[1.0]).unwrap();
    assert!(matches!(nothing.emptiness(&mut workspace).unwrap(), Emptiness::ProvenEmpty(_)));
}
