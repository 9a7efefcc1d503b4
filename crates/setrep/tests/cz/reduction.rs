use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Reduction, SetError, Workspace};

use crate::SEED;
use crate::common::random::{Random, cases};
use crate::member::{assert_not_refuted, constrained};

const METHODS: [Reduction; 4] = [Reduction::Method4, Reduction::Girard, Reduction::Combastel, Reduction::Pca];

#[test]
fn eliminations_contain_the_set() {
    let mut workspace = Workspace::new();
    for case in 0..cases(3_000) {
        let mut random = Random::new(SEED + 50, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 8), random.between(1, 5));
        let (set, member) = constrained(&mut random, n, m, rows);
        let limit = random.below(rows);
        let mut reduced = set.clone();
        reduced.eliminate_constraints(limit, &mut workspace).unwrap();
        assert!(reduced.num_constraints() <= limit && reduced.num_generators() <= m);
        let context = || format!("seed {SEED}+50 case {case}: {set:?} {reduced:?} {member:?}");
        assert_not_refuted(&reduced, &member.x, &mut random, &mut workspace, &context);
    }
}

#[test]
fn reductions_contain_the_set_within_the_limit() {
    let mut workspace = Workspace::new();
    for case in 0..cases(4_000) {
        let mut random = Random::new(SEED + 51, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 12), random.between(0, 5));
        let (set, member) = constrained(&mut random, n, m, rows);
        let limit = Complexity { generators: n + random.below(6), constraints: random.below(4) };
        let mut reduced = set.clone();
        reduced.reduce(limit, METHODS[case % 4], &mut workspace).unwrap();
        assert!(reduced.num_generators() <= limit.generators && reduced.num_constraints() <= limit.constraints);
        let context = || format!("seed {SEED}+51 case {case}: {limit:?} {set:?} {reduced:?} {member:?}");
        assert_not_refuted(&reduced, &member.x, &mut random, &mut workspace, &context);
        // The remainder grows by rounding only.
        for k in 0..n {
            let extent: f64 = set.generators().columns().map(|g| g[k].abs()).sum::<f64>() + set.center()[k].abs();
            let growth = reduced.remainder()[k] - set.remainder()[k];
            assert!(growth <= 1e-6 * extent + 1e-12 * set.remainder()[k], "{growth:e} of {extent:e}: {}", context());
        }
    }
}

/// The notes' example: a set of area 11 has area 22 without its constraint.
#[test]
fn one_elimination_doubles_the_area() {
    let generators = Matrix::from_rows(&[&[1.5, -1.5, 0.5], &[1.0, 0.5, -1.0]]).unwrap();
    let rows = Matrix::from_rows(&[&[1.0, 1.0, 1.0]]).unwrap();
    let mut set = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &generators, &rows, &[1.0]).unwrap();
    let mut workspace = Workspace::new();
    set.eliminate_constraints(0, &mut workspace).unwrap();
    let body = set.unconstrained();
    let g = body.generators();
    assert_eq!((g.cols(), set.num_constraints()), (2, 0));
    let area = 4.0 * (g[(0, 0)] * g[(1, 1)] - g[(0, 1)] * g[(1, 0)]).abs();
    assert!((area - 22.0).abs() < 1e-12, "area {area}: {body:?}");
    assert!(body.remainder().iter().all(|&r| r < 1e-15));
}

/// A constraint that does not bind costs nothing; a binding one is kept while another can go.
#[test]
fn the_least_important_bound_goes_first() {
    let mut workspace = Workspace::new();
    let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    set.intersect_half_space(&[1.0, 1.0], 0.0, &mut workspace).unwrap();
    set.intersect_half_space(&[1.0, -1.0], 1.999, &mut workspace).unwrap();
    let h = set.support(&[1.0, 1.0], &mut workspace).unwrap();
    set.eliminate_constraints(1, &mut workspace).unwrap();
    assert!(set.support(&[1.0, 1.0], &mut workspace).unwrap() <= h + 1e-12);
    assert!(set.support(&[1.0, -1.0], &mut workspace).unwrap() <= 2.0 + 1e-12);
}

/// Mean growth of the hull's half-widths on sets of the size of the papers' examples: what a bad choice would break.
#[test]
fn reductions_lose_little() {
    let mut workspace = Workspace::new();
    let (mut growth, mut count) = ([0.0; 4], 0.0);
    for case in 0..100 {
        let mut random = Random::new(SEED + 52, case);
        let mut matrix = |rows: usize, cols: usize| {
            let entries: Vec<f64> = (0..rows * cols).map(|_| random.moderate()).collect();
            Matrix::from_column_slice(rows, cols, &entries).unwrap()
        };
        let (g, a) = (matrix(2, 14), matrix(6, 14));
        let band = |k: usize| Interval::point(0.0).inflate(0.25 + 0.25 * k as f64);
        let set = ConstrainedZonotope::new(&[0.0, 0.0], &g, &a, &(0..6).map(band).collect::<Vec<_>>()).unwrap();
        let before = set.interval_hull(&mut workspace).unwrap();
        for (total, method) in growth.iter_mut().zip(METHODS) {
            let mut reduced = set.clone();
            reduced.reduce(Complexity { generators: 8, constraints: 3 }, method, &mut workspace).unwrap();
            let after = reduced.interval_hull(&mut workspace).unwrap();
            *total += before.iter().zip(after.iter()).map(|(b, a)| a.width() / b.width()).sum::<f64>() / 2.0;
        }
        count += 1.0;
    }
    let mean = growth.map(|sum| sum / count);
    eprintln!("mean growth of the hull (Method4, Girard, Combastel, PCA): {mean:.3?}");
    assert!(mean.iter().all(|&g| (1.0..2.0).contains(&g)), "{mean:?}");
}

#[test]
fn degenerate_sets_reduce() {
    let mut workspace = Workspace::new();
    let tight = Complexity { generators: 2, constraints: 0 };
    // A point, a point by constraints, a flat set, an empty set.
    let point = ConstrainedZonotope::from_box(&[1.0, 2.0], &[0.0, 0.0]).unwrap();
    let (g, a) = (Matrix::identity(2), Matrix::identity(2));
    let pinned = ConstrainedZonotope::from_cg_rep(&[1.0, 2.0], &g, &a, &[0.5, -0.5]).unwrap();
    let flat = Matrix::from_rows(&[&[1.0, 2.0, 3.0, 1.0], &[0.0; 4]]).unwrap();
    let row = Matrix::from_rows(&[&[1.0, -1.0, 1.0, 0.0]]).unwrap();
    let flat = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &flat, &row, &[0.5]).unwrap();
    let empty = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &g, &a, &[0.5, 2.0]).unwrap();
    for (set, radius) in [(point, 0.0), (pinned, 0.0), (flat, 7.0), (empty, f64::INFINITY)] {
        for method in METHODS {
            let mut reduced = set.clone();
            reduced.reduce(tight, method, &mut workspace).unwrap();
            assert!(reduced.num_generators() <= 2 && reduced.num_constraints() == 0);
            assert!(reduced.unconstrained().radius() <= radius + 1e-12, "{set:?} {reduced:?}");
        }
        let few = Complexity { generators: 1, constraints: 0 };
        let refused = set.clone().reduce(few, Reduction::Girard, &mut workspace);
        assert_eq!(refused, Err(SetError::TooFewGenerators { max_generators: 1, dim: 2 }));
    }
}
