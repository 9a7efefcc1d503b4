//! The proven step against solutions in closed form, its size, and its errors.

use nonlin_bounds::{BoundError, DynFunction, Flow, Jet, Order, Smoothness, function};
use scalars::Interval;

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap()
}

/// A tight enclosure of the exact value is met, and the width is at most `factor` times that of the exact range, plus `slack`.
fn check(found: Interval, exact: &[Interval], factor: f64, slack: f64) {
    let range = exact.iter().fold(Interval::EMPTY, |hull, &x| hull.hull(x));
    assert!(exact.iter().all(|x| !found.disjoint(x)), "{found:?} {exact:?}");
    // The exact range reaches from the upper bound of the least value to the lower bound of the greatest.
    assert!(found.width() <= factor * range.width() + slack, "{found:?} {range:?}");
}

/// `x' = x (p - x)`: `x(h) = p x e^{ph} / (p + x (e^{ph} - 1))`, increasing in `x`, derivative `p^2 e^{ph} / (..)^2`.
#[test]
fn the_logistic_equation() {
    let flow = Flow::new(function!(|[x]: 1, [p]: 1| -> 1 { [x * (p - x)] })).unwrap();
    let solution = |x: f64, p: f64, h: f64| {
        let (x, p, growth) = (Interval::point(x), Interval::point(p), (Interval::point(p) * Interval::point(h)).exp());
        let divisor = p + x * (growth - Interval::ONE);
        (p * x * growth / divisor, p.sqr() * growth / divisor.sqr())
    };
    let mut jet = Jet::new();
    for (lo, hi) in [(0.3, 0.3), (0.3, 0.31), (0.2, 0.4), (1.5, 1.6)] {
        for h in [0.0625, 0.125, -0.0625] {
            for p in [1.0, 1.25] {
                let step = [Interval::point(p), Interval::point(h)];
                flow.enclose(Order::Jacobian, &[interval(lo, hi)], &step, &mut jet).unwrap();
                assert_eq!(jet.smoothness(), [Smoothness::C2]);
                let ends = [lo, 0.5 * (lo + hi), hi].map(|x| solution(x, p, h));
                check(jet.values()[0], &ends.map(|end| end.0), 2.0, 1e-6);
                check(jet.jacobian()[0], &ends.map(|end| end.1), 6.0, 1e-4);
                // The mean value form with this Jacobian.
                let middle = Interval::point(0.5 * (lo + hi));
                let spread = jet.jacobian()[0] * (interval(lo, hi) - middle);
                flow.enclose(Order::Value, &[middle], &step, &mut jet).unwrap();
                check(jet.values()[0] + spread, &ends.map(|end| end.0), 1.5, 1e-6);
            }
        }
    }
}

/// All parameters and all times of an interval are enclosed.
#[test]
fn intervals_of_parameters_and_times() {
    let flow = Flow::new(function!(|[x]: 1, [p]: 1| -> 1 { [-(p * x)] })).unwrap();
    let mut jet = Jet::new();
    let (p, h) = (interval(1.0, 1.5), interval(0.0, 0.125));
    flow.enclose(Order::Jacobian, &[interval(2.0, 3.0)], &[p, h], &mut jet).unwrap();
    for p in [1.0, 1.25, 1.5] {
        for h in [0.0, 0.0625, 0.125_f64] {
            let decay = (Interval::point(-p) * Interval::point(h)).exp();
            assert!(!jet.jacobian()[0].disjoint(&decay));
            assert!([2.0, 3.0].iter().all(|&x| !jet.values()[0].disjoint(&decay.scale(x))));
        }
    }
    assert!(jet.values()[0].width() < 1.6, "{:?}", jet.values());
}

