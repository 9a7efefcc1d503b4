//! Euler, Heun and Runge-Kutta steps.

use nonlin_bounds::{BoundError, DynFunction, Euler, Heun, Jet, Operand, Order, Rk4, Smoothness, function};
use scalars::Interval;

/// `x' = x^2` from 1 with step 1/2: small dyadic numbers, so that the steps are exact.
#[test]
fn steps_are_the_formulas() {
    let field = function!(|[x]: 1| -> 1 { [x.sqr()] });
    let mut y = [0.0];
    Euler::new(field).unwrap().value(&[1.0], &[0.5], &mut y).unwrap();
    assert_eq!(y, [1.5]);
    Heun::new(field).unwrap().value(&[1.0], &[0.5], &mut y).unwrap();
    assert_eq!(y, [1.8125]);
    Rk4::new(field).unwrap().value(&[1.0], &[0.5], &mut y).unwrap();
    let (k2, k3) = (1.5625, 1.390625_f64.powi(2));
    let k4 = (1.0 + 0.5 * k3).powi(2);
    assert!((y[0] - (1.0 + (1.0 + 2.0 * k2 + 2.0 * k3 + k4) / 12.0)).abs() < 1e-15);
}

/// The reactor of paper 001 after 300 steps of one second, and what its reaction conserves.
#[test]
fn the_reactor_of_paper_001() {
    let reactor = function!(|[a, b]: 2| -> 2 {
        let rate = S::decimal("0.16") * a.sqr() - S::decimal("0.0064") * b;
        [rate.scale(-2.0), rate]
    });
    let model = Rk4::new(reactor).unwrap();
    let (mut x, mut y) = ([3.0, 1.0], [0.0; 2]);
    for _ in 0..300 {
        model.value(&x, &[1.0 / 60.0], &mut y).unwrap();
        x = y;
    }
    assert!((x[0] - 0.57017).abs() < 1e-5 && (x[1] - 2.21491).abs() < 1e-5, "{x:?}");
    assert!((x[0] + 2.0 * x[1] - 5.0).abs() < 1e-12);
}

/// The Jacobian over a box against the product of the stages' Jacobians over the stages' boxes: neither is always the tighter one.
#[test]
fn the_jacobian_goes_through_the_stages() {
    let field = function!(|[a, b]: 2| -> 2 { [-(a * b), a * b - b] });
    let x = [Interval::new(0.9, 1.1), Interval::new(0.4, 0.6)].map(Result::unwrap);
    let h = Interval::ratio(1, 10);
    let mut jet = Jet::new();
    // J_i = DF(X_i) (I + c_i h J_{i-1}), summed with the weights of the step.
    let (mut at, mut stage, mut sum) = (x, [Interval::ZERO; 4], [Interval::ZERO; 4]);
    let identity = [Interval::ONE, Interval::ZERO, Interval::ZERO, Interval::ONE];
    for (weight, reach) in [(1.0, h.scale(0.5)), (2.0, h.scale(0.5)), (2.0, h), (1.0, h)] {
        let c = match (weight, reach == h) {
            (1.0, false) => Interval::ZERO,
            (2.0, false) | (2.0, true) => h.scale(0.5),
            _ => h,
        };
        field.enclose(Order::Jacobian, &at, &[], &mut jet).unwrap();
        let inner: Vec<Interval> = (0..4).map(|e| identity[e] + c * stage[e]).collect();
        let d = jet.jacobian();
        stage = [0, 1, 2, 3].map(|e| d[e / 2 * 2] * inner[e % 2] + d[e / 2 * 2 + 1] * inner[2 + e % 2]);
        sum = [0, 1, 2, 3].map(|e| sum[e] + stage[e].scale(weight));
        at = [0, 1].map(|i| x[i] + reach * jet.values()[i]);
    }
    Rk4::new(field).unwrap().enclose(Order::Jacobian, &x, &[h], &mut jet).unwrap();
    assert_eq!(jet.smoothness(), [Smoothness::C2; 2]);
    for (e, found) in jet.jacobian().iter().enumerate() {
        let product = identity[e] + h * Interval::ratio(1, 6) * sum[e];
        assert!(!found.disjoint(&product) && found.width() <= 1.15 * product.width(), "{e}: {found:?} {product:?}");
    }
}

/// A field may have variables that are no states; one with fewer variables than outputs is refused.
#[test]
fn shapes() {
    let noisy = Heun::new(function!(|[_x, w]: 2, [p]: 1| -> 1 { [w * p] })).unwrap();
    let mut y = [0.0];
    noisy.value(&[1.0, 2.0], &[3.0, 0.5], &mut y).unwrap();
    assert_eq!(y, [4.0]);
    let error = Euler::new(function!(|[x]: 1| -> 2 { [x, x] })).unwrap_err();
    assert_eq!(error, BoundError::Dimension { operand: Operand::Variables, expected: 2, found: 1 });
}
