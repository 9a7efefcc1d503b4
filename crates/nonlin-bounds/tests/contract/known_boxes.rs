//! Boxes worked out by hand: one operation, linear systems, and the measurement of paper 003, section 5.2.

use std::f64::consts::PI;

use nonlin_bounds::{Contraction, ForwardBackward, Function, Tape, Workspace};
use scalars::{Interval, Scalar};

use crate::common::functions::{AttitudeOutput, UnitNorm};
use crate::common::random::Random;

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// A function of two variables and one output by one expression.
macro_rules! contract {
    ($x:expr, $y:expr, |$a:ident, $b:ident| $expression:expr) => {{
        struct Written;
        impl Function for Written {
            const VARIABLES: Option<usize> = Some(2);
            fn outputs(&self) -> usize {
                1
            }
            fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
                let ($a, $b) = (x[0], x[1]);
                y[0] = $expression;
            }
        }
        let mut x: [Interval; 2] = $x;
        let contractor = ForwardBackward { sweeps: 1, least_gain: 0.0 };
        let outcome = contractor.contract(&Tape::record(&Written), &mut x, &[], &[$y], &mut Workspace::new()).unwrap();
        if outcome.is_empty() { None } else { Some(x) }
    }};
}

/// The sides are the expected ones, up to `1e-14` outward.
#[track_caller]
fn assert_sides(found: Option<[Interval; 2]>, expected: [(f64, f64); 2]) {
    let found = found.expect("there are solutions");
    for (found, (lo, hi)) in found.iter().zip(expected) {
        let close = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-14 * (1.0 + b.abs());
        assert!(close(found.lo(), lo) && close(found.hi(), hi), "{found:?}, not [{lo}, {hi}]");
    }
}

const FREE: Interval = Interval::ENTIRE;
const INF: f64 = f64::INFINITY;

#[test]
fn squares_and_powers() {
    let free = (-INF, INF);
    let b = FREE;
    assert_sides(contract!([interval(-3.5, 5.0), b], interval(4.0, 9.0), |a, _b| a.sqr()), [(-3.0, 3.0), free]);
    assert_sides(contract!([interval(-1.0, 5.0), b], interval(4.0, 9.0), |a, _b| a * a), [(2.0, 3.0), free]);
    assert!(contract!([interval(-1.0, 1.0), b], interval(4.0, 9.0), |a, _b| a.sqr()).is_none());
    assert_sides(contract!([b, b], interval(-8.0, 27.0), |a, _b| a.powi(3)), [(-2.0, 3.0), free]);
    assert_sides(contract!([interval(-9.0, 1.0), b], interval(16.0, 81.0), |a, _b| a.powi(4)), [(-3.0, -2.0), free]);
    assert_sides(contract!([b, b], interval(0.25, 4.0), |a, _b| a.powi(-2)), [(-2.0, 2.0), free]);
    assert_sides(contract!([interval(0.0, INF), b], interval(0.25, 4.0), |a, _b| a.powi(-2)), [(0.5, 2.0), free]);
    assert_sides(contract!([b, b], interval(0.125, 8.0), |a, _b| a.powi(-3)), [(0.5, 2.0), free]);
    assert_sides(contract!([b, b], interval(-4.0, -0.5), |a, _b| a.recip()), [(-2.0, -0.25), free]);
    assert_sides(contract!([interval(-2.0, 5.0), b], interval(1.5, 3.0), |a, _b| a.abs()), [(-2.0, 3.0), free]);
    assert_sides(contract!([b, b], interval(-1.0, 3.0), |a, _b| a.sqrt()), [(0.0, 9.0), free]);
}

#[test]
fn turns_of_sine_cosine_and_tangent() {
    let free = (-INF, INF);
    let upper_half = interval(0.5, 1.0);
    let sine = |a| contract!([a, FREE], interval(0.5, 1.0), |a, _b| a.sin());
    assert_sides(sine(interval(0.0, 10.0)), [(PI / 6.0, 2.0 * PI + 5.0 * PI / 6.0), free]);
    assert_sides(sine(interval(3.0, 8.0)), [(2.0 * PI + PI / 6.0, 8.0), free]);
    assert_sides(sine(interval(-7.0, 0.0)), [(-2.0 * PI + PI / 6.0, -PI - PI / 6.0), free]);
    assert!(sine(interval(3.0, 6.0)).is_none());
    let cosine = |a| contract!([a, FREE], interval(0.5, 1.0), |a, _b| a.cos());
    assert_sides(cosine(interval(0.5, 6.0)), [(0.5, 6.0), free]);
    assert_sides(cosine(interval(1.5, 5.5)), [(5.0 * PI / 3.0, 5.5), free]);
    assert!(cosine(interval(1.5, 5.0)).is_none());
    let far = contract!([interval(1e6, 1e6 + 10.0), FREE], upper_half, |a, _b| a.sin()).unwrap();
    assert!(far[0].lo() > 1e6 + 0.1 && far[0].hi() < 1e6 + 9.9, "{far:?}");
    assert_sides(
        contract!([interval(1.0, 5.0), FREE], interval(-1.0, 1.0), |a, _b| a.tan()),
        [(3.0 * PI / 4.0, 5.0 * PI / 4.0), free],
    );
}

