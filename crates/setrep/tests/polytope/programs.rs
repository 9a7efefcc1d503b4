//! What linear programs say of half-space forms, against exact vertices: supports, boxes, balls, redundancy.

use num_traits::{Signed, Zero};
use scalars::Interval;
use setrep::{HPolytope, Matrix, SetError, SupportFunction, Workspace};

use crate::common::random::Random;
use crate::oracle::{Q, dot, half_spaces, q, vertices};
use crate::samples::{ALL_ENTRIES, Entries, cases, h_polytope, v_polytope};

const SEED: u64 = 31;

/// Bounded by a box, or by the facets of a hull of points (no axis-aligned row), moved off the origin.
fn sample(random: &mut Random, case: usize, n: usize) -> HPolytope {
    let entries = ALL_ENTRIES[case % 3];
    let set = if case.is_multiple_of(2) {
        let extra = random.between(0, 4);
        h_polytope(random, n, extra, entries)
    } else {
        let m = random.between(n + 1, n + 4);
        v_polytope(random, n, m, entries).to_h_polytope().unwrap()
    };
    let shift = [0.0, 1.0, 1e3][random.below(3)];
    let offsets: Vec<f64> = (0..set.num_half_spaces())
        .map(|i| set.offsets()[i] + (0..n).map(|k| set.normals()[(i, k)] * shift).sum::<f64>())
        .collect();
    HPolytope::new(set.normals().clone(), &offsets).unwrap()
}

/// Supports, boxes and vectors over the exact vertices: never below the maximum, above it by rounding only.
#[test]
fn supports_reach_every_vertex() {
    let (mut workspace, mut points) = (Workspace::new(), Matrix::zeros(0, 0));
    for case in 0..cases(500) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 3);
        let set = sample(&mut random, case, n);
        let exact = vertices(&set);
        if exact.is_empty() {
            continue;
        }
        let hull = set.bounding_box(&mut workspace).unwrap();
        let size = hull.iter().map(Interval::mag).fold(0.0, f64::max);
        for (k, side) in hull.iter().enumerate() {
            let (lo, hi) = (exact.iter().map(|v| &v[k]).min().unwrap(), exact.iter().map(|v| &v[k]).max().unwrap());
            assert!(q(side.lo()) <= *lo && *hi <= q(side.hi()), "case {case} {side:?}");
            let excess = (lo - q(side.lo())).max(q(side.hi()) - hi);
            assert!(excess <= q(1e-11 * size), "case {case} {side:?} {set:?}");
        }
        let directions = random.matrix(n, 8);
        let values = set.support_vectors(&directions, &mut points, &mut workspace).unwrap();
        for (j, &value) in values.iter().enumerate() {
            let d: Vec<Q> = directions.col(j).iter().map(|&x| q(x)).collect();
            let largest = exact.iter().map(|v| dot(&d, v)).max().unwrap();
            assert!(q(value) >= largest, "case {case}: {value} {set:?}");
            let magnitude: f64 = directions.col(j).iter().zip(hull.iter()).map(|(d, side)| d.abs() * side.mag()).sum();
            assert!(q(value) - largest <= q(1e-10 * magnitude), "case {case}: {value} {set:?}");
            let x: Vec<Q> = points.col(j).iter().map(|&x| q(x)).collect();
            for (a, b) in half_spaces(&set) {
                let reach = a.iter().zip(hull.iter()).fold(Q::zero(), |sum, (a, side)| sum + a.abs() * q(side.mag()));
                assert!(dot(&a, &x) - b <= reach * q(1e-10), "case {case}: the vector is off by more than rounding");
            }
            assert!((q(value) - dot(&d, &x)).abs() <= q(1e-9 * magnitude), "case {case}");
        }
    }
}

