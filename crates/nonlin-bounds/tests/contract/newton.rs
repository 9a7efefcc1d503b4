//! Interval Newton: roots found to the last places and proven unique, boxes without roots, rectangular systems.

use nonlin_bounds::{Conflict, Contraction, Function, IntervalNewton, Workspace};
use scalars::{Interval, Scalar};

use crate::common::functions::{AttitudeOutput, Landmarks};
use crate::common::random::{Random, cases};

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// `x0^2 + x1^2 - p0` and `x0 - x1^3`.
struct CircleAndCubic;

impl Function for CircleAndCubic {
    const VARIABLES: Option<usize> = Some(2);
    fn parameters(&self) -> usize {
        1
    }
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        y[0] = x[0].sqr() + x[1].sqr() - p[0];
        y[1] = x[0] - x[1].powi(3);
    }
}

fn solve(x: &mut [Interval], p: Interval, sweeps: usize) -> Contraction {
    let contractor = IntervalNewton { sweeps, least_gain: 0.0 };
    contractor.contract(&CircleAndCubic, x, &[p], &[Interval::ZERO; 2], &mut Workspace::new()).unwrap()
}

#[test]
fn a_root_is_found_and_proven_unique() {
    let mut x = [interval(0.5, 1.2), interval(0.6, 1.1)];
    let outcome = solve(&mut x, Interval::ONE, 20);
    assert!(matches!(outcome, Contraction::ProvenUnique { sweeps } if sweeps < 10), "{outcome:?}");
    assert!(x.iter().all(|x| x.width() < 1e-15), "{x:?}");
    // x1^6 + x1^2 = 1.
    assert!((x[1].mid() - 0.826_031_357_654_187).abs() < 1e-14);
}

/// With parameters of some width the box contains all their roots, and not much more.
#[test]
fn a_family_of_roots_is_enclosed() {
    let mut x = [interval(0.5, 0.65), interval(0.75, 0.9)];
    let outcome = solve(&mut x, interval(0.999, 1.001), 20);
    assert!(matches!(outcome, Contraction::ProvenUnique { .. }), "{outcome:?}");
    let mut ends = [Interval::EMPTY; 2];
    for p in [0.999, 1.001] {
        let mut root = [interval(0.5, 0.65), interval(0.75, 0.9)];
        assert!(!solve(&mut root, Interval::point(p), 20).is_empty());
        (0..2).for_each(|i| ends[i] = ends[i].hull(root[i]));
    }
    for (x, ends) in x.iter().zip(&ends) {
        assert!(ends.subset_of(x) && x.width() < 1.1 * ends.width(), "{x:?} {ends:?}");
    }
}

#[test]
fn no_root_is_proven() {
    for start in [[interval(0.9, 1.2), interval(0.9, 1.2)], [interval(-0.4, 0.3), interval(0.2, 0.5)]] {
        let mut x = start;
        assert!(solve(&mut x, Interval::ONE, 20).is_empty());
        assert_eq!(x, start);
    }
    // One row alone excludes the box.
    let outcome = solve(&mut [interval(2.0, 2.1), interval(0.0, 0.1)], Interval::ONE, 5);
    assert_eq!(outcome, Contraction::ProvenEmpty(Conflict::Output { output: 0, sweep: 1 }));
}

/// Two roots: both stay, and nothing is claimed.
#[test]
fn several_roots_stay() {
    let mut x = [interval(-1.0, 1.0), interval(-1.0, 1.0)];
    let outcome = solve(&mut x, Interval::ONE, 20);
    assert!(matches!(outcome, Contraction::Undecided { .. }));
    for root in [[0.563_624_162_161_259, 0.826_031_357_654_187], [-0.563_624_162_161_259, -0.826_031_357_654_187]] {
        assert!(x.iter().zip(root).all(|(x, root)| x.contains(root)), "{x:?}");
    }
}

/// More outputs than variables (six for a quaternion), and fewer.
#[test]
fn rectangular_systems_shrink() {
    let mut workspace = Workspace::new();
    let (mut tall, mut wide) = (0.0, 0.0);
    let count = cases(300);
    for case in 0..count {
        let mut random = Random::new(3, case);
        let q: [f64; 4] = [0.1, 0.9, -0.3, 0.2].map(|q| q + 0.1 * random.unit());
        let mut y = [Interval::ZERO; 6];
        AttitudeOutput.eval(&q.map(Interval::point), &[], &mut y);
        let mut x = q.map(|q| Interval::point(q + 0.05 * random.unit()).inflate(0.06));
        let outcome = IntervalNewton::default().contract(&AttitudeOutput, &mut x, &[], &y, &mut workspace).unwrap();
        assert!(matches!(outcome, Contraction::Undecided { .. }));
        assert!(x.iter().zip(&q).all(|(x, &q)| x.contains(q)));
        tall += x.iter().map(Interval::width).sum::<f64>() / 0.48 / count as f64;

        // Distance and angle of one landmark out of two.
        let p = [5.0, 15.0, 15.0, 15.0].map(Interval::point);
        let mut y = [Interval::ZERO; 4];
        Landmarks.eval(&[0.1, 0.2, 1.0].map(Interval::point), &p, &mut y);
        let required = [y[0].inflate(1e-3), y[1].inflate(1e-4), Interval::ENTIRE, Interval::ENTIRE];
        let mut x = [interval(-0.4, 0.6), interval(0.2, 0.2), interval(0.9, 1.1)];
        let outcome = IntervalNewton::default().contract(&Landmarks, &mut x, &p, &required, &mut workspace).unwrap();
        assert!(!outcome.is_empty() && x.iter().zip([0.1, 0.2, 1.0]).all(|(x, v)| x.contains(v)));
        wide += x[0].width() / count as f64;
    }
    println!("six outputs for four variables: {tall:.2e} of the width, one landmark: {wide:.2e}");
    assert!(tall < 1e-12 && wide < 0.01);
}

/// Nothing to solve for, nothing to solve, or neither.
#[test]
fn no_variables_or_no_outputs() {
    struct Constants(usize, usize);
    impl Function for Constants {
        fn variables(&self) -> usize {
            self.0
        }
        fn outputs(&self) -> usize {
            self.1
        }
        fn eval<S: Scalar>(&self, _: &[S], _: &[S], y: &mut [S]) {
            y.fill(S::one());
        }
    }
    for (n, m) in [(0, 0), (0, 2), (2, 0)] {
        let (mut x, y) = (vec![interval(0.0, 1.0); n], vec![interval(0.0, 2.0); m]);
        let outcome = IntervalNewton::default().contract(&Constants(n, m), &mut x, &[], &y, &mut Workspace::new());
        assert!(matches!(outcome, Ok(Contraction::Undecided { .. })), "{n} {m}");
        assert!(x.iter().all(|x| *x == interval(0.0, 1.0)));
    }
}
