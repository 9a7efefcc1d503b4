//! The linear filter: against programs over the whole history, exact truths, the textbook form and other filters; bad input, allocations.

use estimators::{
    Culprit, Estimator, EstimatorError, LinearCz, LinearOptions, LinearSystem, NoiseForm, Rcz, RczOptions, Relation,
    System,
};
use microlp::{ComparisonOp, OptimizationDirection, Problem, Variable};
use nonlin_bounds::function;
use num_rational::BigRational;
use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Membership, SetError, Workspace, Zonotope};

use crate::plants::cube;
use crate::support::{Random, cases};

/// Two states that stay where they are, each measured with an error up to `error`.
pub(crate) fn resting(error: f64) -> System {
    let stay = function!(|[x, y, w]: 3| -> 2 { [x + w, y] });
    let seen = function!(|[x, y, v, w]: 4| -> 2 { [x + v, y + w] });
    System::new(Relation::new(stay), cube(1, 0.0), Relation::new(seen), cube(2, error)).unwrap()
}

/// A number on the grid of eighths in `[-1, 1]`: a few steps of the system are then exact in `f64`.
fn grid(random: &mut Random) -> f64 {
    (8.0 * random.unit()).round() / 8.0
}

fn matrix(rows: usize, cols: usize, random: &mut Random) -> Matrix {
    let data: Vec<f64> = (0..rows * cols).map(|_| grid(random)).collect();
    Matrix::from_column_slice(rows, cols, &data).unwrap()
}

/// Noises: a box, generators that mix, or a box that is cut.
fn noise(n: usize, radius: f64, kind: usize, random: &mut Random) -> ConstrainedZonotope {
    let mut set = ConstrainedZonotope::from_box(&vec![0.0; n], &vec![radius; n]).unwrap();
    match kind {
        0 => {}
        1 => {
            let mut generators = matrix(n, n + 1, random);
            generators.as_mut_slice().iter_mut().for_each(|g| *g *= radius);
            set = Zonotope::new(&vec![0.0; n], &generators).unwrap().into();
        }
        _ => set.intersect_half_space(&vec![1.0; n], 0.5 * radius, &mut Workspace::new()).unwrap(),
    }
    set
}

/// A member of a set, on the grid of its coordinates.
fn draw(set: &ConstrainedZonotope, random: &mut Random) -> Vec<f64> {
    loop {
        let xi: Vec<f64> = (0..set.num_generators()).map(|_| grid(random)).collect();
        let row = |i: usize| -> f64 { set.constraints().columns().zip(&xi).map(|(a, x)| a[i] * x).sum() };
        if (0..set.num_constraints()).all(|i| set.ranges()[i].contains(row(i))) {
            let mut x = set.center().to_vec();
            for (g, xi) in set.generators().columns().zip(&xi) {
                x.iter_mut().zip(g).for_each(|(x, g)| *x += g * xi);
            }
            x.iter_mut().zip(set.remainder()).for_each(|(x, r)| *x += r * grid(random));
            return x;
        }
    }
}

fn times(m: &Matrix, x: &[f64]) -> Vec<f64> {
    (0..m.rows()).map(|i| x.iter().enumerate().map(|(k, x)| m[(i, k)] * x).sum()).collect()
}

fn sum<const N: usize>(terms: [&[f64]; N]) -> Vec<f64> {
    let exact = |x: f64| BigRational::from_float(x).unwrap();
    let sum = |i: usize| terms.iter().fold(0.0, |sum, term| sum + term[i]);
    for i in 0..terms[0].len() {
        let whole = terms.iter().fold(exact(0.0), |sum, term| sum + exact(term[i]));
        assert_eq!(exact(sum(i)), whole, "the run is not exact");
    }
    (0..terms[0].len()).map(sum).collect()
}

/// A random system and a run of it that is exact in `f64`.
struct Run {
    system: LinearSystem,
    start: ConstrainedZonotope,
    inputs: Vec<Vec<f64>>,
    truth: Vec<Vec<f64>>,
    outputs: Vec<Vec<Option<f64>>>,
}

