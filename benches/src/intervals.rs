//! Interval arithmetic against the same operation over plain `f64`.

use std::hint::black_box;

use scalars::{Interval, Scalar};

use crate::draw::Draw;
use crate::timing::Bench;

/// Operand pairs per batch.
const BATCH: usize = 1024;

/// Operands of one batch.
type Pairs<S> = Vec<(S, S)>;

/// Pairs of numbers in (0.5, 2), and boxes of relative width 1e-3 around them; a quarter of the boxes get mixed signs.
fn operands() -> (Pairs<f64>, Pairs<Interval>) {
    let mut numbers = Draw::new(7);
    let mut draw = || 0.5 + 1.5 * numbers.unit();
    let points: Vec<(f64, f64)> = (0..BATCH).map(|_| (draw(), draw())).collect();
    let boxed = |x: f64| Interval::point(x).inflate(1e-3 * x);
    let boxes = points.iter().enumerate().map(|(k, &(x, y))| {
        let sign = if k % 4 == 0 { -1.0 } else { 1.0 };
        (boxed(sign * x), boxed(y))
    });
    let boxes = boxes.collect();
    (points, boxes)
}

/// The rows `interval/*`.
pub fn benches() -> Vec<Bench> {
    let (points, boxes) = operands();
    macro_rules! row {
        ($name:literal, $operation:expr) => {{
            let (points, boxes) = (points.clone(), boxes.clone());
            let (mut interval_out, mut point_out) = (vec![Interval::ZERO; BATCH], vec![0.0_f64; BATCH]);
            let ours = move || {
                for (out, &(x, y)) in interval_out.iter_mut().zip(black_box(&boxes)) {
                    *out = generic($operation, x, y);
                }
                black_box(&interval_out);
            };
            let plain = move || {
                for (out, &(x, y)) in point_out.iter_mut().zip(black_box(&points)) {
                    *out = generic($operation, x, y);
                }
                black_box(&point_out);
            };
            Bench::new($name, "f64", ours, plain).batched(BATCH)
        }};
    }
    vec![
        row!("interval/add", Op::Add),
        row!("interval/mul", Op::Mul),
        row!("interval/div", Op::Div),
        row!("interval/sqrt", Op::Sqrt),
        row!("interval/sqr", Op::Sqr),
        row!("interval/exp", Op::Exp),
        row!("interval/sin", Op::Sin),
    ]
}

/// The operations timed; a constant argument that the optimiser folds.
#[derive(Clone, Copy)]
enum Op {
    Add,
    Mul,
    Div,
    Sqrt,
    Sqr,
    Exp,
    Sin,
}

/// One operation over any scalar; unary ones ignore `y`, and `sqrt` takes it, which is positive.
#[inline(always)]
fn generic<S: Scalar>(operation: Op, x: S, y: S) -> S {
    match operation {
        Op::Add => x + y,
        Op::Mul => x * y,
        Op::Div => x / y,
        Op::Sqrt => y.sqrt(),
        Op::Sqr => x.sqr(),
        Op::Exp => x.exp(),
        Op::Sin => x.sin(),
    }
}
