//! Sets in sets, and Pontryagin differences from both sides.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, Containment, Directions, IntervalVector, Matrix, Membership, SetError, Workspace, Zonotope,
};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{member, sum};
use crate::common::random::{Random, cases};
use crate::member::{around, assert_not_refuted, constrained};

/// A random set with bands, of moderate numbers.
pub(crate) fn banded(random: &mut Random, n: usize, m: usize, rows: usize) -> ConstrainedZonotope {
    let mut matrix = |rows: usize, cols: usize| {
        let entries: Vec<f64> = (0..rows * cols).map(|_| random.moderate()).collect();
        Matrix::from_column_slice(rows, cols, &entries).unwrap()
    };
    let (g, a) = (matrix(n, m), matrix(rows, m));
    let bands: Vec<Interval> = (0..rows).map(|k| Interval::point(0.0).inflate([0.0, 0.5, 1.0][k % 3])).collect();
    ConstrainedZonotope::new(&vec![0.0; n], &g, &a, &bands).unwrap()
}

/// A shrunken copy is proven inside, an enlarged or shifted one is not; a proof is never refuted by a member.
#[test]
fn containment_is_proven_of_shrunken_copies_only() {
    let mut workspace = Workspace::new();
    let mut proven = 0;
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 90, case);
        let n = random.between(1, 3);
        let (m, rows) = (random.between(n + 2, 6), random.between(0, 2));
        let set = banded(&mut random, n, m, rows);
        let context = || format!("seed {SEED}+90 case {case}: {set:?}");
        let mut small = set.clone();
        small.scale(0.875).unwrap();
        let verdict = set.contains_sufficient(&small, &mut workspace).unwrap();
        assert_eq!(verdict, Containment::Proven, "{}", context());
        assert_eq!(small.contains_sufficient(&set, &mut workspace).unwrap(), Containment::Undecided, "{}", context());
        let hull = set.interval_hull(&mut workspace).unwrap();
        let mut moved = small.clone();
        moved.translate(&hull.iter().map(Interval::rad).collect::<Vec<_>>()).unwrap();
        assert_eq!(set.contains_sufficient(&moved, &mut workspace).unwrap(), Containment::Undecided, "{}", context());
        // Two sets that have nothing to do with each other.
        let mut other = banded(&mut random, n, m, rows);
        other.scale(0.25).unwrap();
        if set.contains_sufficient(&other, &mut workspace).unwrap() == Containment::Proven {
            proven += 1;
            let mut optimizer = other.optimizer(&mut workspace).unwrap();
            let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
            let inner = optimizer.support(&d).unwrap();
            let outer = set.support(&d, &mut workspace).unwrap();
            assert!(inner <= outer + 1e-9, "{inner} {outer} {}", context());
        }
    }
    assert!(proven > cases(300) / 20, "{proven}");
}

/// Wide numbers, flat sets, points: whatever is proven contains the exact members.
#[test]
fn proofs_of_containment_hold() {
    let mut workspace = Workspace::new();
    let mut proven = 0;
    for case in 0..cases(600) {
        let mut random = Random::new(SEED + 91, case);
        let (n, m, rows) = (random.between(1, 3), random.between(0, 4), random.between(0, 2));
        let (inner, x) = constrained(&mut random, n, m, rows);
        let mut outer = inner.clone();
        let k = random.between(0, 3);
        outer.add_assign(&random.set(n, k).into()).unwrap();
        if random.below(3) == 0 {
            outer = random.set(n, n + 1).into();
        }
        if outer.contains_sufficient(&inner, &mut workspace).unwrap() == Containment::Proven {
            proven += 1;
            let context = || format!("seed {SEED}+91 case {case}: {inner:?} {outer:?} {x:?}");
            assert_not_refuted(&outer, &x.x, &mut random, &mut workspace, &context);
        }
    }
    eprintln!("{proven} of {} proven", cases(600));
    assert!(proven > cases(600) / 20, "{proven}");
}