#[test]
fn inverse_and_exponential_functions() {
    let free = (-INF, INF);
    let half = interval(0.5, 0.6);
    let all = [FREE; 2];
    assert_sides(contract!(all, half, |a, _b| a.exp()), [(0.5_f64.ln(), 0.6_f64.ln()), free]);
    assert_sides(contract!(all, half, |a, _b| a.ln()), [(0.5_f64.exp(), 0.6_f64.exp()), free]);
    assert_sides(contract!(all, half, |a, _b| a.asin()), [(0.5_f64.sin(), 0.6_f64.sin()), free]);
    assert_sides(contract!(all, half, |a, _b| a.acos()), [(0.6_f64.cos(), 0.5_f64.cos()), free]);
    assert_sides(contract!(all, half, |a, _b| a.atan()), [(0.5_f64.tan(), 0.6_f64.tan()), free]);
    assert_sides(contract!(all, half, |a, _b| a.sinh()), [(0.5_f64.asinh(), 0.6_f64.asinh()), free]);
    assert_sides(contract!(all, half, |a, _b| a.tanh()), [(0.5_f64.atanh(), 0.6_f64.atanh()), free]);
    let wide = interval(1.5, 2.0);
    assert_sides(contract!(all, wide, |a, _b| a.cosh()), [(-2.0_f64.acosh(), 2.0_f64.acosh()), free]);
    assert_sides(contract!(all, wide, |a, _b| a.sinh()), [(1.5_f64.asinh(), 2.0_f64.asinh()), free]);
    assert!(contract!(all, wide, |a, _b| a.tanh()).is_none());
    assert!(contract!(all, interval(-2.0, -1.0), |a, _b| a.exp()).is_none());
}

#[test]
fn products_quotients_and_angles() {
    let (three, two) = (interval(-3.0, 3.0), interval(2.0, 4.0));
    assert_sides(contract!([three, two], interval(4.0, 6.0), |a, b| a * b), [(1.0, 3.0), (2.0, 4.0)]);
    // Zero inside the divisor: two half-lines, and the hull of what they leave.
    let zero_inside = interval(-1.0, 2.0);
    assert_sides(contract!([three, zero_inside], interval(2.0, 9.0), |a, b| a * b), [(-3.0, 3.0), (-1.0, 2.0)]);
    assert_sides(
        contract!([interval(-1.5, 3.0), zero_inside], interval(2.0, 9.0), |a, b| a * b),
        [(1.0, 3.0), (2.0 / 3.0, 2.0)],
    );
    assert!(contract!([three, Interval::ZERO], interval(2.0, 9.0), |a, b| a * b).is_none());
    assert_sides(contract!([three, two], interval(1.0, 5.0), |a, b| a / b), [(2.0, 3.0), (2.0, 3.0)]);
    assert_sides(contract!([three, two], interval(2.5, 5.0), |a, b| a.min(b)), [(2.5, 3.0), (2.5, 4.0)]);
    assert_sides(contract!([three, two], interval(3.5, 5.0), |a, b| a.max(b)), [(-3.0, 3.0), (3.5, 4.0)]);
    // The sector of 45 to 60 degrees.
    let sector = contract!([interval(0.0, 4.0), interval(1.0, 2.0)], interval(PI / 4.0, PI / 3.0), |a, b| a.atan2(b));
    assert_sides(sector, [(1.0, 2.0 * 3.0_f64.sqrt()), (1.0, 2.0)]);
    // A half-plane behind the y axis.
    let behind = contract!([three, three], interval(2.0, 3.0), |a, b| a.atan2(b)).unwrap();
    assert!(behind[0].lo() >= 0.0 && behind[1].hi() <= 0.0, "{behind:?}");
}

