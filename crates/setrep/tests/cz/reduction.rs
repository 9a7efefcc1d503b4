//! Constraint elimination, generator reduction and the complexity limit.

use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Reduction, SetError, Workspace, Zonotope};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::times;
use crate::common::random::{Random, cases};
use crate::member::{assert_not_refuted, constrained, is_constrained_witness};

const METHODS: [Reduction; 4] = [Reduction::Method4, Reduction::Girard, Reduction::Combastel, Reduction::Pca];

#[test]
fn eliminations_contain_the_set() {
    let mut workspace = Workspace::new();
    for case in 0..cases(7_500) {
        let mut random = Random::new(SEED + 50, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 8), random.between(1, 5));
        let (set, member) = constrained(&mut random, n, m, rows);
        let limit = random.below(rows);
        let mut reduced = set.clone();
        reduced.eliminate_comparing(limit, case % 4, &mut workspace).unwrap();
        assert!(reduced.num_constraints() <= limit && reduced.num_generators() <= m);
        let context = || format!("seed {SEED}+50 case {case}: {set:?} {reduced:?} {member:?}");
        assert_not_refuted(&reduced, &member.x, &mut random, &mut workspace, &context);
    }
}

#[test]
fn reductions_contain_the_set_within_the_limit() {
    let mut workspace = Workspace::new();
    for case in 0..cases(10_000) {
        let mut random = Random::new(SEED + 51, case);
        let (n, m, rows) = (random.between(1, 4), random.between(0, 12), random.between(0, 5));
        let (set, member) = constrained(&mut random, n, m, rows);
        let limit = Complexity { generators: n + random.below(6), constraints: random.below(4) };
        let mut reduced = set.clone();
        reduced.reduce_comparing(limit, METHODS[case % 4], case % 3, &mut workspace).unwrap();
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
    // Roundings are bounded by 2^-53 of the products and differences, which are less than 32 in all.
    assert!(body.remainder().iter().all(|&r| r < 4e-15));
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

/// A single elimination by comparison leaves no larger hull than that by the estimate, and many are far smaller.
#[test]
fn comparing_candidates_pays() {
    let mut workspace = Workspace::new();
    let (mut sum, mut count) = (0.0, 0.0);
    for case in 0..cases(100) {
        let mut random = Random::new(SEED + 54, case);
        let (n, m, rows) = (3, 15, 5);
        let mut matrix = |rows: usize, cols: usize| {
            let entries: Vec<f64> = (0..rows * cols).map(|_| random.moderate()).collect();
            Matrix::from_column_slice(rows, cols, &entries).unwrap()
        };
        let (g, a) = (matrix(n, m), matrix(rows, m));
        let band = Interval::point(0.0).inflate(0.25);
        let set = ConstrainedZonotope::new(&vec![0.0; n], &g, &a, &vec![band; rows]).unwrap();
        let extents: Vec<f64> = set.unconstrained().interval_hull().iter().map(Interval::rad).collect();
        let mut size = |candidates: usize| -> f64 {
            let mut reduced = set.clone();
            reduced.eliminate_comparing(rows - 1, candidates, &mut workspace).unwrap();
            let hull = reduced.interval_hull(&mut workspace).unwrap();
            hull.iter().zip(&extents).map(|(side, extent)| side.rad() / extent).sum()
        };
        let (estimated, of_four, of_all) = (size(1), size(4), size(m + rows));
        assert!(of_four <= estimated * (1.0 + 1e-9) && of_all <= of_four * (1.0 + 1e-9), "case {case}");
        sum += of_four / estimated;
        count += 1.0;
    }
    let mean = sum / count;
    eprintln!("mean ratio of the hulls: {mean:.3}");
    assert!(mean < 0.99, "{mean}");
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
            let mut compared = set.clone();
            compared.reduce_comparing(tight, method, 9, &mut workspace).unwrap();
            assert!(compared.unconstrained().radius() <= radius + 1e-12, "{set:?} {compared:?}");
        }
        let few = Complexity { generators: 1, constraints: 0 };
        let refused = set.clone().reduce(few, Reduction::Girard, &mut workspace);
        assert_eq!(refused, Err(SetError::TooFewGenerators { max_generators: 1, dim: 2 }));
    }
}