fn simulate(seed: u64, steps: usize) -> Run {
    let random = &mut Random::new(seed);
    let (n, m, q) = (2 + random.below(2), 1 + random.below(2), random.below(2));
    let (w, v) = (noise(2, 0.125, random.below(3), random), noise(m, 0.25, random.below(3), random));
    let system = LinearSystem {
        a: matrix(n, n, random),
        b_u: matrix(n, q, random),
        b_w: matrix(n, 2, random),
        w,
        c: matrix(m, n, random),
        d_u: matrix(m, q, random),
        d_v: if random.below(2) == 0 { Matrix::identity(m) } else { matrix(m, m, random) },
        v,
        e: Matrix::default(),
        d: Vec::new(),
    };
    let start = ConstrainedZonotope::from_box(&vec![0.5; n], &vec![1.0; n]).unwrap();
    let mut x = draw(&start, random);
    let (mut inputs, mut truth, mut outputs) = (vec![], vec![], vec![]);
    for _ in 0..=steps {
        let u: Vec<f64> = (0..q).map(|_| grid(random)).collect();
        let error = times(&system.d_v, &draw(&system.v, random));
        let y = sum([&times(&system.c, &x), &times(&system.d_u, &u), &error]);
        outputs.push(y.iter().map(|&y| (random.below(5) > 0).then_some(y)).collect());
        truth.push(x.clone());
        let push = times(&system.b_w, &draw(&system.w, random));
        x = sum([&times(&system.a, &x), &times(&system.b_u, &u), &push]);
        inputs.push(u);
    }
    Run { system, start, inputs, truth, outputs }
}

/// The filter at the end of a run; the truth lies in every set and hull, exactly.
fn filtered(run: &Run, options: LinearOptions) -> LinearCz {
    let mut filter = LinearCz::new(run.system.clone(), run.start.clone(), options).unwrap();
    let mut workspace = Workspace::new();
    for (k, y) in run.outputs.iter().enumerate() {
        if k > 0 {
            filter.predict(&run.inputs[k - 1]).unwrap();
        }
        filter.update_some(y, &run.inputs[k]).unwrap();
        let hull = filter.hull();
        assert!(hull.iter().zip(&run.truth[k]).all(|(side, &x)| side.contains(x)), "{hull:?} {:?}", run.truth[k]);
        let point: Vec<Interval> = run.truth[k].iter().map(|&x| Interval::point(x)).collect();
        assert_ne!(filter.enclosure().membership(&point, &mut workspace).unwrap(), Membership::ProvenOutside);
    }
    filter
}

/// New variables that are the point of a set, as its generators' coordinates and remainder say.
fn point_of(lp: &mut Problem, set: &ConstrainedZonotope) -> Vec<Vec<(Variable, f64)>> {
    let xi: Vec<Variable> = (0..set.num_generators()).map(|_| lp.add_var(0.0, (-1.0, 1.0))).collect();
    for (i, range) in set.ranges().iter().enumerate() {
        let row: Vec<(Variable, f64)> = xi.iter().zip(set.constraints().columns()).map(|(&x, a)| (x, a[i])).collect();
        lp.add_constraint(row.as_slice(), ComparisonOp::Le, range.hi());
        lp.add_constraint(row.as_slice(), ComparisonOp::Ge, range.lo());
    }
    let entry = |i: usize| {
        let mut terms: Vec<(Variable, f64)> =
            xi.iter().zip(set.generators().columns()).map(|(&x, g)| (x, g[i])).collect();
        // The center and the remainder are one more coordinate, between its ends.
        let (c, r) = (set.center()[i], set.remainder()[i]);
        terms.push((lp.add_var(0.0, (c - r, c + r)), 1.0));
        terms
    };
    (0..set.dim()).map(entry).collect()
}

/// `m z`, for coordinates that are sums of variables.
fn mapped(m: &Matrix, i: usize, z: &[Vec<(Variable, f64)>], sign: f64) -> Vec<(Variable, f64)> {
    let scaled = |k: usize| z[k].iter().map(move |&(x, a)| (x, a * sign * m[(i, k)])).collect::<Vec<_>>();
    (0..z.len()).flat_map(scaled).collect()
}