/// The ball lies inside: `a'c <= h` and `r^2 |a|^2 <= (h - a'c)^2`, exactly; none is larger than the bound by far.
#[test]
fn balls_lie_inside_and_are_the_largest() {
    let mut workspace = Workspace::new();
    for case in 0..cases(600) {
        let mut random = Random::new(SEED + 1, case);
        let n = random.between(1, 5);
        let set = sample(&mut random, case, n);
        let ball = match set.chebyshev_ball(&mut workspace) {
            Ok(ball) => ball,
            Err(SetError::EmptySet) => {
                assert!(vertices(&set).is_empty(), "case {case}");
                continue;
            }
            Err(error) => panic!("case {case}: {error}"),
        };
        assert!(ball.radius <= ball.radius_bound, "case {case}");
        if ball.radius >= 0.0 {
            let c: Vec<Q> = ball.center.iter().map(|&x| q(x)).collect();
            for (a, b) in half_spaces(&set) {
                let slack = b - dot(&a, &c);
                assert!(!slack.is_negative() && q(ball.radius).pow(2) * dot(&a, &a) <= slack.pow(2), "case {case}");
            }
        }
        let size = set.bounding_box(&mut workspace).unwrap().iter().map(Interval::mag).fold(0.0, f64::max);
        assert!(ball.radius_bound - ball.radius <= 1e-11 * size, "case {case} {ball:?} {set:?}");
        if case % 4 == 0 {
            let (_, radius) = set.interior_point().unwrap();
            assert!(radius <= ball.radius_bound, "case {case}: {radius} {ball:?}");
        }
    }
}

/// Cubes, simplices and cones whose largest ball is known.
#[test]
fn known_balls() {
    let mut workspace = Workspace::new();
    for n in 1..=8_usize {
        let cube = HPolytope::from_intervals(&vec![Interval::point(3.0).inflate(2.0); n]).unwrap();
        let ball = cube.chebyshev_ball(&mut workspace).unwrap();
        assert!((ball.radius - 2.0).abs() < 1e-12 && ball.radius_bound >= 2.0 && ball.radius <= 2.0, "{ball:?}");
        // x >= 0, sum x <= 1: r = 1 / (n + sqrt n).
        let mut normals = Matrix::zeros(n + 1, n);
        for k in 0..n {
            normals[(k, k)] = -1.0;
            normals[(n, k)] = 1.0;
        }
        let mut offsets = vec![0.0; n + 1];
        offsets[n] = 1.0;
        let ball = HPolytope::new(normals, &offsets).unwrap().chebyshev_ball(&mut workspace).unwrap();
        let exact = 1.0 / (n as f64 + (n as f64).sqrt());
        assert!((ball.radius - exact).abs() < 1e-13 && ball.radius_bound >= ball.radius, "{n} {ball:?}");
    }
}

/// Rows dropped by programs are those dropped by the vertices, up to ties; the set stays, exactly.
#[test]
fn dropping_rows_keeps_the_set() {
    let mut workspace = Workspace::new();
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 2, case);
        let n = random.between(2, 3);
        let extra = random.between(2, 8);
        let set = h_polytope(&mut random, n, extra, ALL_ENTRIES[case % 3]);
        let slim = set.drop_redundant(&mut workspace).unwrap();
        assert_eq!(vertices(&set), vertices(&slim), "case {case}");
        let expected = set.remove_redundant().unwrap().num_half_spaces();
        assert!(slim.num_half_spaces() >= expected, "case {case}");
        if case % 3 != 1 {
            assert_eq!(slim.num_half_spaces(), expected, "case {case}: generic rows have no ties");
        }
    }
}

/// A thousand rows around a ball in six dimensions, and a thousand that cut off nothing.
#[test]
fn thousands_of_rows() {
    let (n, m) = (6, 1000);
    let mut random = Random::new(SEED, 99);
    let mut normals = Matrix::zeros(2 * m, n);
    let mut offsets = vec![1.0; 2 * m];
    for i in 0..2 * m {
        let row: Vec<f64> = (0..n).map(|_| random.moderate() + random.moderate()).collect();
        let length = row.iter().map(|x| x * x).sum::<f64>().sqrt();
        (0..n).for_each(|k| normals[(i, k)] = row[k] / length);
        // The cap of an outer row may stick out of the inner ones by chance: far enough it does not.
        offsets[i] = if i < m { 1.0 } else { 4.0 };
    }
    let set = HPolytope::new(normals, &offsets).unwrap();
    let mut workspace = Workspace::new();
    let slim = set.drop_redundant(&mut workspace).unwrap();
    assert_eq!(slim.num_half_spaces(), m, "each of the inner rows touches the ball, alone there");
    let ball = set.chebyshev_ball(&mut workspace).unwrap();
    assert!((ball.radius - 1.0).abs() < 1e-12 && ball.center.iter().all(|c| c.abs() < 1e-12), "{ball:?}");
    let hull = slim.bounding_box(&mut workspace).unwrap();
    assert!(hull.iter().all(|side| side.hi() > 1.0 && side.hi() < 1.5), "{hull:?}");
}

