//! The flow of `t' = 1, y_i' = f_i(t)` is an integral: every elementary function against its antiderivative.

use nonlin_bounds::{DynFunction, Flow, Function, Jet, Order};
use scalars::{Interval, Scalar};

/// Every elementary function of `t` in `(0, 1)`.
fn integrands<S: Scalar>(t: S) -> [S; 20] {
    let two = S::from_f64(2.0);
    [
        t.exp(),
        t.recip(),
        t.ln(),
        t.sqrt(),
        t.sin(),
        t.cos(),
        t.tan(),
        t.asin(),
        t.acos(),
        t.atan(),
        t.sinh(),
        t.cosh(),
        t.tanh(),
        t.powi(-3),
        t.powi(5),
        (t.stumpff(3) - t.stumpff(2)).scale(0.5),
        t.atan2(two),
        two.atan2(t),
        t.abs() * t.sign() + t.sqr(),
        t.min(two) - t.max(two) + two / t,
    ]
}

/// An antiderivative of each.
fn integrals<S: Scalar>(t: S) -> [S; 20] {
    let third = S::ratio(1, 3);
    let log4 = (t.sqr().add_f64(4.0)).ln();
    [
        t.exp(),
        t.ln(),
        t * t.ln() - t,
        t * t.sqrt() * third.scale(2.0),
        -t.cos(),
        t.sin(),
        -t.cos().ln(),
        t * t.asin() + (S::one() - t.sqr()).sqrt(),
        t * t.acos() - (S::one() - t.sqr()).sqrt(),
        t * t.atan() - t.sqr().add_f64(1.0).ln().scale(0.5),
        t.cosh(),
        t.sinh(),
        t.cosh().ln(),
        t.powi(-2).scale(-0.5),
        t.powi(6) * S::ratio(1, 6),
        t.stumpff(1),
        t * t.scale(0.5).atan() - log4,
        (S::pi().scale(0.5) * t) - (t * t.scale(0.5).atan() - log4),
        t.sqr().scale(0.5) + t.powi(3) * third,
        t.sqr().scale(0.5) - t.scale(2.0) + t.ln().scale(2.0),
    ]
}

struct Field;

impl Function for Field {
    const VARIABLES: Option<usize> = Some(21);
    fn outputs(&self) -> usize {
        21
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = S::one();
        y[1..].copy_from_slice(&integrands(x[0]));
    }
}

/// From a point, value and derivative by the start lie in tight enclosures: `y(h) = F(t + h) - F(t)`, `dy/dt = f(t + h) - f(t)`.
#[test]
fn every_function_integrates_to_its_antiderivative() {
    let flow = Flow::new(Field).unwrap();
    let mut jet = Jet::new();
    for t in [0.25, 0.5, 0.75] {
        for h in [0.00390625, -0.00390625] {
            let mut x = [Interval::ZERO; 21];
            x[0] = Interval::point(t);
            flow.enclose(Order::Jacobian, &x, &[Interval::point(h)], &mut jet).unwrap();
            let (before, after) = (Interval::point(t), Interval::point(t + h));
            let exact = integrals(after).into_iter().zip(integrals(before)).map(|(a, b)| a - b);
            for (i, exact) in exact.enumerate() {
                let found = jet.values()[i + 1];
                assert!(!found.disjoint(&exact), "integral {i} from {t}: {found:?} {exact:?}");
                assert!(found.width() < 2e-7, "integral {i} from {t}: {found:?}");
            }
            let exact = integrands(after).into_iter().zip(integrands(before)).map(|(a, b)| a - b);
            for (i, exact) in exact.enumerate() {
                let found = jet.jacobian()[21 * (i + 1)];
                assert!(!found.disjoint(&exact), "slope {i} from {t}: {found:?} {exact:?}");
                assert!(found.width() < 1e-5, "slope {i} from {t}: {found:?}");
            }
        }
    }
}

/// The value over `f64` is the same Taylor polynomial.
#[test]
fn the_value_is_close() {
    let (mut x, mut y) = ([0.0; 21], [0.0; 21]);
    x[0] = 0.5;
    Flow::new(Field).unwrap().value(&x, &[0.0078125], &mut y).unwrap();
    let (after, before) = (integrals(0.5078125), integrals(0.5));
    for i in 0..20 {
        assert!((y[i + 1] - (after[i] - before[i])).abs() < 2e-9, "{i}");
    }
}