/// The oscillator turns: value, Jacobian, and a Jacobian that is exact in width.
#[test]
fn the_harmonic_oscillator() {
    let flow = Flow::new(function!(|[x, v]: 2| -> 2 { [v, -x] })).unwrap();
    let mut jet = Jet::new();
    let (x, h) = ([interval(0.9, 1.1), interval(-0.1, 0.1)], Interval::point(0.125));
    flow.enclose(Order::Jacobian, &x, &[h], &mut jet).unwrap();
    let (sin, cos) = h.sin_cos();
    for (found, exact) in jet.jacobian().iter().zip([cos, sin, -sin, cos]) {
        check(*found, &[exact], 1.0, 1e-5);
    }
    let exact = [cos * x[0] + sin * x[1], cos * x[1] - sin * x[0]];
    for (found, exact) in jet.values().iter().zip(exact) {
        assert!(
            exact.lo() >= found.lo() - 1e-15 && exact.hi() <= found.hi() + 1e-15 && found.width() < 1.3 * exact.width()
        );
    }
}

/// Variables that are no states are constant inputs, with derivatives.
#[test]
fn noises_are_constant_over_the_step() {
    let flow = Flow::new(function!(|[_x, w]: 2| -> 1 { [w] })).unwrap();
    let mut jet = Jet::new();
    flow.enclose(Order::Jacobian, &[interval(0.0, 1.0), interval(-1.0, 1.0)], &[Interval::point(0.5)], &mut jet)
        .unwrap();
    assert!(interval(-0.5, 1.5).subset_of(&jet.values()[0]) && jet.values()[0].width() < 2.0 + 1e-12);
    assert!(jet.jacobian()[0].contains(1.0) && jet.jacobian()[1].contains(0.5));
    assert!(jet.jacobian().iter().all(|d| d.width() < 1e-12));
}

/// What can not be proven is refused, and the jet keeps what it held.
#[test]
fn errors() {
    let explosion = Flow::new(function!(|[x]: 1| -> 1 { [x.sqr()] })).unwrap();
    let mut jet = Jet::new();
    explosion.enclose(Order::Value, &[Interval::ONE], &[Interval::point(0.125)], &mut jet).unwrap();
    let before = jet.clone();
    let error = explosion.enclose(Order::Value, &[Interval::ONE], &[Interval::point(2.0)], &mut jet).unwrap_err();
    assert_eq!(error, BoundError::NoAPrioriEnclosure { step: 2.0 });
    let error = explosion.enclose(Order::Hessian, &[Interval::ONE], &[Interval::ONE], &mut jet).unwrap_err();
    assert_eq!(error, BoundError::OrderNotAvailable { order: 2 });
    assert!(matches!(explosion.enclose(Order::Value, &[], &[], &mut jet), Err(BoundError::Dimension { .. })));
    let kinked = Flow::new(function!(|[x]: 1| -> 1 { [x.abs()] })).unwrap();
    let error = kinked.enclose(Order::Value, &[interval(-1.0, 1.0)], &[Interval::point(0.125)], &mut jet).unwrap_err();
    assert_eq!(error, BoundError::NotSmooth { output: 0, required: Smoothness::C2, found: Smoothness::C0 });
    // The root is left behind during the step, not at its beginning.
    let root = Flow::new(function!(|[x]: 1| -> 1 { [-x.sqrt()] })).unwrap();
    assert!(root.enclose(Order::Value, &[interval(0.01, 1.0)], &[Interval::point(0.5)], &mut jet).is_err());
    assert_eq!(jet, before);
}

/// A step in steady state allocates nothing.
#[test]
fn steady_state_allocates_nothing() {
    let flow = Flow::new(function!(|[x, v]: 2| -> 2 { [v, -x.sin()] })).unwrap();
    let mut jet = Jet::new();
    let mut step =
        || flow.enclose(Order::Jacobian, &[Interval::ONE, Interval::ZERO], &[Interval::point(0.1)], &mut jet);
    step().unwrap();
    step().unwrap();
    assert_eq!(allocation_counter::measure(|| step().unwrap()).count_total, 0);
}
