//! Rows that come and go inside a box, against programs on the polytope they make.

use scalars::Interval;
use setrep::{BoxedRows, HPolytope, Part, SetError, Workspace};

use crate::common::random::Random;

fn side(radius: f64) -> Interval {
    Interval::new(-radius, radius).unwrap()
}

/// The support by the optimizer of the same rows and box.
fn reference(rows: &BoxedRows, direction: &[f64]) -> f64 {
    let mut workspace = Workspace::new();
    let polytope: HPolytope = rows.to_polytope().unwrap();
    polytope.optimizer(&mut workspace).unwrap().support(direction).unwrap()
}

/// Pushes, moves, drops and new boxes in random order: supports stay those of the rows.
#[test]
fn supports_follow_the_rows() {
    let mut random = Random::new(17, 0);
    let mut rows = BoxedRows::new(&[side(2.0), Interval::new(3.0, 5.0).unwrap(), side(1e-3), side(40.0)]).unwrap();
    for round in 0..60 {
        for _ in 0..4 {
            let scales = [1.0, 1.0, 1e3, 0.05];
            let normal: Vec<f64> = scales.iter().map(|s| s * random.unit()).collect();
            // The point (0, 4, 0, 0) stays inside.
            rows.push(&normal, 4.0 * normal[1] + 0.2 + random.unit().abs()).unwrap();
        }
        let i = random.below(rows.len());
        rows.raise(i, 0.1);
        let j = random.below(rows.len());
        rows.set_offset(j, rows.offsets()[j] + 0.05).unwrap();
        if round % 7 == 6 {
            rows.reframe(&[side(3.0), Interval::new(2.5, 6.0).unwrap(), side(2e-3), side(30.0)], |_, _, h| *h += 0.01)
                .unwrap();
        }
        if rows.len() > 40 {
            rows.retain(|i| i % 3 != round % 3);
        }
        let direction: Vec<f64> = (0..4).map(|_| random.unit()).collect();
        let value = rows.support(&direction).unwrap();
        let expected = reference(&rows, &direction);
        assert!((value - expected).abs() < 1e-9, "round {round}: {value} {expected}");
        assert!(value >= 4.0 * direction[1] - 1e-12, "the inner point is not cut off");
        assert!(rows.active().iter().all(|&(i, y)| i < rows.len() && y.is_finite()));
    }
}

/// A contradiction comes with a proof that can be checked, and that a moved row spoils.
#[test]
fn contradictions_carry_their_proof() {
    let mut rows = BoxedRows::new(&[side(10.0), side(10.0)]).unwrap();
    rows.push(&[0.0, 1.0], 7.0).unwrap();
    rows.push(&[1.0, 1.0], -1.0).unwrap();
    rows.push(&[-1.0, -1.0], 0.5).unwrap();
    assert_eq!(rows.support(&[1.0, 0.0]).unwrap(), f64::NEG_INFINITY);
    let proof = rows.contradiction().unwrap().clone();
    let mut named = proof.rows().to_vec();
    named.sort_unstable();
    assert_eq!(named, [1, 2]);
    assert!(proof.verify() && (proof.miss() - 0.125).abs() < 1e-12, "{}", proof.miss());
    rows.raise(1, 1.0);
    assert!(rows.support(&[1.0, 0.0]).unwrap() > 0.0);
}

/// No rows, rows without a bound, sides without width.
#[test]
fn degenerate_rows_are_fine() {
    let mut rows = BoxedRows::new(&[Interval::point(2.0), side(1.0)]).unwrap();
    assert!(rows.is_empty() && (2.0..4.0).contains(&rows.support(&[1.0, 0.0]).unwrap()));
    rows.push(&[1.0, 0.0], f64::INFINITY).unwrap();
    rows.push(&[0.0, 0.0], 0.0).unwrap();
    let row = rows.push(&[0.0, 1.0], 0.5).unwrap();
    assert!((0.5..0.5 + 1e-13).contains(&rows.support(&[0.0, 1.0]).unwrap()));
    rows.raise(row, f64::NAN);
    assert_eq!(rows.offsets()[row], f64::INFINITY);
    assert!(rows.support(&[0.0, 1.0]).unwrap() >= 1.0);
    assert!(rows.holds(1, &side(0.9)) && !rows.holds(1, &side(3.0)));
}

#[test]
fn bad_rows_are_refused() {
    let ends = SetError::UnboundedInterval { part: Part::Interval, row: 1, col: 0 };
    assert_eq!(BoxedRows::new(&[side(1.0), Interval::ENTIRE]).unwrap_err(), ends);
    assert_eq!(BoxedRows::new(&[]).unwrap_err(), SetError::ZeroDimension { part: Part::Interval });
    let mut rows = BoxedRows::new(&[side(1.0), side(1.0)]).unwrap();
    rows.push(&[1.0, 0.0], 0.5).unwrap();
    assert!(matches!(rows.push(&[1.0], 0.0), Err(SetError::Dimension { part: Part::Normals, expected: 2, found: 1 })));
    assert!(rows.push(&[f64::NAN, 0.0], 0.0).is_err() && rows.push(&[1.0, 0.0], f64::NAN).is_err());
    assert!(rows.push(&[f64::MAX, f64::MAX], 0.0).is_err());
    assert!(rows.set_offset(1, 0.0).is_err() && rows.set_offset(0, f64::NEG_INFINITY).is_err());
    assert!(rows.support(&[1.0]).is_err() && rows.support(&[f64::INFINITY, 0.0]).is_err());
    assert_eq!((rows.len(), rows.normal(0)), (1, &[1.0, 0.0][..]));
    assert!((0.5..0.5 + 1e-13).contains(&rows.support(&[1.0, 0.0]).unwrap()));
}
