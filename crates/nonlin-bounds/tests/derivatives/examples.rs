//! The twelve example functions are what their users expect.

use nonlin_bounds::{DynFunction, Function, Jet, Order, Smoothness};
use scalars::Interval;

use crate::common::functions::{Domain, Visitor, each};

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