#[test]
fn degenerate_sets() {
    let mut workspace = Workspace::new();
    let rows = |rows: &[&[f64]], offsets: &[f64]| HPolytope::new(Matrix::from_rows(rows).unwrap(), offsets).unwrap();
    // Unbounded: a wedge, a half-plane, everything. No bound is claimed.
    let wedge = rows(&[&[1.0, 1.0], &[-1.0, 1.0]], &[0.0, 0.0]);
    assert!(wedge.bounding_box(&mut workspace).unwrap().iter().all(|side| !side.is_bounded() && !side.is_empty()));
    assert_eq!(SupportFunction::support(&wedge, &[0.0, -1.0], &mut workspace).unwrap(), f64::INFINITY);
    assert_eq!(wedge.chebyshev_ball(&mut workspace), Err(SetError::Unbounded));
    let everything = HPolytope::new(Matrix::zeros(0, 3), &[]).unwrap();
    assert_eq!(SupportFunction::support(&everything, &[0.0; 3], &mut workspace).unwrap(), 0.0);
    assert_eq!(wedge.drop_redundant(&mut workspace).unwrap(), wedge);
    // Empty, by an axis, by a gap between slanted rows, by a row of zeros.
    let empties = [
        rows(&[&[1.0, 0.0], &[-1.0, 0.0], &[0.0, 1.0], &[0.0, -1.0]], &[0.0, -1e-9, 1.0, 1.0]),
        rows(&[&[1.0, 1.0], &[-1.0, -1.0], &[1.0, -1.0], &[-1.0, 1.0]], &[0.0, -1e-6, 1.0, 1.0]),
        rows(&[&[1.0, 0.0], &[-1.0, 0.0], &[0.0, 1.0], &[0.0, -1.0], &[0.0, 0.0]], &[1.0, 1.0, 1.0, 1.0, -1e-3]),
    ];
    for empty in empties {
        assert_eq!(
            SupportFunction::support(&empty, &[1.0, 2.0], &mut workspace).unwrap(),
            f64::NEG_INFINITY,
            "{empty:?}"
        );
        assert_eq!(empty.chebyshev_ball(&mut workspace), Err(SetError::EmptySet), "{empty:?}");
    }
    // A row of zeros: nothing is rounded in 0 <= h, however large or small h is.
    for offset in [f64::MAX, f64::from_bits(1), 0.0] {
        let zeros =
            rows(&[&[1.0, 0.0], &[-1.0, 0.0], &[0.0, 1.0], &[0.0, -1.0], &[0.0, 0.0]], &[1.0, 1.0, 1.0, 1.0, offset]);
        let ball = zeros.chebyshev_ball(&mut workspace).unwrap();
        assert!((1.0 - 1e-12..=1.0).contains(&ball.radius) && ball.radius_bound >= 1.0, "{ball:?}");
    }
    // A point and a slanted segment far from the origin.
    let far = 1e6;
    let point = rows(&[&[1.0, 1.0], &[-1.0, -1.0], &[1.0, -1.0], &[-1.0, 1.0]], &[2.0 * far, -2.0 * far, 0.0, 0.0]);
    let hull = point.bounding_box(&mut workspace).unwrap();
    assert!(hull.contains(&[far, far]) && hull.iter().all(|side| side.width() < 1e-8), "{hull:?}");
    let ball = point.chebyshev_ball(&mut workspace).unwrap();
    assert!(ball.radius.abs() < 1e-8 && (0.0..1e-8).contains(&ball.radius_bound), "{ball:?}");
    assert_eq!(point.drop_redundant(&mut workspace).unwrap().num_half_spaces(), 4);
    // Scales of 1e-8 and 1e8 in one set.
    let mixed = rows(&[&[1e8, 1e-8], &[-1e8, 1e-8], &[0.0, -1.0]], &[1.0, 1.0, 0.0]);
    let hull = mixed.bounding_box(&mut workspace).unwrap();
    assert!(hull.contains(&[1e-8, 0.0]) && hull.contains(&[0.0, 1e8]), "{hull:?}");
    assert!(hull[0].width() < 2.0001e-8 && hull[1].width() < 1.0001e8, "{hull:?}");
}

#[test]
fn generic_sets_are_sampled() {
    // The other batteries take sets of every kind; so that none of them is void by chance:
    let mut random = Random::new(SEED, 0);
    let set = h_polytope(&mut random, 3, 4, Entries::Generic);
    assert!(vertices(&set).len() >= 6);
}
