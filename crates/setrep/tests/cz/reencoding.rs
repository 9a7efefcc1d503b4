//! LP re-encoding: containment, size of the result, tightness, degenerate sets.

use scalars::Interval;
use setrep::{
    Complexity, ConstrainedZonotope, Directions, HPolytope, IntervalMatrix, Matrix, Reduction, Reencoding, SetError,
    TemplateWidths, Workspace, Zonotope,
};

use crate::SEED;
use crate::common::exact::lies_in;
use crate::common::random::{Random, cases};
use crate::member::{assert_not_refuted, constrained};

/// Options and candidate directions of one case.
fn settings(random: &mut Random, n: usize, case: usize) -> (Reencoding, Directions) {
    let mut options = Reencoding::new(random.below(2 * n + 2));
    if case.is_multiple_of(3) {
        options.widths = TemplateWidths::LinearPrograms;
    }
    let mut directions = Directions::new(n);
    for _ in 0..random.below(4) {
        let direction: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        directions.push(&direction).unwrap();
    }
    (options, directions)
}

#[test]
fn reencodings_contain_the_set_within_the_limit() {
    let mut workspace = Workspace::new();
    let mut stripped = 0;
    for case in 0..cases(6_000) {
        let mut random = Random::new(SEED + 60, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 12), random.between(0, 6));
        let (set, member) = constrained(&mut random, n, m, rows);
        let (options, mut directions) = settings(&mut random, n, case);
        let mut result = set.clone();
        result.reencode(options, &mut directions, &mut workspace).unwrap();
        assert!(result.num_generators() <= n && result.num_constraints() <= options.constraints);
        assert_eq!(directions.len(), result.num_constraints());
        let context = || format!("seed {SEED}+60 case {case}: {options:?} {set:?} {result:?} {member:?}");
        assert!(lies_in(result.unconstrained(), &member.x), "outside the parallelotope: {}", context());
        assert_not_refuted(&result, &member.x, &mut random, &mut workspace, &context);
        let (hull, body) = (set.interval_hull(&mut workspace).unwrap(), set.unconstrained().interval_hull());
        for (k, side) in hull.iter().enumerate() {
            // Of rounding size.
            assert!(result.remainder()[k] <= 2e-10 * side.rad() + 1e-13 * body[k].mag(), "remainder: {}", context());
        }
        let bare = Zonotope::new(result.center(), result.generators()).unwrap();
        stripped += usize::from(!lies_in(&bare, &member.x));
    }
    assert!(stripped > cases(6_000) / 50, "only {stripped} cases need the remainder");
}

/// A set with random generators and bands, of the size of the papers' examples.
fn moderate_set(random: &mut Random, n: usize, m: usize, rows: usize) -> ConstrainedZonotope {
    let mut matrix = |rows: usize, cols: usize| {
        let entries: Vec<f64> = (0..rows * cols).map(|_| random.moderate()).collect();
        Matrix::from_column_slice(rows, cols, &entries).unwrap()
    };
    let (g, a) = (matrix(n, m), matrix(rows, m));
    let band = |k: usize| Interval::point(0.0).inflate(0.25 + 0.25 * k as f64);
    ConstrainedZonotope::new(&vec![0.0; n], &g, &a, &(0..rows).map(band).collect::<Vec<_>>()).unwrap()
}

/// The area of the polygon of 32 support directions.
fn area(set: &ConstrainedZonotope, workspace: &mut Workspace) -> f64 {
    let mut optimizer = set.optimizer(workspace).unwrap();
    let (mut normals, mut offsets) = (Matrix::zeros(32, 2), Vec::new());
    for k in 0..32 {
        let (sin, cos) = (f64::from(k as u32) * core::f64::consts::PI / 16.0).sin_cos();
        (normals[(k, 0)], normals[(k, 1)]) = (cos, sin);
        offsets.push(optimizer.support(&[cos, sin]).unwrap());
    }
    HPolytope::new(normals, &offsets).unwrap().volume().unwrap().mid()
}

