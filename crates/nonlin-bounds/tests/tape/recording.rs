//! What is recorded: each operation once, in a simple form, and nothing lost when recordings nest or panic.

use std::any::Any;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use nonlin_bounds::{Function, Tape};
use scalars::{Interval, Scalar};

use crate::common::functions::{AttitudeOutput, Coupled, Unicycle};

/// A function of two variables by one generic expression.
macro_rules! function {
    ($name:ident, $outputs:literal, |$x:ident, $y:ident| $body:block) => {
        struct $name;
        impl Function for $name {
            fn variables(&self) -> usize {
                2
            }
            fn outputs(&self) -> usize {
                $outputs
            }
            fn eval<S: Scalar>(&self, $x: &[S], _: &[S], $y: &mut [S]) $body
        }
    };
}
pub(crate) use function;

fn image(tape: &Tape, x: &[Interval]) -> Vec<Interval> {
    let mut y = vec![Interval::EMPTY; tape.outputs()];
    tape.eval_with(x, &[], &mut y, &mut Vec::new()).unwrap();
    y
}

#[test]
fn common_subexpressions_are_recorded_once() {
    function!(Shared, 3, |x, y| {
        y[0] = (x[0] * x[1]).sin() + x[1] * x[0];
        y[1] = (x[1] * x[0]).sin().max(x[0] + x[1]);
        y[2] = (x[1] + x[0]).max((x[0] * x[1]).sin());
    });
    // The product, its sine, the sum with it, the sum of the variables, one maximum.
    assert_eq!(Tape::record(&Shared).operations(), 5);
    // Four squares and six products serve six outputs.
    assert_eq!(Tape::record(&AttitudeOutput).operations(), 24);
}

#[test]
fn exact_identities_simplify() {
    function!(Identities, 10, |x, y| {
        let zero = S::zero();
        y[0] = x[0] * x[0] + zero * x[1];
        y[1] = -(-x[0]) - zero;
        y[2] = S::one() * x[0] + x[1] - x[1].scale(1.0);
        y[3] = (x[0] - x[1]) + (x[1] - x[0]);
        y[4] = (-x[0]) * (-x[1]);
        y[5] = S::from_f64(2.0) * x[0] - x[0].scale(2.0);
        y[6] = x[0].powi(1) / S::one() + x[1].powi(2) - x[1].sqr();
        y[7] = S::from_f64(3.0) + x[0];
        y[8] = zero - x[0];
        y[9] = x[0].min(x[0]) + (-x[1]);
    });
    let text = Tape::record(&Identities).to_string();
    let expected = "t0 = x[0] - x[1]\nt1 = x[1]^2\n\
        y[0] = x[0]^2\ny[1] = x[0]\ny[2] = x[0] + x[1] - x[1]\ny[3] = t0 + x[1] - x[0]\ny[4] = x[0] * x[1]\n\
        y[5] = 0\ny[6] = x[0] + t1 - t1\ny[7] = x[0] + 3\ny[8] = -x[0]\ny[9] = t0\n";
    assert_eq!(text, expected);
}

/// `0 f(x)` and `f(x) - f(x)` are zero only where `f` is defined.
#[test]
fn a_domain_is_not_simplified_away() {
    function!(Domains, 3, |x, y| {
        y[0] = x[0].ln() * S::zero();
        y[1] = x[0].sqrt() - x[0].sqrt();
        y[2] = x[0].powi(-3).powi(0);
    });
    let tape = Tape::record(&Domains);
    let negative = Interval::new(-2.0, -1.0).unwrap();
    let y = image(&tape, &[negative, negative]);
    assert!(y[0].is_empty() && y[1].is_empty() && y[2] == Interval::ONE);
    assert!(image(&tape, &[Interval::ZERO, negative])[2].is_empty());
}

#[test]
fn dead_code_is_left_out() {
    function!(Dead, 2, |x, y| {
        let unused = x[1].exp().ln();
        y[0] = unused * x[0];
        y[0] = x[0].add_f64(1.0);
    });
    let tape = Tape::record(&Dead);
    assert_eq!((tape.operations(), tape.slots()), (1, 4));
    // An output that is not written is zero.
    assert_eq!(image(&tape, &[Interval::ONE, Interval::ONE])[1], Interval::ZERO);
}

