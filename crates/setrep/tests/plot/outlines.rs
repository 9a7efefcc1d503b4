//! Outlines in the plane.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, HPolytope, IntervalVector, Matrix, Outline, SetError, SupportFunction, VPolytope, Workspace,
    Zonotope,
};

use crate::common::dyadic::Dyadic;
use crate::common::exact::member;
use crate::common::random::{Random, cases};
use crate::{SEED, cut_at_a_member};

/// Whether the polygon, counterclockwise, contains the point, exactly.
fn contains(polygon: &[[f64; 2]], x: &Dyadic, y: &Dyadic) -> bool {
    let exact = |v: [f64; 2]| v.map(Dyadic::from);
    polygon.len() > 2
        && (0..polygon.len()).all(|k| {
            let ([ax, ay], [bx, by]) = (exact(polygon[k]), exact(polygon[(k + 1) % polygon.len()]));
            let (left, right) = (&(&bx - &ax) * &(y - &ay), &(&by - &ay) * &(x - &ax));
            (&left - &right).sign().is_ge()
        })
}

fn area(polygon: &[[f64; 2]]) -> f64 {
    let shift = polygon[0];
    let next = |k: usize| polygon[(k + 1) % polygon.len()];
    let cross =
        |a: [f64; 2], b: [f64; 2]| (a[0] - shift[0]) * (b[1] - shift[1]) - (a[1] - shift[1]) * (b[0] - shift[0]);
    (0..polygon.len()).map(|k| 0.5 * cross(polygon[k], next(k))).sum()
}

/// Members of zonotopes and of constrained zonotopes over 16 decades, exactly.
#[test]
fn outer_polygons_contain_every_member() {
    let mut workspace = Workspace::new();
    let (mut proper, mut tight) = (0, 0);
    for case in 0..cases(1500) {
        let mut random = Random::new(SEED, case);
        let (n, m) = (random.between(2, 4), random.between(0, 7));
        let body = random.set(n, m);
        let (cut, inside) = cut_at_a_member(&mut random, &body);
        let (i, j) = (random.below(n), 1 + random.below(n - 1));
        let axes = [i, (i + j) % n];
        let whole = Outline::new(&body, axes, &mut workspace).unwrap();
        let part = Outline::new(&cut, axes, &mut workspace).unwrap();
        for _ in 0..10 {
            let x = member(&body, &mut random).x;
            // A set without area may be enclosed by a segment or a point: then its members lie there by being equal.
            if whole.outer.len() > 2 {
                assert!(
                    contains(&whole.outer, &x[axes[0]], &x[axes[1]]),
                    "seed {SEED} case {case}: {body:?} {whole:?}"
                );
                proper += 1;
            }
        }
        if part.outer.len() > 2 {
            let x = &inside.x;
            assert!(contains(&part.outer, &x[axes[0]], &x[axes[1]]), "seed {SEED} case {case}: {cut:?} {part:?}");
        }
        let hull = body.interval_hull();
        let size = hull[axes[0]].mag().max(hull[axes[1]].mag());
        // Programs over 16 decades may stop early: a wider outline, still around the set.
        tight += usize::from(whole.gap <= 1e-8 * size && part.gap <= 1e-4 * size);
    }
    let all = cases(1500);
    assert!(proper > 8 * all && 10 * tight > 9 * all, "{proper} {tight} of {all}");
}

/// The polygons of moderate sets in every type: inner vertices as known, areas, gaps of rounding size.
#[test]
fn outlines_are_as_large_as_the_set() {
    let mut workspace = Workspace::new();
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 1, case);
        let m = random.between(2, 12);
        let data: Vec<f64> = (0..2 * m).map(|_| random.moderate()).collect();
        let generators = Matrix::from_column_slice(2, m, &data).unwrap();
        let zonotope = Zonotope::new(&[random.moderate(), random.moderate()], &generators).unwrap();
        let vertices = zonotope.vertices_2d().unwrap();
        let mut columns = Matrix::zeros(2, 0);
        vertices.iter().for_each(|v| columns.push_col(v).unwrap());
        let polygon = VPolytope::new(columns).unwrap();
        let mut constrained = ConstrainedZonotope::from(zonotope.clone());
        // A constraint that cuts off nothing.
        constrained.intersect_half_space(&[1.0, 0.5], 100.0, &mut workspace).unwrap();
        let half_spaces = polygon.to_h_polytope().unwrap();
        let sets: [&dyn SupportFunction; 4] = [&zonotope, &polygon, &constrained, &half_spaces];
        for (kind, set) in sets.into_iter().enumerate() {
            let outline = Outline::new(set, [0, 1], &mut workspace).unwrap();
            let context = || format!("seed {SEED}+1 case {case} kind {kind}: {vertices:?} {outline:?}");
            assert_eq!(outline.inner.len(), vertices.len(), "{}", context());
            let near = |v: &[f64; 2]| outline.inner.iter().any(|w| (v[0] - w[0]).hypot(v[1] - w[1]) < 1e-9);
            assert!(vertices.iter().all(near), "{}", context());
            // The vertices of shallow corners amplify the rounding of programs.
            assert!(outline.gap < if kind < 2 { 1e-11 } else { 1e-9 }, "{}", context());
            let volume = zonotope.volume().unwrap();
            assert!(area(&outline.outer) >= volume.lo() && area(&outline.outer) < volume.hi() + 1e-9, "{}", context());
            assert!((area(&outline.inner) - volume.mid()).abs() < 1e-9, "{}", context());
        }
    }
}