/// Beside Scott's elimination with Method 4 at the papers' complexity (four times the generators): hull and area relative to the set.
#[test]
fn reencodings_are_tighter_than_eliminations() {
    let mut workspace = Workspace::new();
    let (mut areas, mut hulls, count) = ([0.0; 3], [0.0; 3], 200);
    for case in 0..count {
        let set = moderate_set(&mut Random::new(SEED + 61, case), 2, 14, 6);
        let mut scott = set.clone();
        scott.reduce(Complexity { generators: 8, constraints: 3 }, Reduction::Method4, &mut workspace).unwrap();
        let mut reencoded = [set.clone(), set.clone()];
        for (set, widths) in reencoded.iter_mut().zip([TemplateWidths::SingleRows, TemplateWidths::LinearPrograms]) {
            // The candidates a filter has: directions of earlier steps.
            let mut directions = Directions::new(2);
            for k in 0..8 {
                let (sin, cos) = (f64::from(k) * core::f64::consts::PI / 8.0).sin_cos();
                directions.push(&[cos, sin]).unwrap();
            }
            set.reencode(Reencoding { widths, ..Reencoding::new(3) }, &mut directions, &mut workspace).unwrap();
            assert!(set.num_generators() == 2 && set.num_constraints() <= 3);
        }
        let before = (area(&set, &mut workspace), set.interval_hull(&mut workspace).unwrap());
        for (k, reduced) in [&scott, &reencoded[0], &reencoded[1]].into_iter().enumerate() {
            areas[k] += area(reduced, &mut workspace) / before.0;
            let hull = reduced.interval_hull(&mut workspace).unwrap();
            hulls[k] += hull.iter().zip(before.1.iter()).map(|(a, b)| a.width() / b.width()).sum::<f64>() / 2.0;
        }
    }
    let (areas, hulls) = (areas.map(|x| x / count as f64), hulls.map(|x| x / count as f64));
    eprintln!("Scott + Method 4, re-encoding by rows, by programs: area {areas:.3?}, hull {hulls:.3?}");
    assert!(areas[1] < 0.95 * areas[0] && hulls[1] < hulls[0], "{areas:?} {hulls:?}");
    assert!(areas[2] < areas[1] + 0.02 && areas[2] > 0.999 && hulls[2] > 1.0 - 1e-9, "{areas:?} {hulls:?}");
}

/// A parallelotope with a strip is its own re-encoding, in every dimension: nothing is lost but rounding.
#[test]
fn sets_of_the_form_are_kept() {
    let mut workspace = Workspace::new();
    for case in 0..200 {
        let mut random = Random::new(SEED + 62, case);
        let n = random.between(1, 5);
        let mut set = moderate_set(&mut random, n, n, 0);
        let strip: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let width = set.support(&strip, &mut workspace).unwrap();
        set.intersect_strip(&strip, Interval::new(-0.5 * width, 0.25 * width).unwrap(), &mut workspace).unwrap();
        let mut directions = Directions::new(n);
        directions.push(&strip).unwrap();
        let mut result = set.clone();
        result.reencode(Reencoding::new(n + 1), &mut directions, &mut workspace).unwrap();
        for _ in 0..20 {
            let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
            let (before, after) =
                (set.support(&d, &mut workspace).unwrap(), result.support(&d, &mut workspace).unwrap());
            let size = set.unconstrained().support(&d).unwrap().abs();
            // The ratio at which the choice stops leaves up to 2 % along a candidate; a frame of slivers is refused.
            assert!(after <= before + 0.05 * size, "seed {SEED}+62 case {case}: {before} {after} of {size}: {set:?}");
        }
    }
}

#[test]
fn degenerate_sets_are_reencoded() {
    let mut workspace = Workspace::new();
    let (g, a) = (Matrix::identity(2), Matrix::identity(2));
    let point = ConstrainedZonotope::from_box(&[1.0, 2.0], &[0.0, 0.0]).unwrap();
    let pinned = ConstrainedZonotope::from_cg_rep(&[1.0, 2.0], &g, &a, &[0.5, -0.5]).unwrap();
    let flat = Matrix::from_rows(&[&[1.0, 2.0, 3.0, 1.0], &[1.0, 2.0, 3.0, 1.0]]).unwrap();
    let row = Matrix::from_rows(&[&[1.0, -1.0, 1.0, 0.0]]).unwrap();
    let flat = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &flat, &row, &[0.5]).unwrap();
    let axis = Matrix::from_rows(&[&[1.0, 2.0, 3.0, 1.0], &[0.0; 4]]).unwrap();
    let axis = ConstrainedZonotope::from_cg_rep(&[3.0, 7.0], &axis, &row, &[0.5]).unwrap();
    for (set, generators) in [(point, 0), (pinned, 0), (flat, 1), (axis, 1)] {
        for constraints in [0, 3] {
            let mut result = set.clone();
            let mut directions = Directions::new(2);
            directions.push(&[0.0, 0.0]).unwrap();
            directions.push(&[1.0, -1.0]).unwrap();
            result.reencode(Reencoding::new(constraints), &mut directions, &mut workspace).unwrap();
            assert!(result.num_generators() == generators && result.num_constraints() <= constraints, "{result:?}");
            for d in [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]] {
                let (before, after) = (set.support(&d, &mut workspace), result.support(&d, &mut workspace));
                assert!(after.unwrap() <= before.unwrap() + 1e-13, "{d:?} {set:?} {result:?}");
            }
        }
    }
}

