//! The twelve example functions are what their users expect.

use nonlin_bounds::{DynFunction, Function, Jet, Order, Smoothness};
use scalars::Interval;

use crate::common::functions::{Attitude, Domain, Visitor, each};

struct Smooth(Jet);

impl Visitor for Smooth {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
        let cube: Vec<Interval> =
            domain.center.iter().zip(&domain.radius).map(|(c, r)| Interval::new(c - r, c + r).unwrap()).collect();
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        for order in [Order::Value, Order::Jacobian, Order::Hessian] {
            function.enclose(order, &cube, &p, &mut self.0).unwrap();
            assert!(
                self.0.smoothness().iter().all(|&s| s == Smoothness::C2),
                "{}: {:?}",
                domain.name,
                self.0.smoothness()
            );
            let bounded = |entries: &[Interval]| entries.iter().all(Interval::is_bounded);
            assert!(
                bounded(self.0.values()) && bounded(self.0.jacobian()) && bounded(self.0.hessians()),
                "{}",
                domain.name
            );
        }
        let mut y = vec![0.0; function.outputs()];
        function.value(&domain.center, &domain.parameters, &mut y).unwrap();
        for (y, range) in y.iter().zip(self.0.values()) {
            assert!(range.contains(*y), "{}", domain.name);
        }
    }
}

/// All are smooth on their whole domain, with bounded derivatives.
#[test]
fn are_smooth_on_their_domains() {
    each(&mut Smooth(Jet::new()));
}

/// The attitude model on a box whose rates are all zero somewhere: a model with `sin(p) / p`, `p` a square root, has unbounded
/// derivatives there; with Stumpff functions of `p^2` they are those at a rate of zero, up to the size of the box.
#[test]
fn attitude_is_tight_across_a_rate_of_zero() {
    let around = |center: f64, radius: f64| Interval::new(center - radius, center + radius).unwrap();
    let (no_rate, rates) = (Interval::ZERO, around(0.0, 3e-3));
    let state = [around(0.0, 0.1), around(1.0, 0.1), around(0.0, 0.1), around(0.0, 0.1)];
    let cube = [&state[..], &[rates; 3]].concat();
    let mut jet = Jet::new();
    Attitude.enclose(Order::Hessian, &cube, &[no_rate; 3], &mut jet).unwrap();
    assert!(jet.smoothness().iter().all(|&s| s == Smoothness::C2), "{:?}", jet.smoothness());
    let widest = |entries: &[Interval]| entries.iter().map(Interval::width).fold(0.0, f64::max);
    // Half the step times the widths of the states, and of the rates.
    assert!(widest(jet.jacobian()) < 0.021, "{}", widest(jet.jacobian()));
    assert!(widest(jet.hessians()) < 0.005, "{}", widest(jet.hessians()));
    assert!(widest(&jet.jacobian()[..4]) < 7e-4, "{}", widest(&jet.jacobian()[..4]));
}