#[test]
fn degenerate_sets_in_sets() {
    let mut workspace = Workspace::new();
    let square = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let mut ask = |outer: &ConstrainedZonotope, inner: &ConstrainedZonotope| {
        outer.contains_sufficient(inner, &mut workspace).unwrap() == Containment::Proven
    };
    let point = ConstrainedZonotope::from_box(&[0.5, -0.25], &[0.0, 0.0]).unwrap();
    assert!(ask(&square, &point) && !ask(&point, &square));
    let far = ConstrainedZonotope::from_box(&[1.5, 0.0], &[0.0, 0.0]).unwrap();
    assert!(!ask(&square, &far));
    let row = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let segment = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &row, &[1.0]).unwrap();
    let mut short = segment.clone();
    short.translate(&[-0.5, -0.5]).unwrap();
    short.scale(0.5).unwrap();
    assert!(ask(&square, &short) && !ask(&segment, &square));
    // A flat outer set is beyond the test: no correction stays in its plane.
    short.translate(&[0.5, 0.5]).unwrap();
    assert!(!ask(&segment, &short));
    let empty = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &row, &[3.0]).unwrap();
    assert!(ask(&point, &empty) && !ask(&empty, &point));
    let line = ConstrainedZonotope::from_box(&[0.0], &[1.0]).unwrap();
    assert!(matches!(square.contains_sufficient(&line, &mut Workspace::new()), Err(SetError::Dimension { .. })));
}

/// An exact member of the inner difference plus one of the subtrahend is no stranger to the set; an exact member of the difference
/// (of the inner one, again) is none to the outer difference.
#[test]
fn differences_are_nested() {
    let mut workspace = Workspace::new();
    let (mut found, mut inside) = (0, 0);
    for case in 0..cases(500) {
        let mut random = Random::new(SEED + 92, case);
        let n = random.between(1, 3);
        let (m, rows) = (random.between(n, 6), random.between(0, 2));
        let mut set = if case % 2 == 0 { banded(&mut random, n, m, rows) } else { random.set(n, m).into() };
        set.translate(&(0..n).map(|_| random.moderate()).collect::<Vec<_>>()).unwrap();
        let k = random.between(0, 3);
        let mut noise =
            if case % 2 == 0 { banded(&mut random, n, k, 0).unconstrained().clone() } else { random.set(n, k) };
        if case % 2 == 1 {
            // Generators of the set itself, shortened.
            let own = Matrix::from_column_slice(n, m, set.generators().as_slice()).unwrap();
            noise = Zonotope::new(noise.center(), &own).unwrap();
        }
        let factor = 0.125 * random.unit().abs();
        let center: Vec<f64> = noise.center().to_vec();
        noise.translate(&center.iter().map(|c| -c).collect::<Vec<_>>()).unwrap();
        noise.scale(factor).unwrap();
        noise.translate(&(0..n).map(|_| random.moderate()).collect::<Vec<_>>()).unwrap();
        let context = || format!("seed {SEED}+92 case {case}: {set:?} {noise:?}");
        let outer = set.outer_pontryagin(&noise, &Directions::new(n), &mut workspace).unwrap();
        let Some(inner) = set.inner_pontryagin(&noise).unwrap() else { continue };
        found += 1;
        // Members whose coordinates satisfy the constraints exactly: the zero vector does, and so do vertices without rows.
        let xi = if inner.num_constraints() == 0 {
            random.cube(inner.num_generators())
        } else {
            vec![0.0; inner.num_generators()]
        };
        if !inner.ranges().iter().all(|range| range.contains(0.0)) {
            continue;
        }
        inside += 1;
        let mut x = crate::common::exact::times(inner.generators(), &xi);
        x.iter_mut().zip(inner.center()).for_each(|(x, &c)| *x += &Dyadic::from(c));
        let w = member(&noise, &mut random).x;
        assert_not_refuted(&set, &sum(&x, &w), &mut random, &mut workspace, &context);
        assert_not_refuted(&outer, &x, &mut random, &mut workspace, &context);
        for _ in 0..3 {
            // The sum of the supports is at most that of the set.
            let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
            let (h, w) = (inner.support(&d, &mut workspace).unwrap(), noise.support(&d).unwrap());
            let whole = set.support(&d, &mut workspace).unwrap();
            assert!(h + w <= whole + 1e-9 * (1.0 + h.abs() + w.abs()), "{h} {w} {whole} {}", context());
        }
    }
    assert!(found > cases(500) / 3 && inside > cases(500) / 4, "{found} {inside}");
}