/// The largest `sign x_i` at the end of a run, over all initial states and noises that agree with all that was measured.
fn oracle(run: &Run, i: usize, sign: f64) -> f64 {
    let mut lp = Problem::new(OptimizationDirection::Maximize);
    let (n, last) = (run.start.dim(), run.outputs.len() - 1);
    let state = |lp: &mut Problem, k: usize| -> Vec<Vec<(Variable, f64)>> {
        let weight = |j: usize| if k == last && j == i { sign } else { 0.0 };
        (0..n).map(|j| vec![(lp.add_var(weight(j), (f64::NEG_INFINITY, f64::INFINITY)), 1.0)]).collect()
    };
    let equal = |lp: &mut Problem, terms: Vec<(Variable, f64)>, value: f64| {
        // A variable may occur in several terms.
        let mut sums: Vec<(Variable, f64)> = Vec::new();
        for (x, a) in terms {
            match sums.iter_mut().find(|(y, _)| *y == x) {
                Some((_, b)) => *b += a,
                None => sums.push((x, a)),
            }
        }
        lp.add_constraint(sums.as_slice(), ComparisonOp::Eq, value);
    };
    let mut x = state(&mut lp, 0);
    let first = point_of(&mut lp, &run.start);
    for j in 0..n {
        let terms = x[j].iter().copied().chain(first[j].iter().map(|&(v, a)| (v, -a))).collect();
        equal(&mut lp, terms, 0.0);
    }
    for k in 0..=last {
        let v = point_of(&mut lp, &run.system.v);
        for (j, y) in run.outputs[k].iter().enumerate() {
            if let Some(y) = y {
                let direct = times(&run.system.d_u, &run.inputs[k])[j];
                let terms = [mapped(&run.system.c, j, &x, 1.0), mapped(&run.system.d_v, j, &v, 1.0)].concat();
                equal(&mut lp, terms, y - direct);
            }
        }
        if k < last {
            let (next, w) = (state(&mut lp, k + 1), point_of(&mut lp, &run.system.w));
            for j in 0..n {
                let driven = times(&run.system.b_u, &run.inputs[k])[j];
                let moved = [mapped(&run.system.a, j, &x, -1.0), mapped(&run.system.b_w, j, &w, -1.0)].concat();
                equal(&mut lp, [next[j].clone(), moved].concat(), driven);
            }
            x = next;
        }
    }
    lp.solve().unwrap().into_solution().unwrap().objective()
}

/// Without a limit the hull is that of all states that agree with the whole history; the textbook form gives the same, a limit a larger one.
#[test]
fn the_hull_is_that_of_the_whole_history() {
    let (mut sides, mut excess) = (0, 0.0_f64);
    for seed in 0..24 * cases(1) as u64 {
        let run = simulate(9000 + seed, 4);
        let filter = filtered(&run, LinearOptions::default());
        let textbook = filtered(&run, LinearOptions { noise: NoiseForm::Generators, ..LinearOptions::default() });
        let limit = Some(Complexity { generators: 10, constraints: 4 });
        let small = filtered(&run, LinearOptions { limit, ..LinearOptions::default() });
        assert!(small.enclosure().num_generators() <= 10 && small.enclosure().num_constraints() <= 4);
        for i in 0..run.start.dim() {
            let (lo, hi) = (-oracle(&run, i, -1.0), oracle(&run, i, 1.0));
            for hull in [filter.hull(), textbook.hull()] {
                assert!(hull[i].lo() <= lo + 1e-9 && hull[i].hi() >= hi - 1e-9, "seed {seed}: {:?} {lo} {hi}", hull[i]);
                assert!(hull[i].lo() >= lo - 1e-7 && hull[i].hi() <= hi + 1e-7, "seed {seed}: {:?} {lo} {hi}", hull[i]);
                sides += 2;
            }
            let wide = small.hull()[i];
            assert!(wide.lo() <= lo + 1e-9 && wide.hi() >= hi - 1e-9, "seed {seed}: {wide:?} {lo} {hi}");
            excess = excess.max(wide.width() / (hi - lo).max(1e-6));
        }
        let columns = |filter: &LinearCz| filter.enclosure().num_generators();
        assert!(columns(&filter) <= columns(&textbook));
    }
    println!("{sides} sides of hulls are those of the programs; with a limit at most {excess:.3} times as wide");
    assert!(excess < 3.0, "{excess}");
}

