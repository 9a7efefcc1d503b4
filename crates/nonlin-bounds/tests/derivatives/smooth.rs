//! Smoothness is claimed where it is proven, and only there; derivatives of the rest are the whole line.

use nonlin_bounds::{BoundError, DynFunction, Function, Jet, Operand, Order, Smoothness, function};
use scalars::{Interval, Scalar};

use Smoothness::{C0, C2, Defined, Undefined};

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// Smoothness of a function of two variables over `[a] x [b]`, its derivatives checked against it.
fn smoothness(f: &impl Function, a: (f64, f64), b: (f64, f64)) -> Smoothness {
    let mut jet = Jet::new();
    f.enclose(Order::Hessian, &[interval(a.0, a.1), interval(b.0, b.1)], &[], &mut jet).unwrap();
    let found = jet.smoothness()[0];
    if found < Smoothness::C1 {
        assert!(jet.jacobian().iter().all(|d| *d == Interval::ENTIRE || *d == Interval::ZERO));
        assert!(jet.hessians().iter().all(|d| *d == Interval::ENTIRE || *d == Interval::ZERO));
        assert!(jet.jacobian().contains(&Interval::ENTIRE) && jet.hessians().contains(&Interval::ENTIRE));
    } else {
        assert!(jet.jacobian().iter().all(|d| !d.is_empty()));
    }
    found
}

/// One operation on `(x, y)`, chosen at run time: a function type for each would be compiled for every number type.
struct Operation(&'static str);

impl Function for Operation {
    const VARIABLES: Option<usize> = Some(2);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, z: &[S], _: &[S], out: &mut [S]) {
        let (x, y) = (z[0], z[1]);
        out[0] = match self.0 {
            "sqrt" => x.sqrt(),
            "recip" => x.recip(),
            "ln" => x.ln(),
            "tan" => x.tan(),
            "asin" => x.asin(),
            "acos" => x.acos(),
            "abs" => x.abs(),
            "sign" => x.sign(),
            "exp" => x.exp(),
            "atan" => x.atan(),
            "tanh" => x.tanh(),
            "x^-2" => x.powi(-2),
            "x^3" => x.powi(3),
            "C0" => x.stumpff(0),
            "C21" => x.stumpff(21),
            "sqrt(x^2)" => x.sqr().sqrt(),
            "1/(x - y)" => (x - y).recip(),
            "min" => x.min(y),
            "max" => x.max(y),
            "angle" => y.atan2(x),
            "quotient" => x / y,
            other => panic!("{other}"),
        };
    }
}

/// Every function whose domain or smoothness ends somewhere, on boxes before, at and beyond the end.
#[test]
fn ends_with_the_domain() {
    let table = [
        (
            "sqrt",
            &[(0.5, 1.0, C2), (0.0, 1.0, C0), (0.0, 0.0, C0), (-1e-300, 1.0, Undefined), (-2.0, -1.0, Undefined)][..],
        ),
        (
            "recip",
            &[(0.5, 1.0, C2), (-1.0, -0.5, C2), (0.0, 1.0, Undefined), (-1.0, 1.0, Undefined), (0.0, 0.0, Undefined)],
        ),
        ("ln", &[(0.5, 1.0, C2), (0.0, 1.0, Undefined), (-1.0, 1.0, Undefined)]),
        ("tan", &[(-1.5, 1.5, C2), (1.0, 2.0, Undefined), (0.0, 10.0, Undefined), (2.0, 4.0, C2)]),
        ("asin", &[(-0.9, 0.9, C2), (-1.0, 0.0, C0), (0.0, 1.0, C0), (0.0, 1.5, Undefined)]),
        ("acos", &[(-0.9, 0.9, C2), (-1.0, 0.0, C0), (0.0, 1.0, C0), (-1.5, 0.0, Undefined)]),
        ("abs", &[(0.5, 1.0, C2), (-1.0, -0.5, C2), (-1.0, 1.0, C0), (0.0, 1.0, C0)]),
        ("sign", &[(0.5, 1.0, C2), (-1.0, 1.0, Defined)]),
        ("exp", &[(-9.0, 9.0, C2)]),
        ("atan", &[(-9.0, 9.0, C2)]),
        ("tanh", &[(-9.0, 900.0, C2)]),
        ("x^-2", &[(-1.0, 1.0, Undefined), (1.0, 2.0, C2)]),
        ("x^3", &[(-1.0, 1.0, C2)]),
        ("C0", &[(-1.0, 1.0, C2)]),
        ("C21", &[(-1.0, 1.0, Undefined)]),
        ("sqrt(x^2)", &[(-1.0, 1.0, C0), (0.1, 1.0, C2)]),
        ("1/(x - y)", &[(0.1, 0.2, Undefined)]),
    ];
    for (name, rows) in table {
        for &(lo, hi, expected) in rows {
            assert_eq!(smoothness(&Operation(name), (lo, hi), (0.0, 1.0)), expected, "{name} on [{lo}, {hi}]");
        }
    }
}

