//! A replay encloses what the function itself does: values the same or tighter, derivatives up to their last places, smoothness.

use allocation_counter::measure;
use nonlin_bounds::{DynFunction, Function, Jet, Order, Smoothness, Tape, function};
use scalars::Interval;

use crate::common::functions::{Attitude, Domain, Visitor, each};
use crate::common::random::{Random, cases};

const SEED: u64 = 20_261_122;

/// Compares a replay with the function itself on random boxes.
struct Compare {
    replayed: Jet,
    direct: Jet,
    /// Entries compared, and those that are not the same bit by bit.
    entries: usize,
    different: usize,
}

impl Compare {
    /// Subsets, but for `ulps` units in the last place of the largest bound.
    fn entries(&mut self, name: &str, case: usize, replayed: &[Interval], direct: &[Interval], ulps: f64) {
        assert_eq!(replayed.len(), direct.len());
        for (replayed, direct) in replayed.iter().zip(direct) {
            let widened = direct.inflate(ulps * f64::EPSILON * direct.mag());
            assert!(replayed.subset_of(&widened), "{name}, seed {SEED}, case {case}: {replayed:?} {direct:?}");
            self.entries += 1;
            self.different += usize::from(replayed != direct);
        }
    }
}

impl Visitor for Compare {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
        let tape = Tape::record(&function);
        let name = domain.name;
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p).inflate(1e-3)).collect();
        for case in 0..cases(400) {
            let mut random = Random::new(SEED, case);
            let x = random.subbox(&domain.center, &domain.radius);
            function.enclose(Order::Hessian, &x, &p, &mut self.direct).unwrap();
            tape.enclose(Order::Hessian, &x, &p, &mut self.replayed).unwrap();
            let (replayed, direct) = (self.replayed.clone(), self.direct.clone());
            self.entries(name, case, replayed.values(), direct.values(), 0.0);
            // `x x` is recorded as `x^2`, whose derivatives round elsewhere.
            self.entries(name, case, replayed.jacobian(), direct.jacobian(), 4.0);
            self.entries(name, case, replayed.hessians(), direct.hessians(), 8.0);
            assert!(replayed.smoothness() >= direct.smoothness(), "{name}, seed {SEED}, case {case}");
            let (mut values, mut buffer) = (vec![Interval::EMPTY; Function::outputs(&tape)], Vec::new());
            tape.eval_with(&x, &p, &mut values, &mut buffer).unwrap();
            self.entries(name, case, &values, direct.values(), 0.0);
            self.points(&function, &tape, &random.point(&x), &domain);
        }
    }
}

impl Compare {
    /// Over `f64` up to rounding.
    fn points<F: Function>(&mut self, function: &F, tape: &Tape, x: &[f64], domain: &Domain) {
        let m = Function::outputs(tape);
        let (mut direct, mut replayed) = (vec![0.0; m], vec![0.0; m]);
        function.value(x, &domain.parameters, &mut direct).unwrap();
        tape.value(x, &domain.parameters, &mut replayed).unwrap();
        for (a, b) in direct.iter().zip(&replayed) {
            assert!((a - b).abs() <= 1e-13 * (1.0 + a.abs()), "{}: {a} {b}", domain.name);
        }
    }
}

#[test]
fn encloses_the_same_or_less() {
    let mut compare = Compare { replayed: Jet::new(), direct: Jet::new(), entries: 0, different: 0 };
    each(&mut compare);
    println!("{} entries, {} differ", compare.entries, compare.different);
    assert!(compare.entries > 100_000 && compare.different < compare.entries / 10);
}

#[test]
fn a_warm_replay_allocates_nothing() {
    let tape = Tape::record(&Attitude);
    let (x, p) = ([Interval::new(-0.1, 0.2).unwrap(); 7], [Interval::ONE; 3]);
    let (mut y, mut buffer, mut jet) = ([Interval::ZERO; 4], Vec::new(), Jet::new());
    let mut run = || {
        tape.eval_with(&x, &p, &mut y, &mut buffer).unwrap();
        tape.enclose(Order::Hessian, &x, &p, &mut jet).unwrap();
        jet.values()[0].hi() + y[0].hi()
    };
    let mut sum = run() + run();
    assert_eq!(measure(|| sum += run()).count_total, 0);
    assert!(sum.is_finite());
}

#[test]
fn wrong_lengths_are_errors() {
    let tape = Tape::record(&Attitude);
    let mut y = [0.0; 4];
    for (x, p, outputs) in [(6, 3, 4), (7, 2, 4), (7, 3, 3)] {
        let result = tape.eval_with(&vec![0.0; x], &vec![0.0; p], &mut y[..outputs], &mut Vec::new());
        assert!(result.is_err());
    }
    assert!(tape.eval_with(&[0.0; 7], &[0.0; 3], &mut y, &mut Vec::new()).is_ok());
}

/// What is no number is proven nothing of, on a tape as without one, folded or not.
#[test]
fn constants_that_are_no_numbers_prove_nothing() {
    macro_rules! undefined {
        ($($constant:expr),* $(,)?) => {$({
            let f = function!(|[x]: 1| -> 1 { [x + $constant] });
            let (mut direct, mut replayed) = (Jet::new(), Jet::new());
            let x = [Interval::new(0.0, 1.0).unwrap()];
            f.enclose(Order::Hessian, &x, &[], &mut direct).unwrap();
            Tape::record(&f).enclose(Order::Hessian, &x, &[], &mut replayed).unwrap();
            assert_eq!(direct.smoothness(), [Smoothness::Undefined], stringify!($constant));
            assert_eq!(replayed.smoothness(), [Smoothness::Undefined], stringify!($constant));
        })*};
    }
    undefined!(
        S::from_f64(f64::NAN).sin(),
        S::from_f64(f64::INFINITY).atan(),
        S::lit(f64::NEG_INFINITY, f64::INFINITY).sin(),
        S::lit(2.0, 1.0).tanh(),
        S::ratio(1, 0).cos(),
        S::decimal("1.2.3").sin(),
        S::decimal("[empty]").sin(),
        S::from_f64(f64::NAN).scale(0.0),
        S::from_f64(f64::NAN).powi(0),
        S::lit(-1e-300, 0.0).sqrt(),
        S::one().scale(f64::NAN).sin(),
    );
}