#[test]
fn empty_sets_stay_empty_if_a_constraint_is_allowed() {
    let mut workspace = Workspace::new();
    let (g, a) = (Matrix::identity(2), Matrix::from_rows(&[&[1.0, 1.0], &[1.0, -0.5]]).unwrap());
    let empty = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &g, &a, &[1.75, -1.25]).unwrap();
    for constraints in [0, 1, 4] {
        let mut result = empty.clone();
        result.reencode(Reencoding::new(constraints), &mut Directions::new(2), &mut workspace).unwrap();
        assert!(result.num_generators() == 0 && result.num_constraints() <= constraints);
        assert_eq!(result.is_proven_empty(&mut workspace).unwrap(), constraints > 0);
    }
}

/// A rotating set with bounded noise and measurements of one coordinate keeps its size for hundreds of steps.
#[test]
fn a_filter_of_reencodings_stays_bounded() {
    let mut workspace = Workspace::new();
    let turn = Matrix::from_rows(&[&[0.8, -0.6], &[0.6, 0.8]]).unwrap();
    let noise = ConstrainedZonotope::from_box(&[0.0, 0.0], &[0.01, 0.01]).unwrap();
    let row = Matrix::from_rows(&[&[1.0, 0.0]]).unwrap();
    let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let mut directions = Directions::new(2);
    let mut radius = 0.0;
    for _ in 0..300 {
        set.interval_map_in_place(
            &IntervalMatrix::point(turn.clone()).unwrap(),
            &[Interval::ENTIRE; 2],
            &mut workspace,
        )
        .unwrap();
        directions.transport(&turn, &mut workspace).unwrap();
        set.add_assign(&noise).unwrap();
        set.intersect_rows(&row, &[Interval::point(0.0).inflate(0.05)], &mut workspace).unwrap();
        directions.push_rows(&row).unwrap();
        set.reencode(Reencoding::new(3), &mut directions, &mut workspace).unwrap();
        radius = set.interval_hull(&mut workspace).unwrap().iter().map(Interval::rad).fold(0.0, f64::max);
        assert!(set.num_generators() <= 2 && set.num_constraints() <= 3 && directions.len() <= 3);
    }
    // The strip, turned once and widened by noise, bounds the other coordinate: (0.05 + 0.8 * 0.05 + noise) / 0.6.
    assert!((0.05..0.18).contains(&radius), "{radius}");
    assert!(set.remainder().iter().all(|&r| r < 1e-12));
}

#[test]
fn bad_input_is_refused() {
    let mut workspace = Workspace::new();
    let set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let mut result = set.clone();
    let refused = result.reencode(Reencoding::new(1), &mut Directions::new(3), &mut workspace);
    assert!(matches!(refused, Err(SetError::Dimension { .. })));
    let mut huge = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1e308, 1.0]).unwrap();
    let refused = huge.reencode(Reencoding::new(1), &mut Directions::new(2), &mut workspace);
    assert!(matches!(refused, Err(SetError::Overflow { .. })));
    let mut directions = Directions::new(2);
    assert!(directions.push(&[1.0]).is_err() && directions.push(&[f64::NAN, 1.0]).is_err());
    assert!(directions.push_rows(&Matrix::zeros(1, 3)).is_err());
    assert!(directions.transport(&Matrix::zeros(2, 3), &mut workspace).is_err());
    assert!(directions.transport(&Matrix::zeros(0, 2), &mut workspace).is_err());
    assert!(directions.is_empty() && directions.dim() == 2);
    // A map to fewer dimensions, and a singular one.
    directions.push(&[1.0, 1.0]).unwrap();
    directions.transport(&Matrix::from_rows(&[&[1.0, 1.0]]).unwrap(), &mut workspace).unwrap();
    assert!(directions.dim() == 1 && (directions.iter().next().unwrap()[0] - 1.0).abs() < 1e-9);
    directions.transport(&Matrix::zeros(2, 1), &mut workspace).unwrap();
    assert_eq!(directions.dim(), 2);
}