/// Functions of two arguments: ties of `min` and `max`, the cut and the origin of `atan2`, division.
#[test]
fn of_two_arguments() {
    let min = Operation("min");
    assert_eq!(smoothness(&min, (0.0, 1.0), (2.0, 3.0)), C2);
    assert_eq!(smoothness(&min, (0.0, 1.0), (1.0, 3.0)), C0);
    let max = Operation("max");
    assert_eq!(smoothness(&max, (0.0, 1.0), (-2.0, -1.0)), C2);
    assert_eq!(smoothness(&max, (0.0, 1.0), (0.5, 0.6)), C0);
    let angle = Operation("angle");
    assert_eq!(smoothness(&angle, (0.1, 1.0), (-1.0, 1.0)), C2);
    assert_eq!(smoothness(&angle, (-1.0, 1.0), (0.1, 1.0)), C2);
    assert_eq!(smoothness(&angle, (-1.0, -0.5), (-1.0, -0.1)), C2);
    assert_eq!(smoothness(&angle, (-1.0, -0.5), (0.0, 1.0)), C0);
    assert_eq!(smoothness(&angle, (-1.0, -0.5), (-1.0, 1.0)), Defined);
    assert_eq!(smoothness(&angle, (-1.0, -0.5), (-1.0, 0.0)), Defined);
    assert_eq!(smoothness(&angle, (-1.0, 1.0), (-1.0, 1.0)), Undefined);
    assert_eq!(smoothness(&angle, (0.0, 1.0), (0.0, 1.0)), Undefined);
    let quotient = Operation("quotient");
    assert_eq!(smoothness(&quotient, (0.0, 1.0), (0.5, 1.0)), C2);
    assert_eq!(smoothness(&quotient, (0.0, 1.0), (0.0, 1.0)), Undefined);
}

/// The least of what an output is made of counts: a later step does not mend it, an unused one does not spoil it, and the other
/// outputs keep theirs.
#[test]
fn is_that_of_what_an_output_uses() {
    let f = function!(|[x, y]: 2| -> 4 {
        let undefined = x.ln();
        [undefined.exp(), y.abs().sqr() * y, y.sqr(), undefined * S::zero() + y]
    });
    let mut jet = Jet::new();
    f.enclose(Order::Jacobian, &[interval(-1.0, 1.0), interval(-1.0, 1.0)], &[], &mut jet).unwrap();
    assert_eq!(jet.smoothness(), [Undefined, C0, C2, Undefined]);
    assert_eq!(&jet.jacobian()[4..6], [Interval::ZERO, jet.jacobian()[5]]);
    assert!(jet.jacobian()[5].is_bounded());
    // Output 1 does not depend on x: that derivative is zero, not unknown.
    assert_eq!(&jet.jacobian()[2..4], [Interval::ZERO, Interval::ENTIRE]);
}

/// What depends on parameters only is a number: its kinks are no kinks of the function, its poles are.
#[test]
fn parameters_bring_no_kinks() {
    let f = function!(|[x]: 1, [p]: 1| -> 3 { [p.abs() * x, p.sqrt() + x, p.min(S::zero()).max(-p) * x.sqr()] });
    let g = function!(|[x]: 1, [p]: 1| -> 2 { [x / p, x * p.ln()] });
    let (x, p) = ([interval(1.0, 2.0)], [interval(0.0, 1.0)]);
    let mut jet = Jet::new();
    f.enclose(Order::Hessian, &x, &p, &mut jet).unwrap();
    assert_eq!(jet.smoothness(), [C2, C2, C2]);
    assert!(jet.jacobian()[0].contains(0.0) && jet.jacobian()[0].contains(1.0));
    g.enclose(Order::Hessian, &x, &p, &mut jet).unwrap();
    assert_eq!(jet.smoothness(), [Undefined, Undefined]);
}

/// Constants that are no numbers leave nothing proven.
#[test]
fn constants_that_are_no_numbers() {
    let f = function!(|[x]: 1| -> 5 {
        [x * S::ratio(1, 0), x + S::decimal("one"), x.scale(f64::NAN), x.add_f64(f64::INFINITY), x * S::lit(2.0, 1.0)]
    });
    let mut jet = Jet::new();
    f.enclose(Order::Hessian, &[interval(1.0, 2.0)], &[], &mut jet).unwrap();
    assert_eq!(jet.smoothness(), [Undefined; 5]);
}

/// Bad input: typed errors that name what and where; the jet stays as it was.
#[test]
fn bad_input() {
    let f = function!(|[x, y]: 2, [p]: 1| -> 1 { [x * y * p] });
    let good = [interval(0.0, 1.0), interval(0.0, 1.0)];
    let mut jet = Jet::new();
    f.enclose(Order::Jacobian, &good, &good[..1], &mut jet).unwrap();
    let before = jet.clone();
    let mut error = |x: &[Interval], p: &[Interval]| {
        let error = f.enclose(Order::Hessian, x, p, &mut jet).unwrap_err();
        assert_eq!(jet, before);
        error
    };
    let dimension = |operand, expected, found| BoundError::Dimension { operand, expected, found };
    assert_eq!(error(&good[..1], &good[..1]), dimension(Operand::Variables, 2, 1));
    assert_eq!(error(&good, &good), dimension(Operand::Parameters, 1, 2));
    let empty = [good[0], Interval::EMPTY];
    assert_eq!(error(&empty, &good[..1]), BoundError::EmptyInterval { operand: Operand::Variables, index: 1 });
    let unbounded = [Interval::ENTIRE];
    assert_eq!(error(&good, &unbounded), BoundError::NonFinite { operand: Operand::Parameters, index: 0 });
    assert_eq!(f.value(&[1.0], &[1.0], &mut [0.0]).unwrap_err(), dimension(Operand::Variables, 2, 1));
    assert_eq!(f.value(&[1.0, 1.0], &[], &mut [0.0]).unwrap_err(), dimension(Operand::Parameters, 1, 0));
    assert_eq!(f.value(&[1.0, 1.0], &[1.0], &mut []).unwrap_err(), dimension(Operand::Outputs, 1, 0));
}
