//! Formulas.

use nonlin_bounds::{Function, Tape};
use scalars::Scalar;

use crate::common::functions::{AttitudeOutput, PlanarMap, RangeBearing, Unicycle};
use crate::recording::function;

#[test]
fn models_print_as_they_are_written() {
    assert_eq!(
        Tape::record(&PlanarMap).to_string(),
        "t0 = x[0] * x[1] / (x[0] + 4)\n\
         y[0] = 3 * x[0] - x[0]^2 * (1/7) - 4 * t0\n\
         y[1] = 3 * t0 - 2 * x[1]\n"
    );
    assert_eq!(Tape::record(&RangeBearing).to_string(), "y[0] = sqrt(x[0]^2 + x[1]^2)\ny[1] = atan2(x[1], x[0])\n");
    assert_eq!(
        Tape::record(&Unicycle).to_string(),
        "y[0] = x[3] + x[0] + p[0] * cos(x[2])\n\
         y[1] = x[4] + x[1] + p[0] * sin(x[2])\n\
         y[2] = x[5] + x[2] + p[1]\n"
    );
    let text = Tape::record(&AttitudeOutput).to_string();
    assert!(text.contains("2 * (t"), "{text}");
}

#[test]
fn parentheses_keep_the_meaning() {
    function!(Parentheses, 9, |x, y| {
        let (a, b) = (x[0], x[1]);
        y[0] = a - (b - a);
        y[1] = a / (b / a);
        y[2] = (a + b).sqr() * (a - b).powi(-3);
        y[3] = -(a + b.exp());
        y[4] = (-a).sin() * (-a);
        y[5] = (a.scale(-0.5) - b).abs().scale(3.0);
        y[6] = a.add_f64(-2.5).recip() - b.add_f64(1.0);
        y[7] = a.stumpff(3).min(S::pi());
        y[8] = S::decimal("-0.1") * a + b.scale(-2.0) + S::lit(0.25, 0.5);
    });
    let expected = "\
        y[0] = x[0] - (x[1] - x[0])\n\
        y[1] = x[0] / (x[1] / x[0])\n\
        y[2] = (x[0] + x[1])^2 * (x[0] - x[1])^(-3)\n\
        y[3] = -(x[0] + exp(x[1]))\n\
        y[4] = -(x[0] * sin(-x[0]))\n\
        y[5] = 3 * abs(-0.5 * x[0] - x[1])\n\
        y[6] = 1 / (x[0] - 2.5) - (x[1] + 1)\n\
        y[7] = min(stumpff3(x[0]), pi)\n\
        y[8] = x[0] * (-0.1) - 2 * x[1] + [0.25, 0.5]\n";
    assert_eq!(Tape::record(&Parentheses).to_string(), expected);
}

/// A long chain is cut into named parts: no recursion as deep as the formula.
#[test]
fn long_chains_are_cut() {
    function!(Chain, 1, |x, y| {
        y[0] = (0..20_000).fold(x[0], |z, _| z.sin() * x[1]);
    });
    let text = Tape::record(&Chain).to_string();
    assert!(text.lines().count() > 1000 && text.lines().all(|line| line.len() < 800));
}
