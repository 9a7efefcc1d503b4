//! Random programs over every operation, on ordinary and on extreme boxes: the point that made the required ranges is never lost.

use nonlin_bounds::{Contraction, DynFunction, ForwardBackward, Function, Jet, Order, Smoothness, Tape, Workspace};
use scalars::{Interval, Scalar};

use crate::common::random::{Random, cases};

/// One operation on values computed before.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) operation: usize,
    pub(crate) a: usize,
    pub(crate) b: usize,
    pub(crate) k: f64,
}

/// Number of operations a step may choose from.
pub(crate) const OPERATIONS: usize = 41;

/// Straight-line code; the outputs are the last values.
#[derive(Debug, Clone)]
pub(crate) struct Program {
    pub(crate) variables: usize,
    pub(crate) outputs: usize,
    pub(crate) steps: Vec<Step>,
}

fn apply<S: Scalar>(step: Step, a: S, b: S) -> S {
    match step.operation {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        3 => a / b,
        4 => a.min(b),
        5 => a.max(b),
        6 => a.atan2(b),
        7 => -a,
        8 => a.sqr(),
        9 => a.recip(),
        10 => a.abs(),
        11 => a.sqrt(),
        12 => a.exp(),
        13 => a.ln(),
        14 => a.sin(),
        15 => a.cos(),
        16 => a.tan(),
        17 => a.asin(),
        18 => a.acos(),
        19 => a.atan(),
        20 => a.sinh(),
        21 => a.cosh(),
        22 => a.tanh(),
        23 => a.scale(step.k),
        24 => a.add_f64(step.k),
        25 => a.powi(3),
        26 => a.powi(4),
        27 => a.powi(-2),
        28 => a.powi(-3),
        29 => a.powi(7),
        30 => a.stumpff(0),
        31 => a.stumpff(1),
        32 => a.stumpff(2),
        33 => a.stumpff(3),
        34 => a.stumpff(19),
        35 => a * S::ratio(-1, 3),
        36 => S::pi() - a,
        37 => a.sin_cos().0 * a.sin_cos().1,
        38 => a.powi(0),
        40 => a.sign(),
        _ => a * a - S::decimal("0.1") * b,
    }
}

impl Function for Program {
    fn variables(&self) -> usize {
        self.variables
    }
    fn outputs(&self) -> usize {
        self.outputs
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let mut values = x.to_vec();
        for &step in &self.steps {
            values.push(apply(step, values[step.a], values[step.b]));
        }
        y.copy_from_slice(&values[values.len() - self.outputs..]);
    }
}

impl Program {
    fn random(random: &mut Random) -> Self {
        let variables = 1 + random.below(3);
        let length = 1 + random.below(9);
        let steps = (0..length).map(|k| {
            let known = variables + k;
            // Late values are preferred, so that programs are deep.
            let mut operand = || if random.below(2) == 0 { known - 1 } else { random.below(known) };
            let (a, b) = (operand(), operand());
            Step { operation: random.below(OPERATIONS), a, b, k: number(random) }
        });
        let steps: Vec<Step> = steps.collect();
        Self { variables, outputs: 1 + random.below(2.min(steps.len())), steps }
    }
}

/// Ordinary numbers mostly, small integers, tiny and huge ones.
pub(crate) fn number(random: &mut Random) -> f64 {
    match random.below(16) {
        0 => 0.0,
        1..=3 => random.below(9) as f64 - 4.0,
        4 => random.unit() * 1e-300,
        5 => random.unit() * 1e300,
        6 => random.unit() * 1e9,
        7 => random.unit() * f64::from_bits(random.bits() & ((1 << 52) - 1)),
        _ => 4.0 * random.unit(),
    }
}

/// A side of a box around a number: degenerate, a few floats, ordinary, touching zero, huge, or unbounded.
pub(crate) fn side(random: &mut Random, x: f64) -> Interval {
    let mut reach = || match random.below(8) {
        0 => 0.0,
        1 => x.abs() * f64::EPSILON,
        2 => x.abs(),
        3 => 1e300,
        4 => f64::INFINITY,
        _ => 3.0 * random.fraction(),
    };
    Interval::new(x - reach(), x + reach()).unwrap()
}

/// A range that contains another: the same, wider, or without a bound.
pub(crate) fn required(random: &mut Random, y: Interval) -> Interval {
    let infinite = f64::INFINITY;
    match random.below(8) {
        0 => Interval::ENTIRE,
        1 => Interval::new(y.lo(), infinite).unwrap(),
        2 => Interval::new(-infinite, y.hi()).unwrap(),
        3 | 4 => y.inflate(random.fraction()),
        _ => y,
    }
}

#[test]
fn never_lose_the_point_that_made_the_ranges() {
    const SEED: u64 = 31;
    let (mut workspace, mut jet) = (Workspace::new(), Jet::new());
    let (mut checked, mut shrunk) = (0, 0);
    for case in 0..cases(120_000) {
        let mut random = Random::new(SEED, case);
        let program = Program::random(&mut random);
        let point: Vec<f64> = (0..program.variables).map(|_| number(&mut random)).collect();
        let exact: Vec<Interval> = point.iter().map(|&x| Interval::point(x)).collect();
        program.enclose(Order::Value, &exact, &[], &mut jet).unwrap();
        // Only points at which all outputs are proven to be defined have to survive.
        if jet.smoothness().iter().any(|&smoothness| smoothness < Smoothness::Defined) {
            continue;
        }
        let y: Vec<Interval> = jet.values().iter().map(|&y| required(&mut random, y)).collect();
        let start: Vec<Interval> = point.iter().map(|&x| side(&mut random, x)).collect();
        let mut x = start.clone();
        let contractor = ForwardBackward { sweeps: 1 + random.below(4), least_gain: 0.0 };
        let tape = Tape::record(&program);
        let outcome = contractor.contract(&tape, &mut x, &[], &y, &mut workspace).unwrap();
        let context = || format!("seed {SEED}, case {case}: {program:?}\n{tape}at {point:?} in {start:?}, {y:?}");
        assert!(matches!(outcome, Contraction::Undecided { .. }), "{outcome:?}, {}", context());
        for ((side, start), &point) in x.iter().zip(&start).zip(&point) {
            assert!(side.contains(point), "{side:?} lost {point}, {}", context());
            assert!(side.subset_of(start), "{}", context());
        }
        checked += 1;
        shrunk += usize::from(x != start);
    }
    println!("{checked} points, {shrunk} boxes shrunk");
    assert!(checked * 2 > cases(120_000) && shrunk * 5 > checked * 2);
}