/// Of boxes both are the difference of the sides; of a hexagon and one of its generators what is left without it.
#[test]
fn differences_have_the_right_size() {
    let mut workspace = Workspace::new();
    let set = ConstrainedZonotope::from_box(&[1.0, 2.0, 3.0], &[1.0, 2.0, 3.0]).unwrap();
    let noise = Zonotope::from_box(&[0.5, 0.5, 0.5], &[0.5, 0.25, 3.0]).unwrap();
    let outer = set.outer_pontryagin(&noise, &Directions::new(3), &mut workspace).unwrap();
    let hull = outer.interval_hull(&mut workspace).unwrap();
    for (side, (c, r)) in hull.iter().zip([(0.5, 0.5), (1.5, 1.75), (2.5, 0.0)]) {
        assert!(side.contains(c - r) && side.contains(c + r) && side.rad() < r + 1e-13, "{hull:?}");
    }
    let less = Zonotope::from_box(&[0.5, 0.5, 0.5], &[0.5, 0.25, 2.0]).unwrap();
    let inner = set.inner_pontryagin(&less).unwrap().unwrap();
    let hull = inner.interval_hull(&mut workspace).unwrap();
    for (side, (c, r)) in hull.iter().zip([(0.5, 0.5), (1.5, 1.75), (2.5, 1.0)]) {
        assert!((side.mid() - c).abs() < 1e-6 && side.rad() <= r + 1e-13 && side.rad() > r - 1e-6, "{hull:?}");
    }
    let hexagon = Matrix::from_rows(&[&[1.0, 0.5, 0.0], &[0.0, 1.0, 1.0]]).unwrap();
    let hexagon = ConstrainedZonotope::from(Zonotope::new(&[0.0, 0.0], &hexagon).unwrap());
    let generator = Zonotope::new(&[0.0, 0.0], &Matrix::from_columns(&[&[0.5, 1.0]]).unwrap()).unwrap();
    let mut normals = Directions::new(2);
    [[0.0, 1.0], [1.0, -0.5], [1.0, 0.0]].iter().for_each(|d| normals.push(d).unwrap());
    let outer = hexagon.outer_pontryagin(&generator, &normals, &mut workspace).unwrap();
    let volume = |set: &ConstrainedZonotope| set.to_h_polytope().unwrap().volume().unwrap().mid();
    assert!((volume(&outer) - 4.0).abs() < 1e-9, "{}", volume(&outer));
    // More than the set has: proven empty from outside, nothing found from inside.
    let large = Zonotope::from_box(&[0.0, 0.0], &[4.0, 0.0]).unwrap();
    let outer = hexagon.outer_pontryagin(&large, &normals, &mut workspace).unwrap();
    assert!(outer.is_proven_empty(&mut workspace).unwrap());
    assert_eq!(hexagon.inner_pontryagin(&large).unwrap(), None);
    assert!(hexagon.inner_pontryagin(&Zonotope::point(&[1.0]).unwrap()).is_err());
    // A point only shifts.
    let moved = hexagon.inner_pontryagin(&Zonotope::point(&[0.5, 0.25]).unwrap()).unwrap().unwrap();
    let verdict = moved.membership(&IntervalVector::point(&[-0.5, 0.25]), &mut workspace).unwrap();
    assert_eq!(verdict, Membership::ProvenInside);
    let point: Vec<Interval> = [0.0, 0.0].iter().map(|&x| around(&Dyadic::from(x), 0.0, 0.0)).collect();
    assert_eq!(moved.membership(&point, &mut workspace).unwrap(), Membership::ProvenInside);
}
