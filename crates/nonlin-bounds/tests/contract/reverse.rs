//! One operation backwards: against dense samples, and bounds that are attained.

use nonlin_bounds::{ForwardBackward, Function, Tape, Workspace};
use scalars::Interval;

use crate::common::random::{Random, cases};
use crate::programs::{OPERATIONS, Program, Step, number, side};

/// Operations of two operands, those whose bounds need not be attained after one sweep, and those of several nodes.
const BINARY: [usize; 8] = [0, 1, 2, 3, 4, 5, 6, 39];
const LOOSE: [usize; 9] = [6, 30, 31, 32, 33, 34, 37, 38, 39];

fn image(program: &Program, x: &[Interval]) -> Interval {
    let mut y = [Interval::ZERO];
    program.eval(x, &[], &mut y);
    y[0]
}

fn ordinary(random: &mut Random) -> f64 {
    match random.below(4) {
        0 => random.below(9) as f64 - 4.0,
        1 => 20.0 * random.unit(),
        _ => 3.0 * random.unit(),
    }
}

fn between(a: f64, b: f64) -> Interval {
    Interval::new(a.min(b), a.max(b)).unwrap()
}

/// Points of the box whose value is proven to lie in the required range survive; samples are exact numbers.
#[test]
fn no_sample_is_lost() {
    const SEED: u64 = 5;
    let mut workspace = Workspace::new();
    let mut kept = 0;
    for operation in 0..OPERATIONS {
        let variables = if BINARY.contains(&operation) { 2 } else { 1 };
        for case in 0..cases(300) {
            let mut random = Random::new(SEED + operation as u64, case);
            let extreme = case % 3 == 0;
            let draw = |random: &mut Random| if extreme { number(random) } else { ordinary(random) };
            let k = draw(&mut random);
            let program = Program { variables, outputs: 1, steps: vec![Step { operation, a: 0, b: variables - 1, k }] };
            let start: Vec<Interval> = (0..variables)
                .map(|_| {
                    let x = draw(&mut random);
                    if extreme { side(&mut random, x) } else { between(x, draw(&mut random)) }
                })
                .collect();
            let required = between(draw(&mut random), draw(&mut random));
            let mut x = start.clone();
            let tape = Tape::record(&program);
            let outcome = ForwardBackward { sweeps: 3, least_gain: 0.0 }
                .contract(&tape, &mut x, &[], &[required], &mut workspace)
                .unwrap();
            for _ in 0..60 {
                let point: Vec<f64> =
                    start.iter().map(|s| random.member(between(s.lo().max(f64::MIN), s.hi().min(f64::MAX)))).collect();
                let exact: Vec<Interval> = point.iter().map(|&x| Interval::point(x)).collect();
                let value = image(&program, &exact);
                if value.is_empty() || !value.subset_of(&required) {
                    continue;
                }
                kept += 1;
                let inside = !outcome.is_empty() && x.iter().zip(&point).all(|(x, &point)| x.contains(point));
                assert!(
                    inside,
                    "operation {operation}, case {case}: {point:?} {start:?} {required:?} {x:?} {outcome:?}"
                );
            }
        }
    }
    println!("{kept} samples");
    assert!(kept > cases(20_000));
}

/// A bound that moved has a solution next to it: the box is the hull of the solutions. A box that is claimed empty has none.
#[test]
fn moved_bounds_are_attained() {
    const SEED: u64 = 6;
    let mut workspace = Workspace::new();
    let (mut moved, mut empty) = (0, 0);
    for operation in (0..OPERATIONS).filter(|operation| !LOOSE.contains(operation)) {
        let variables = if BINARY.contains(&operation) { 2 } else { 1 };
        for case in 0..cases(400) {
            let mut random = Random::new(SEED + operation as u64, case);
            let k = ordinary(&mut random);
            let program = Program { variables, outputs: 1, steps: vec![Step { operation, a: 0, b: variables - 1, k }] };
            let start: Vec<Interval> =
                (0..variables).map(|_| between(ordinary(&mut random), ordinary(&mut random))).collect();
            let required = between(ordinary(&mut random), ordinary(&mut random));
            let mut x = start.clone();
            let outcome = ForwardBackward::default()
                .contract(&Tape::record(&program), &mut x, &[], &[required], &mut workspace)
                .unwrap();
            if outcome.is_empty() {
                empty += 1;
                continue;
            }
            for i in 0..variables {
                for (bound, before) in [(x[i].lo(), start[i].lo()), (x[i].hi(), start[i].hi())] {
                    if bound == before {
                        continue;
                    }
                    moved += 1;
                    let mut slice = x.clone();
                    slice[i] = Interval::point(bound).inflate(1e-9 * (1.0 + bound.abs()));
                    let value = image(&program, &slice);
                    let slack = 1e-9 * (1.0 + required.mag());
                    assert!(
                        !value.disjoint(&required.inflate(slack)),
                        "operation {operation}, case {case}: bound {bound} of {x:?} from {start:?}, {required:?}: {value:?}"
                    );
                }
            }
        }
    }
    println!("{moved} bounds moved, {empty} boxes empty");
    assert!(moved > cases(4000) && empty > cases(500));
}
