//! Tapes and contractors against the evaluation of the same function over intervals, the floor of their arithmetic.

use std::hint::black_box;

use nonlin_bounds::{DynFunction, ForwardBackward, Function, IntervalNewton, Jet, Order, Tape, Workspace};
use scalars::{Interval, Scalar};

use crate::functions::{Attitude, AttitudeOutput};
use crate::timing::Bench;

/// The rows `tape/*` and `contract/*`.
pub fn benches() -> Vec<Bench> {
    vec![
        replay(),
        backward(),
        forward_backward("contract/hc4-sweep", 1),
        forward_backward("contract/hc4", 10),
        newton(),
    ]
}

/// The prediction (19) of paper 003, recorded, against the generic code.
fn replay() -> Bench {
    let tape = Tape::record(&Attitude);
    let x = [0.1, 0.9, -0.2, 0.3, 0.001, -0.002, 0.0].map(|c| Interval::point(c).inflate(3e-3));
    let p = [0.3, -0.1, 0.05].map(Interval::point);
    let (mut y, mut buffer) = ([Interval::ZERO; 4], Vec::new());
    let ours = move || {
        let _ = black_box(tape.eval_with(black_box(&x), &p, &mut y, &mut buffer));
        black_box(&y);
    };
    let theirs = move || {
        Attitude.eval(black_box(&x), &p, &mut y);
        black_box(&y);
    };
    Bench::new("tape/replay", "interval-value", ours, theirs)
}

/// A sum over a chain of 64 variables.
#[derive(Clone, Copy)]
struct Chain;

impl Function for Chain {
    const VARIABLES: Option<usize> = Some(64);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x.windows(2).fold(S::zero(), |sum, pair| sum + pair[0] * pair[1].sqr());
    }
}

/// The gradient by 64 variables in reverse mode against eight forward passes.
fn backward() -> Bench {
    let tape = Tape::record(&Chain);
    let x: [Interval; 64] = std::array::from_fn(|i| Interval::point(0.1 * i as f64).inflate(0.1));
    let (mut jet, mut workspace) = (Jet::new(), Workspace::new());
    let ours = move || {
        let _ = black_box(tape.enclose_backward(black_box(&x), &[], &mut jet, &mut workspace));
        black_box(&jet);
    };
    let mut forward = Jet::new();
    let theirs = move || {
        let _ = black_box(Chain.enclose(Order::Jacobian, black_box(&x), &[], &mut forward));
        black_box(&forward);
    };
    Bench::new("tape/gradient-64", "forward-mode", ours, theirs)
}

/// A box of half-width 0.18 around a quaternion, and six measurements of it with an error of 0.15.
fn measurement() -> ([Interval; 4], [Interval; 6]) {
    let start = [0.05, 0.95, -0.05, 0.1].map(|c| Interval::point(c).inflate(0.18));
    let y = [-0.95, 0.1, 0.2, 0.15, 0.9, -0.1].map(|y| Interval::point(y).inflate(0.15));
    (start, y)
}

/// Contraction by the six outputs of paper 003, section 5.2, against their range.
fn forward_backward(name: &'static str, sweeps: usize) -> Bench {
    let (tape, (start, y), mut workspace) = (Tape::record(&AttitudeOutput), measurement(), Workspace::new());
    let contractor = ForwardBackward { sweeps, ..ForwardBackward::default() };
    let ours = move || {
        let mut x = black_box(start);
        let _ = black_box(contractor.contract(&tape, &mut x, &[], &y, &mut workspace));
        black_box(&x);
    };
    let mut values = [Interval::ZERO; 6];
    let theirs = move || {
        AttitudeOutput.eval(black_box(&start), &[], &mut values);
        black_box(&values);
    };
    Bench::new(name, "interval-value", ours, theirs)
}

/// One Newton sweep of the same against its Jacobian.
fn newton() -> Bench {
    let ((start, y), mut workspace) = (measurement(), Workspace::new());
    let contractor = IntervalNewton { sweeps: 1, least_gain: 0.0 };
    let ours = move || {
        let mut x = black_box(start);
        let _ = black_box(contractor.contract(&AttitudeOutput, &mut x, &[], &y, &mut workspace));
        black_box(&x);
    };
    let mut jet = Jet::new();
    let theirs = move || {
        let _ = black_box(AttitudeOutput.enclose(Order::Jacobian, black_box(&start), &[], &mut jet));
        black_box(&jet);
    };
    Bench::new("contract/newton-sweep", "interval-jacobian", ours, theirs)
}