/// Sets that rescaling leaves alone, with exact equalities: the coordinates of a member but one prove it a member of the set with one
/// constraint fewer, in exact arithmetic. Without the rounding of the elimination they do not.
#[test]
fn one_elimination_has_an_exact_witness() {
    let mut workspace = Workspace::new();
    let (mut stripped, total) = (0, cases(5_000));
    for case in 0..total {
        let mut random = Random::new(SEED + 53, case);
        let (n, m, rows) = (random.between(1, 3), 8, random.between(1, 2));
        let mut grid = |count: usize| -> Vec<f64> {
            (0..count).map(|_| (32 + random.below(33)) as f64 / 64.0 * [1.0, -1.0][random.below(2)]).collect()
        };
        let a = Matrix::from_column_slice(rows, m, &grid(rows * m)).unwrap();
        let xi: Vec<f64> = (0..m).map(|_| (random.below(7) as f64 - 3.0) / 16.0).collect();
        let mut entries = |count: usize| -> Vec<f64> { (0..count).map(|_| random.moderate()).collect() };
        let (center, g) = (entries(n), Matrix::from_column_slice(n, m, &entries(n * m)).unwrap());
        let b: Vec<f64> = times(&a, &xi).iter().map(Dyadic::approx).collect();
        let set = ConstrainedZonotope::from_cg_rep(&center, &g, &a, &b).unwrap();
        let mut x = times(&g, &xi);
        x.iter_mut().zip(&center).for_each(|(x, &c)| *x += &Dyadic::from(c));
        assert!(is_constrained_witness(&set, &xi, &x));
        let mut reduced = set.clone();
        reduced.eliminate_constraints(rows - 1, &mut workspace).unwrap();
        assert_eq!((reduced.num_generators(), reduced.num_constraints()), (m - 1, rows - 1));
        let proves = |reduced: &ConstrainedZonotope| {
            (0..m).any(|j| {
                let rest: Vec<f64> = (0..m).filter(|&k| k != j).map(|k| xi[k]).collect();
                is_constrained_witness(reduced, &rest, &x)
            })
        };
        assert!(proves(&reduced), "seed {SEED}+53 case {case}: {set:?} {reduced:?} {xi:?}");
        let bare = Zonotope::new(reduced.center(), reduced.generators()).unwrap();
        let bare = ConstrainedZonotope::with_constraints(&bare, reduced.constraints(), reduced.ranges()).unwrap();
        stripped += usize::from(!proves(&bare));
    }
    assert!(2 * stripped > total, "only {stripped} of {total} need the remainder");
}

/// What the reduction of the lifted zonotope adds to its remainder widens the remainder and the ranges.
#[test]
fn rounding_of_the_lift_is_kept() {
    let mut workspace = Workspace::new();
    let mut widened = 0;
    for case in 0..cases(200) {
        let mut random = Random::new(SEED + 54, case);
        let (n, m, rows) = (2, 9, 2);
        let mut entries = |count: usize| -> Vec<f64> { (0..count).map(|_| random.moderate()).collect() };
        let g = Matrix::from_column_slice(n, m, &entries(n * m)).unwrap();
        let a = Matrix::from_column_slice(rows, m, &entries(rows * m)).unwrap();
        let set = ConstrainedZonotope::from_cg_rep(&[0.5, -0.5], &g, &a, &[0.25, 0.0]).unwrap();
        let columns: Vec<Vec<f64>> = g.columns().zip(a.columns()).map(|(g, a)| [g, a].concat()).collect();
        let lift = Matrix::from_columns(&columns.iter().map(Vec::as_slice).collect::<Vec<_>>()).unwrap();
        let mut lift = Zonotope::new(&[0.5, -0.5, 0.0, 0.0], &lift).unwrap();
        let mut reduced = set.clone();
        let method = METHODS[[0, 3][case % 2]];
        lift.reduce(method, 6, &mut workspace).unwrap();
        reduced.reduce_generators(method, 6, &mut workspace).unwrap();
        assert!(reduced.num_generators() <= 6);
        for i in 0..n {
            assert!(reduced.remainder()[i] >= lift.remainder()[i]);
        }
        for i in 0..rows {
            let widening = lift.remainder()[n + i];
            assert!(set.ranges()[i].inflate(widening).subset_of(&reduced.ranges()[i]), "seed {SEED}+54 case {case}");
            widened += usize::from(widening > 0.0);
        }
    }
    assert!(widened > cases(200), "{widened}");
}
