//! Every method contains the values at random points of random boxes.

use nonlin_bounds::{DynFunction, Function, Jet, Order, Workspace, range};
use scalars::Interval;

use super::METHODS;
use crate::common::functions::{Domain, Visitor, each};
use crate::common::polynomial::{Polynomials, lies_in, rational};
use crate::common::random::{Random, cases};

const SEED: u64 = 0x0003_2001;

/// Exact rational values of random polynomials.
#[test]
fn polynomials() {
    let mut workspace = Workspace::new();
    let mut triples = 0;
    for case in 0..cases(1000) {
        let mut random = Random::new(SEED, case);
        let variables = 1 + random.below(4);
        let f = Polynomials::random(variables, 2, 4, &mut random);
        let center: Vec<f64> = (0..variables).map(|_| 3.0 * random.unit()).collect();
        let x = random.subbox(&center, &vec![2.0; variables]);
        let points: Vec<Vec<f64>> = (0..4).map(|_| random.point(&x)).collect();
        for method in METHODS {
            let mut y = [Interval::EMPTY; 2];
            range(&f, &x, &[], method, &mut workspace, &mut y).unwrap();
            for point in &points {
                let point: Vec<_> = point.iter().map(|&x| rational(x)).collect();
                for i in 0..2 {
                    triples += 1;
                    assert!(
                        lies_in(&f.exact(i, &point), y[i]),
                        "seed {SEED} case {case} {method:?}: output {i} of {f:?} at {point:?} outside {:?}",
                        y[i]
                    );
                }
            }
        }
    }
    println!("{triples} polynomial values in their ranges");
    assert!(triples >= cases(40_000));
}

/// The twelve functions: the value at a point, in interval arithmetic, is never proven to lie outside.
#[test]
fn twelve_functions() {
    struct Values {
        triples: usize,
    }
    impl Visitor for Values {
        fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
            let f: &dyn DynFunction = &function;
            let (mut workspace, mut jet) = (Workspace::new(), Jet::new());
            let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
            for case in 0..cases(60) {
                let mut random = Random::new(SEED + 1, case);
                let x = random.subbox(&domain.center, &domain.radius);
                let points: Vec<Vec<f64>> = (0..20).map(|_| random.point(&x)).collect();
                for method in METHODS {
                    let mut y = vec![Interval::EMPTY; f.outputs()];
                    range(f, &x, &p, method, &mut workspace, &mut y)
                        .unwrap_or_else(|error| panic!("{} {method:?} on {x:?}: {error}", domain.name));
                    for point in &points {
                        let at: Vec<Interval> = point.iter().map(|&x| Interval::point(x)).collect();
                        f.enclose(Order::Value, &at, &p, &mut jet).unwrap();
                        for (i, (y, value)) in y.iter().zip(jet.values()).enumerate() {
                            self.triples += 1;
                            assert!(
                                !y.disjoint(value),
                                "{} {method:?}, case {case}: output {i} at {point:?} is {value:?}, outside {y:?}",
                                domain.name
                            );
                        }
                    }
                }
            }
        }
    }
    let mut values = Values { triples: 0 };
    each(&mut values);
    println!("{} values in their ranges", values.triples);
    assert!(values.triples >= cases(50_000));
}

/// Parameters with a width: the range covers every one of them.
#[test]
fn wide_parameters() {
    struct Affine;
    impl Function for Affine {
        const VARIABLES: Option<usize> = Some(1);
        fn parameters(&self) -> usize {
            1
        }
        fn outputs(&self) -> usize {
            1
        }
        fn eval<S: scalars::Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
            y[0] = p[0] * x[0].sqr() - x[0] * p[0].sqr();
        }
    }
    let (mut workspace, f) =
        (Workspace::new(), Polynomials { variables: 2, outputs: vec![vec![(1.0, vec![2, 1]), (-1.0, vec![1, 2])]] });
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 2, case);
        let xp = random.subbox(&[1.0, -0.5], &[3.0, 2.0]);
        for method in METHODS {
            let mut y = [Interval::EMPTY];
            range(&Affine, &xp[..1], &xp[1..], method, &mut workspace, &mut y).unwrap();
            for _ in 0..4 {
                let point: Vec<_> = random.point(&xp).into_iter().map(rational).collect();
                assert!(lies_in(&f.exact(0, &point), y[0]), "{method:?} {xp:?} {point:?} {y:?}");
            }
        }
    }
}
