//! Problems meant to hurt: near-parallel rows, one-ulp ranges, scales of 1e-150 to 1e150 and below, duplicates, rows of zeros.

use super::random::Random;
use super::{dot, norm1};
use boxlp::Problem;

/// A row with its range, around a point of the box or beyond it; `others` are the rows so far.
pub(crate) fn row(random: &mut Random, through: &[f64], others: &Problem) -> (Vec<f64>, f64, f64) {
    let n = through.len();
    let scale = match random.below(6) {
        0 => random.scale(-150.0, 150.0),
        1 => random.scale(-3.0, 3.0),
        2 => f64::MIN_POSITIVE * random.scale(-12.0, 2.0),
        _ => 1.0,
    };
    let known = others.rows();
    let mut row: Vec<f64> = match random.below(8) {
        0 if known > 0 => {
            // Near-parallel to another row.
            let tilt = random.scale(-17.0, -6.0);
            others.row(random.below(known)).iter().map(|a| a * (1.0 + tilt * random.normal())).collect()
        }
        1 if known > 0 => {
            let factor = if random.below(2) == 0 { random.normal() } else { 2_f64.powi(random.below(20) as i32 - 10) };
            others.row(random.below(known)).iter().map(|a| a * factor).collect()
        }
        2 => vec![0.0; n],
        3 => (0..n).map(|_| random.below(7) as f64 - 3.0).collect(),
        4 => (0..n).map(|_| random.normal() * random.scale(-12.0, 12.0)).collect(),
        5 => (0..n).map(|_| if random.below(3) == 0 { random.normal() } else { 0.0 }).collect(),
        _ => (0..n).map(|_| random.normal()).collect(),
    };
    row.iter_mut().for_each(|a| *a *= scale);
    if norm1(&row) > 1e300 {
        row.fill(1.0);
    }
    let norm = norm1(&row);
    let middle: f64 = match random.below(8) {
        0 => norm,
        1 => norm.next_up(),
        2 => norm * (1.0 + random.scale(-16.0, -1.0)),
        _ => dot(&row, through),
    };
    let (lower, upper) = match random.below(9) {
        0 => (middle, middle.next_up()),
        1 => (middle.next_down(), middle),
        2 => (f64::NEG_INFINITY, middle),
        3 => (middle, f64::INFINITY),
        4 => (f64::NEG_INFINITY, f64::INFINITY),
        5 => (-1e300, middle.max(1e300)),
        6 => (middle - norm * random.scale(-16.0, 0.0), middle),
        _ => (middle, middle),
    };
    (row, lower, upper)
}

/// A problem of such rows.
pub(crate) fn problem(random: &mut Random, n: usize, m: usize) -> Problem {
    let through = through(random, n);
    let mut problem = Problem::new(n).unwrap();
    for _ in 0..m {
        let (row, lower, upper) = row(random, &through, &problem);
        problem.push_row(&row, lower, upper).unwrap();
    }
    problem
}

/// A point of the box; often a corner, or on an edge.
pub(crate) fn through(random: &mut Random, n: usize) -> Vec<f64> {
    let share = random.below(3);
    (0..n).map(|_| if random.below(2) < share { random.sign() } else { random.symmetric() }).collect()
}

/// An objective of any size; sometimes a row, an axis, or zero.
pub(crate) fn objective(random: &mut Random, problem: &Problem) -> Vec<f64> {
    let n = problem.variables();
    let scale = match random.below(5) {
        0 => random.scale(-300.0, 300.0),
        1 => f64::MIN_POSITIVE * random.scale(-15.0, 0.0),
        _ => 1.0,
    };
    let mut c: Vec<f64> = match random.below(6) {
        0 if problem.rows() > 0 => problem.row(random.below(problem.rows())).to_vec(),
        1 => vec![0.0; n],
        2 => (0..n).map(|j| if j == 0 { 1.0 } else { 0.0 }).collect(),
        _ => (0..n).map(|_| random.normal()).collect(),
    };
    c.iter_mut().for_each(|c| *c *= scale);
    if norm1(&c) > 1e306 {
        c.fill(-1.0);
    }
    c
}