/// The same system as functions: `Rcz` agrees where it loses nothing.
#[test]
fn other_filters_agree() {
    let mut random = Random::new(91);
    let cart = function!(|[s, v, w]: 3| -> 2 { [s + v.scale(0.125), v + w] });
    let seen = function!(|[s, _v, e]: 3| -> 1 { [s + e] });
    let functions = System::new(Relation::new(cart), cube(1, 0.03125), Relation::new(seen), cube(1, 0.0625)).unwrap();
    let start = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    let mut rcz = Rcz::new(functions, start.clone(), RczOptions::slow(2)).unwrap();
    let mut filter = LinearCz::new(cart_system(), start, LinearOptions::default()).unwrap();
    let (mut s, mut v) = (0.5, 0.25);
    for _ in 0..12 {
        let y = [s + 0.0625 * random.unit()];
        rcz.update(&y).unwrap();
        filter.update(&y).unwrap();
        for (a, b) in rcz.hull().iter().zip(filter.hull()) {
            assert!((a.lo() - b.lo()).abs() < 0.01 && (a.hi() - b.hi()).abs() < 0.01, "{a:?} {b:?}");
        }
        rcz.predict(&[]).unwrap();
        filter.predict(&[]).unwrap();
        (s, v) = (s + 0.125 * v, v + 0.03125 * random.unit());
    }
}

/// A cart: position and speed, pushed a little; its position is seen.
fn cart_system() -> LinearSystem {
    let a = Matrix::from_rows(&[&[1.0, 0.125], &[0.0, 1.0]]).unwrap();
    let push = ConstrainedZonotope::from_box(&[0.0, 0.0], &[0.0, 0.03125]).unwrap();
    let error = ConstrainedZonotope::from_box(&[0.0], &[0.0625]).unwrap();
    LinearSystem::new(a, push, Matrix::from_rows(&[&[1.0, 0.0]]).unwrap(), error).unwrap()
}

/// Linear invariants cut, exactly; the matrices may change from step to step.
#[test]
fn invariants_cut_and_matrices_may_change() {
    // Two tanks between which water flows: the sum stays.
    let flow = |share: f64| Matrix::from_rows(&[&[1.0 - share, 0.0], &[share, 1.0]]).unwrap();
    let none = ConstrainedZonotope::from_box(&[0.0; 2], &[0.0; 2]).unwrap();
    let error = ConstrainedZonotope::from_box(&[0.0], &[0.125]).unwrap();
    let system = LinearSystem::new(flow(0.25), none, Matrix::from_rows(&[&[1.0, 0.0]]).unwrap(), error).unwrap();
    let total = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let system = system.with_invariant(total, vec![Interval::point(2.0)]);
    let start = ConstrainedZonotope::from_box(&[1.0, 1.0], &[0.5, 0.75]).unwrap();
    let mut filter = LinearCz::new(system, start, LinearOptions::default()).unwrap();
    let mut x = [1.25, 0.75];
    for k in 0..6 {
        filter.update(&[x[0] + 0.0625]).unwrap();
        let hull = filter.hull();
        assert!(hull[0].contains(x[0]) && hull[1].contains(x[1]));
        // What is known of one tank is known of the other.
        assert!(
            (hull[0].width() - hull[1].width()).abs() < 1e-12 && (hull[0].mid() + hull[1].mid() - 2.0).abs() < 1e-12
        );
        let share = 0.125 * f64::from(k);
        filter.system_mut().a = flow(share);
        filter.predict(&[]).unwrap();
        x = [x[0] - share * x[0], x[1] + share * x[0]];
    }
    let before = filter.state().clone();
    filter.system_mut().d[0] = Interval::point(3.0);
    let Err(EstimatorError::Inconsistent(proof)) = filter.consistency() else { panic!("no contradiction") };
    assert_eq!(proof.culprits, [Culprit::Invariant(0), Culprit::Prediction]);
    assert!(proof.verify() && proof.margin() > 0.0);
    assert_eq!(filter.state(), &before);
}