/// Constants are the numbers meant, not the floats next to them.
#[test]
fn constants_are_enclosed() {
    function!(Constants, 5, |x, y| {
        y[0] = S::decimal("0.1");
        y[1] = S::ratio(1, 7) * S::from_f64(7.0);
        y[2] = S::pi().sin();
        y[3] = S::lit(-1.0, 1.0).sqr() * x[0];
        y[4] = S::from_f64(f64::NAN) * x[0];
    });
    let tape = Tape::record(&Constants);
    let y = image(&tape, &[Interval::ONE; 2]);
    assert_eq!(y[0], Interval::decimal("0.1"));
    assert!(y[1].contains(1.0) && y[1].width() < 1e-15);
    assert!(y[2].contains(0.0) && y[2].width() < 1e-15);
    assert_eq!(y[4], Interval::ENTIRE);
    // A wide constant is not folded: over f64 it is the midpoint, whose square is 0 and not the middle of [0, 1].
    assert!(y[3] == Interval::new(0.0, 1.0).unwrap().scale(1.0) || y[3].contains(0.0) && y[3].contains(1.0));
    let mut y = [1.0; 5];
    tape.eval_with(&[1.0, 1.0], &[], &mut y, &mut Vec::new()).unwrap();
    assert_eq!(y[3], 0.0);
    assert_eq!(y[0], 0.1);
}

#[test]
fn recording_a_tape_gives_the_same_tape() {
    for tape in [Tape::record(&AttitudeOutput), Tape::record(&Unicycle), Tape::record(&Coupled { dim: 12 })] {
        assert_eq!(Tape::record(&tape).to_string(), tape.to_string());
    }
}

#[test]
fn recordings_nest() {
    function!(Inner, 1, |x, y| {
        y[0] = x[0].exp() * x[1];
    });
    function!(Outer, 1, |x, y| {
        let square = x[0].sqr();
        let inner = Tape::record(&Inner);
        let mut value = [S::zero()];
        inner.eval(&[square, x[1]], &[], &mut value);
        y[0] = value[0] + square;
    });
    assert_eq!(Tape::record(&Outer).to_string(), "t0 = x[0]^2\ny[0] = t0 + x[1] * exp(t0)\n");
}

/// A panic inside a function, also inside a nested recording, leaves the other recordings as they were.
#[test]
fn panics_leave_no_trace() {
    function!(Faulty, 1, |x, y| {
        let _ = x[0].sin() + x[1];
        y[7] = x[0];
    });
    function!(Careful, 1, |x, y| {
        let product = x[0] * x[1];
        assert!(catch_unwind(|| Tape::record(&Faulty)).is_err());
        y[0] = product + x[0];
    });
    let quiet = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    assert!(catch_unwind(|| Tape::record(&Faulty)).is_err());
    let tape = catch_unwind(AssertUnwindSafe(|| Tape::record(&Careful)));
    std::panic::set_hook(quiet);
    assert_eq!(tape.unwrap().to_string(), "y[0] = x[0] + x[0] * x[1]\n");
}

/// A symbol that was smuggled out of its recording is an unknown number in the next one.
#[test]
fn a_foreign_symbol_is_unknown() {
    thread_local!(static KEPT: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) });
    function!(Smuggler, 1, |x, y| {
        let kept = KEPT.with_borrow(|kept| kept.as_ref().and_then(|kept| kept.downcast_ref::<S>().copied()));
        KEPT.with_borrow_mut(|cell| *cell = Some(Box::new(x[1])));
        y[0] = kept.unwrap_or(x[0]) + x[0];
    });
    assert_eq!(Tape::record(&Smuggler).to_string(), "y[0] = 2 * x[0]\n");
    let tape = Tape::record(&Smuggler);
    assert_eq!(image(&tape, &[Interval::ONE; 2])[0], Interval::ENTIRE);
}
