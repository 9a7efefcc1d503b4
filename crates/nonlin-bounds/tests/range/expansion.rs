//! Expansion points against the linear programs they solve, and bad input.

use nonlin_bounds::{BoundError, Expansion, Operand, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// The set of paper 003, Fig. 1: the triangle (6.5, 1), (5.5, 0.5), (5, 0), whose center (5, 0.5) lies in the hull [5, 6.5] x [0, 1].
fn triangle() -> ConstrainedZonotope {
    let generators = Matrix::from_rows(&[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]]).unwrap();
    let rows = Matrix::from_rows(&[&[-1.0, 1.0, -1.0]]).unwrap();
    ConstrainedZonotope::from_cg_rep(&[5.0, 0.5], &generators, &rows, &[1.0]).unwrap()
}

#[test]
fn the_three_heuristics() {
    let (set, mut workspace) = (triangle(), Workspace::new());
    let hull = [interval(5.25, 6.5), interval(-1.0, 0.25)];
    let mut point = [0.0; 2];
    let mut at = |expansion: Expansion<'_>| {
        expansion.of_constrained(&set, &hull, &mut workspace, &mut point).unwrap();
        point
    };
    assert_eq!(at(Expansion::HullCenter), [5.875, -0.375]);
    assert_eq!(at(Expansion::SetCenter), [5.25, 0.25]);
    assert_eq!(at(Expansion::Point(&[6.0, 0.0])), [6.0, 0.0]);
    let eliminated = at(Expansion::EliminationCenter);

    let mut free = set.clone();
    free.eliminate_constraints(0, &mut setrep::Workspace::new()).unwrap();
    for i in 0..2 {
        // The nearest point of the side to the center of the eliminated set.
        assert_eq!(eliminated[i], free.center()[i].clamp(hull[i].lo(), hull[i].hi()));
    }
    assert_eq!(set, triangle());
}

/// Without constraints nothing is eliminated, and a hull that contains the center gives the center.
#[test]
fn zonotopes() {
    let set = Zonotope::from_box(&[1.0, 2.0], &[0.5, 0.25]).unwrap();
    let (hull, mut point) = (set.interval_hull(), [0.0; 2]);
    for expansion in [Expansion::HullCenter, Expansion::EliminationCenter, Expansion::SetCenter] {
        expansion.of_zonotope(&set, &hull, &mut point).unwrap();
        assert_eq!(point, [1.0, 2.0]);
    }
}

#[test]
fn bad_input() {
    let (set, mut workspace, mut point) = (triangle(), Workspace::new(), [7.0; 2]);
    let hull = [interval(5.0, 6.5), interval(0.0, 1.0)];
    let mut error = |expansion: Expansion<'_>, hull: &[Interval]| {
        let error = expansion.of_constrained(&set, hull, &mut workspace, &mut point).unwrap_err();
        assert_eq!(point, [7.0; 2], "an error leaves the target alone");
        error
    };
    let dimension = |operand, found| BoundError::Dimension { operand, expected: 2, found };
    assert_eq!(error(Expansion::Point(&[5.5]), &hull), dimension(Operand::ExpansionPoint, 1));
    assert_eq!(error(Expansion::HullCenter, &hull[..1]), dimension(Operand::Hull, 1));
    assert_eq!(error(Expansion::Point(&[5.5, 1.0000001]), &hull), BoundError::OutsideHull { index: 1 });
    let not_finite = |operand, index| BoundError::NonFinite { operand, index };
    assert_eq!(error(Expansion::Point(&[5.5, f64::NAN]), &hull), not_finite(Operand::ExpansionPoint, 1));
    assert_eq!(error(Expansion::SetCenter, &[hull[0], Interval::ENTIRE]), not_finite(Operand::Hull, 1));
    let empty = BoundError::EmptyInterval { operand: Operand::Hull, index: 0 };
    assert_eq!(error(Expansion::EliminationCenter, &[Interval::EMPTY, hull[1]]), empty);

    let mut short = [0.0];
    let result = Expansion::HullCenter.of_constrained(&set, &hull, &mut workspace, &mut short);
    assert_eq!(result, Err(dimension(Operand::ExpansionPoint, 1)));
}

/// Resolving a point again allocates nothing.
#[test]
fn steady_state_allocates_nothing() {
    let (set, mut workspace, mut point) = (triangle(), Workspace::new(), [0.0; 2]);
    let hull = [interval(5.0, 6.5), interval(0.0, 1.0)];
    let mut resolve = || Expansion::EliminationCenter.of_constrained(&set, &hull, &mut workspace, &mut point).unwrap();
    resolve();
    resolve();
    assert_eq!(allocation_counter::measure(resolve).count_total, 0);
}