#[test]
fn outliers_are_refuted_and_bad_input_changes_nothing() {
    let start = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    for noise in [NoiseForm::Ranges, NoiseForm::Generators] {
        let options = LinearOptions { noise, ..LinearOptions::default() };
        let mut filter = LinearCz::new(cart_system(), start.clone(), options).unwrap();
        filter.step(&[], &[0.5]).unwrap();
        let before = filter.state().clone();
        let Err(EstimatorError::Inconsistent(proof)) = filter.update(&[1.5]) else { panic!("no contradiction") };
        assert_eq!(proof.culprits, [Culprit::Measurement(0), Culprit::Prediction]);
        assert!(proof.verify());
        assert!(matches!(
            filter.update(&[f64::NAN]),
            Err(EstimatorError::NotFinite { what: "measurement", index: 0, .. })
        ));
        assert!(matches!(filter.update(&[0.5, 0.5]), Err(EstimatorError::Size { what: "measurement", .. })));
        assert!(matches!(filter.update_some(&[None], &[1.0]), Err(EstimatorError::Size { .. })));
        assert!(matches!(filter.predict(&[1.0]), Err(EstimatorError::Size { what: "input", .. })));
        assert!(filter.step(&[1.0], &[0.5]).is_err());
        assert_eq!(filter.state(), &before);
        filter.system_mut().a = Matrix::identity(3);
        assert!(matches!(filter.predict(&[]), Err(EstimatorError::Size { what: "matrix A", expected: 2, found: 3 })));
        filter.system_mut().a = Matrix::from_diagonal(&[1.0, f64::INFINITY]);
        assert!(matches!(filter.predict(&[]), Err(EstimatorError::NotFinite { what: "matrix A", index: 3, .. })));
        filter.system_mut().c = Matrix::zeros(1, 1);
        assert!(matches!(filter.update(&[0.5]), Err(EstimatorError::Size { what: "matrix C", .. })));
        assert_eq!(filter.state(), &before);
        let mut wrong = before.clone();
        wrong.hull[1] = Interval::EMPTY;
        assert!(matches!(filter.restore(&wrong), Err(EstimatorError::EmptyRange { index: 1, .. })));
    }
    let wide = ConstrainedZonotope::from_box(&[0.0; 3], &[1.0; 3]).unwrap();
    assert!(LinearCz::new(cart_system(), wide, LinearOptions::default()).is_err());
    let mut empty = start.clone();
    empty.intersect_half_space(&[1.0, 1.0], -3.0, &mut Workspace::new()).unwrap();
    let refused = LinearCz::new(cart_system(), empty, LinearOptions::default()).unwrap_err();
    assert_eq!(refused, EstimatorError::Set(SetError::EmptySet));
    let system = cart_system().with_invariant(Matrix::identity(2), vec![Interval::EMPTY; 2]);
    assert!(matches!(
        LinearCz::new(system, start.clone(), LinearOptions::default()),
        Err(EstimatorError::EmptyRange { index: 0, .. })
    ));
    let limit = Some(Complexity { generators: 1, constraints: 1 });
    assert!(LinearCz::new(cart_system(), start, LinearOptions { limit, ..LinearOptions::default() }).is_err());
}

#[test]
fn a_step_in_steady_state_allocates_nothing() {
    let start = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    for noise in [NoiseForm::Ranges, NoiseForm::Generators] {
        let limit = Some(Complexity { generators: 12, constraints: 4 });
        let options = LinearOptions { noise, limit, ..LinearOptions::default() };
        let mut filter = LinearCz::new(cart_system(), start.clone(), options).unwrap();
        let begin = filter.state().clone();
        let mut go = || {
            filter.restore(&begin).unwrap();
            for k in 0..30 {
                filter.step(&[], &[0.25 * f64::from(k % 2) * 0.125]).unwrap();
            }
        };
        (0..6).for_each(|_| go());
        assert_eq!(allocation_counter::measure(go).count_total, 0, "{noise:?}");
    }
}
