//! Derivatives by a plan are those without one.

use nonlin_bounds::{DynFunction, Function, Jet, Order, Smoothness, Structured};
use scalars::{Interval, Scalar};

use crate::common::functions::{Domain, Visitor, each};
use crate::common::polynomial::Polynomials;
use crate::common::random::Random;

/// A function of tests is shared by reference.
struct Shared<'a, F>(&'a F);

impl<F: Function> Function for Shared<'_, F> {
    fn variables(&self) -> usize {
        self.0.variables()
    }
    fn parameters(&self) -> usize {
        self.0.parameters()
    }
    fn outputs(&self) -> usize {
        self.0.outputs()
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        self.0.eval(x, p, y);
    }
}

/// All entries are equal; where the output is not smooth, what is zero by structure is known to be zero.
fn compare<F: Function>(f: &F, x: &[Interval], p: &[Interval]) {
    let structured = Structured::new(Shared(f));
    let (mut plain, mut planned) = (Jet::new(), Jet::new());
    for order in [Order::Value, Order::Jacobian, Order::Hessian] {
        f.enclose(order, x, p, &mut plain).unwrap();
        structured.enclose(order, x, p, &mut planned).unwrap();
        assert_eq!(plain.values(), planned.values());
        assert_eq!(plain.jacobian(), planned.jacobian());
        assert_eq!(plain.smoothness(), planned.smoothness());
        let entries = x.len() * (x.len() + 1) / 2;
        for (k, (a, b)) in plain.hessians().iter().zip(planned.hessians()).enumerate() {
            let smooth = plain.smoothness()[k / entries] == Smoothness::C2;
            assert!(a == b || (!smooth && *a == Interval::ENTIRE && *b == Interval::ZERO), "{a:?} {b:?}");
        }
    }
}

struct Compare;

impl Visitor for Compare {
    fn visit<F: Function + 'static>(&mut self, f: F, domain: Domain) {
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        for share in [1.0, 0.1] {
            let sides = domain.center.iter().zip(&domain.radius);
            let x: Vec<Interval> = sides.map(|(&c, &r)| Interval::point(c).inflate(share * r)).collect();
            compare(&f, &x, &p);
        }
    }
}

#[test]
fn plans_change_no_entry() {
    each(&mut Compare);
    let mut random = Random::new(17, 0);
    for _ in 0..200 {
        let n = 1 + random.below(14);
        let f = Polynomials::random(n, 1 + random.below(3), 3, &mut random);
        let x: Vec<Interval> =
            (0..n).map(|_| Interval::point(random.unit()).inflate(0.3 * random.unit().abs())).collect();
        compare(&f, &x, &[]);
    }
}

/// A chain of `n` levels with additive noises, some of it not smooth.
struct Chain {
    n: usize,
}

impl Function for Chain {
    fn variables(&self) -> usize {
        2 * self.n
    }
    fn outputs(&self) -> usize {
        self.n
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (i, y) in y.iter_mut().enumerate() {
            let before = if i == 0 { x[0].abs() } else { x[i - 1].sqrt() };
            *y = x[i] + before - x[i].sqrt() + x[self.n + i].scale(0.5);
        }
    }
}

#[test]
fn plans_of_many_variables_change_no_entry() {
    for n in [1, 2, 3, 4, 7, 8, 9, 20, 33] {
        let x: Vec<Interval> = (0..2 * n).map(|i| Interval::point(2.0 + i as f64).inflate(0.5)).collect();
        compare(&Chain { n }, &x, &[]);
        // The first level around zero: its outputs have no derivatives.
        let mut x = x;
        x[0] = Interval::new(-1.0, 1.0).unwrap();
        compare(&Chain { n }, &x, &[]);
    }
}

/// Constants have no variables to plan for.
#[test]
fn functions_without_variables_have_values() {
    struct Two;
    impl Function for Two {
        const VARIABLES: Option<usize> = Some(0);
        fn outputs(&self) -> usize {
            1
        }
        fn eval<S: Scalar>(&self, _: &[S], _: &[S], y: &mut [S]) {
            y[0] = S::from_f64(2.0);
        }
    }
    compare(&Two, &[], &[]);
}