#[test]
fn stumpff_functions_shrink_around_the_value() {
    for (k, s) in [(0, 1.0_f64), (1, 2.0), (2, 5.0), (3, -4.0), (1, -1.0)] {
        let value = s.stumpff(k);
        let y = Interval::point(value).inflate(1e-9);
        let start = interval(s - 3.0, s + 2.0);
        let x = match k {
            0 => contract!([start, FREE], y, |a, _b| a.stumpff(0)),
            1 => contract!([start, FREE], y, |a, _b| a.stumpff(1)),
            2 => contract!([start, FREE], y, |a, _b| a.stumpff(2)),
            _ => contract!([start, FREE], y, |a, _b| a.stumpff(3)),
        };
        let x = x.unwrap();
        assert!(x[0].contains(s) && x[0].width() < 0.05, "C_{k} at {s}: {x:?}");
    }
}

/// A variable that occurs once in every constraint: the hull in one sweep.
#[test]
fn one_occurrence_gives_the_hull() {
    let x = contract!([interval(0.0, 10.0), interval(-2.0, 2.0)], interval(9.0, 10.0), |a, b| {
        (a.sqr() + S::from_f64(5.0)).sqrt() * b.exp() - b.scale(0.0)
    });
    // sqrt(a^2 + 5) in [9 e^-2, 10 e^2], e^b in [9 / sqrt 105, 10 / sqrt 5].
    assert_sides(x, [(0.0, 10.0), ((9.0 / 105.0_f64.sqrt()).ln(), (10.0 / 5.0_f64.sqrt()).ln())]);
}

/// A diagonally dominant linear system.
struct Linear;

impl Function for Linear {
    const VARIABLES: Option<usize> = Some(3);
    fn outputs(&self) -> usize {
        3
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].scale(4.0) + x[1] - x[2];
        y[1] = x[0] + x[1].scale(5.0) + x[2].scale(2.0);
        y[2] = x[1] - x[2].scale(3.0) - x[0];
    }
}

#[test]
fn linear_constraints_converge_to_the_solution() {
    let y = [3.0, 17.0, -8.0].map(Interval::point); // at (1, 2, 3)
    let mut x = [interval(-100.0, 100.0); 3];
    let contractor = ForwardBackward { sweeps: 200, least_gain: 0.0 };
    let outcome = contractor.contract(&Tape::record(&Linear), &mut x, &[], &y, &mut Workspace::new()).unwrap();
    assert!(matches!(outcome, Contraction::Undecided { sweeps } if sweeps < 200), "{outcome:?}");
    for (x, solution) in x.iter().zip([1.0, 2.0, 3.0]) {
        assert!(x.contains(solution) && x.width() < 1e-13, "{x:?}");
    }
}

/// Six outputs known to `+-0.15` (uniform noise), a box of half-width 0.18 around a quaternion, then the unit norm: what is left of the
/// box's width. A regression band: a larger value is a contractor that has become weaker.
#[test]
fn the_attitude_measurement_shrinks_the_box() {
    let (measurement, norm) = (Tape::record(&AttitudeOutput), Tape::record(&UnitNorm { dim: 4 }));
    let (mut one, mut all, mut workspace) = (0.0, 0.0, Workspace::new());
    let count = 400;
    for case in 0..count {
        let mut random = Random::new(9, case);
        let mut q: [f64; 4] = std::array::from_fn(|_| random.unit());
        let length = q.iter().map(|q| q * q).sum::<f64>().sqrt();
        q.iter_mut().for_each(|q| *q /= length);
        let mut y = [0.0; 6];
        AttitudeOutput.eval(&q, &[], &mut y);
        let y = y.map(|y| Interval::point(y + 0.14 * random.unit()).inflate(0.15));
        let start = q.map(|q| Interval::point(q + 0.17 * random.unit()).inflate(0.18));
        let width = |x: &[Interval]| x.iter().map(Interval::width).sum::<f64>() / 1.44;
        let mut x = start;
        let sweep = ForwardBackward { sweeps: 1, least_gain: 0.0 };
        assert!(!sweep.contract(&measurement, &mut x, &[], &y, &mut workspace).unwrap().is_empty());
        one += width(&x) / count as f64;
        let contractor = ForwardBackward::default();
        for _ in 0..3 {
            let unit = [Interval::ZERO.inflate(1e-14)];
            assert!(!contractor.contract(&measurement, &mut x, &[], &y, &mut workspace).unwrap().is_empty());
            assert!(!contractor.contract(&norm, &mut x, &[], &unit, &mut workspace).unwrap().is_empty());
        }
        assert!(x.iter().zip(&q).all(|(x, &q)| x.contains(q)));
        all += width(&x) / count as f64;
    }
    println!("one sweep {one:.4}, with the norm to the end {all:.4}");
    assert!(one < 0.99 && all < 0.9);
}