/// A hundred sides are all found; a thousand generators are no trouble.
#[test]
fn many_vertices() {
    let mut workspace = Workspace::new();
    let corner = |k: usize| (std::f64::consts::TAU * k as f64 / 100.0).sin_cos();
    let mut points = Matrix::zeros(2, 0);
    (0..100).for_each(|k| points.push_col(&[corner(k).1, corner(k).0]).unwrap());
    let outline = Outline::new(&VPolytope::new(points).unwrap(), [0, 1], &mut workspace).unwrap();
    assert_eq!(outline.inner.len(), 100);
    assert!(outline.gap < 1e-12);
    let mut random = Random::new(SEED, 0);
    let data: Vec<f64> = (0..2000).map(|_| random.moderate()).collect();
    let set = Zonotope::new(&[0.0; 2], &Matrix::from_column_slice(2, 1000, &data).unwrap()).unwrap();
    let outline = Outline::new(&set, [0, 1], &mut workspace).unwrap();
    assert!(outline.inner.len() > 1900 && outline.gap < 1e-4, "{} {}", outline.inner.len(), outline.gap);
    let volume = set.volume().unwrap().mid();
    assert!((area(&outline.outer) / volume - 1.0).abs() < 1e-7);
}

#[test]
fn points_segments_and_flat_sets() {
    let mut workspace = Workspace::new();
    let point = IntervalVector::point(&[0.1, 1e6, -3.0]);
    let outline = Outline::new(&point, [0, 1], &mut workspace).unwrap();
    assert!(outline.inner == vec![[0.1, 1e6]] && outline.outer.len() <= 4 && outline.gap < 1e-9, "{outline:?}");
    // A segment in the plane, seen along and across.
    let segment = Zonotope::new(&[1.0, 2.0], &Matrix::from_columns(&[&[0.3, 0.1]]).unwrap()).unwrap();
    let outline = Outline::new(&segment, [0, 1], &mut workspace).unwrap();
    assert_eq!(outline.inner.len(), 2);
    assert!(outline.gap < 1e-14 && area(&outline.outer).abs() < 1e-14, "{outline:?}");
    // The same by a constraint, where the proof of the bound has a gap of its own.
    let rows = Matrix::from_rows(&[&[1.0, 1.0, 0.3]]).unwrap();
    let cut = ConstrainedZonotope::from_cg_rep(
        &[0.0; 2],
        &Matrix::from_rows(&[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.3]]).unwrap(),
        &rows,
        &[0.5],
    );
    let outline = Outline::new(&cut.unwrap(), [1, 0], &mut workspace).unwrap();
    assert_eq!(outline.inner.len(), 2, "{outline:?}");
    assert!(outline.gap < 1e-13, "{outline:?}");
    // A flat polytope.
    let rows = Matrix::from_rows(&[&[1.0, -1.0], &[-1.0, 1.0], &[1.0, 0.0], &[-1.0, 0.0]]).unwrap();
    let flat = HPolytope::new(rows, &[0.0, 0.0, 1.0, 0.0]).unwrap();
    let outline = Outline::new(&flat, [0, 1], &mut workspace).unwrap();
    assert_eq!(outline.inner.len(), 2, "{outline:?}");
    assert!(outline.gap < 1e-12, "{outline:?}");
}

#[test]
fn what_has_no_outline_is_refused() {
    let mut workspace = Workspace::new();
    let square = IntervalVector::from_center(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    for axes in [[0, 2], [0, 0]] {
        assert!(matches!(Outline::new(&square, axes, &mut workspace), Err(SetError::Dimension { .. })));
    }
    let empty = IntervalVector::new(vec![Interval::ZERO, Interval::EMPTY]);
    assert_eq!(Outline::new(&empty, [0, 1], &mut workspace), Err(SetError::EmptySet));
    let mut nothing = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    nothing.intersect_half_space(&[1.0, 1.0], -3.0, &mut workspace).unwrap();
    assert_eq!(Outline::new(&nothing, [0, 1], &mut workspace), Err(SetError::EmptySet));
    let wedge = HPolytope::new(Matrix::from_rows(&[&[1.0, 1.0]]).unwrap(), &[1.0]).unwrap();
    assert!(matches!(Outline::new(&wedge, [0, 1], &mut workspace), Err(SetError::Overflow { .. })));
}
