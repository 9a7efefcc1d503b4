//! Polynomials with rational coefficients: enclosures contain the exact rational derivatives, and are as small as they can be.

use nonlin_bounds::{DynFunction, Function, Jet, Order};
use num_rational::BigRational;
use num_traits::Zero;
use scalars::{Interval, Scalar};

use crate::common::random::{Random, cases};

/// Coefficients and exponents of the terms of a polynomial in three variables.
struct Polynomial {
    terms: Vec<(i64, i64, [i32; 3])>,
}

impl Function for Polynomial {
    const VARIABLES: Option<usize> = Some(3);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = self.terms.iter().fold(S::zero(), |sum, &(p, q, exponents)| {
            sum + (0..3).fold(S::ratio(p, q), |term, i| term * x[i].powi(exponents[i]))
        });
    }
}

impl Polynomial {
    fn random(random: &mut Random, degree: i32) -> Self {
        let mut integer = |low: i64, high: i64| low + random.below((high - low + 1) as usize) as i64;
        let terms = (0..4)
            .map(|_| {
                let mut left = degree;
                let exponents = [0; 3].map(|_| {
                    let exponent = integer(0, i64::from(left)) as i32;
                    left -= exponent;
                    exponent
                });
                (integer(-9, 9), integer(1, 9), exponents)
            })
            .collect();
        Self { terms }
    }

    /// The derivative by the given variables, exactly.
    fn derivative(&self, by: &[usize], x: &[BigRational]) -> BigRational {
        self.terms.iter().fold(BigRational::zero(), |sum, &(p, q, mut exponents)| {
            let mut term = BigRational::new(p.into(), q.into());
            for &i in by {
                term *= BigRational::from_integer(exponents[i].into());
                exponents[i] -= 1;
            }
            // A coefficient of zero takes exponents below zero with it.
            let powers = (0..3).filter(|&i| exponents[i] > 0);
            sum + powers.fold(term, |term, i| term * num_traits::pow(x[i].clone(), exponents[i] as usize))
        })
    }
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

fn contains(range: Interval, value: &BigRational) -> bool {
    rational(range.lo()) <= *value && *value <= rational(range.hi())
}

/// Every exact derivative at every point drawn lies in its enclosure, for boxes down to a point.
#[test]
fn contain_the_exact_derivatives_of_polynomials() {
    const SEED: u64 = 0xe_ac7;
    let mut jet = Jet::new();
    for case in 0..cases(500) {
        let mut random = Random::new(SEED, case);
        let f = Polynomial::random(&mut random, 5);
        let cube = random.subbox(&[0.3, -0.7, 0.0], &[2.0, 2.0, 2.0]);
        f.enclose(Order::Hessian, &cube, &[], &mut jet).unwrap();
        for _ in 0..5 {
            let x: Vec<BigRational> = random.point(&cube).into_iter().map(rational).collect();
            let check = |range: Interval, by: &[usize]| {
                assert!(contains(range, &f.derivative(by, &x)), "by {by:?}, seed {SEED:#x}, case {case}: {range:?}");
            };
            check(jet.values()[0], &[]);
            let mut entry = 0;
            for i in 0..3 {
                check(jet.jacobian()[i], &[i]);
                for j in i..3 {
                    check(jet.hessians()[entry], &[i, j]);
                    entry += 1;
                }
            }
        }
    }
}

/// The Hessian of a quadratic is a number, whatever the box: its enclosure is some units in the last place wide, and an entry
/// that is zero by structure is exactly zero.
#[test]
fn hessians_of_quadratics_are_singletons() {
    let f = nonlin_bounds::function!(|[x, y, z]: 3| -> 1 {
        [S::ratio(1, 7) * x.sqr() - (x * y).scale(3.0) + (z + x) * (z - y).scale(0.5) + y / S::ratio(3, 1)]
    });
    let mut jet = Jet::new();
    let cube = [Interval::new(-1e3, 2e3), Interval::new(5.0, 6.0), Interval::new(-1e-3, 0.0)].map(Result::unwrap);
    f.enclose(Order::Hessian, &cube, &[], &mut jet).unwrap();
    let expected = [(2, 7), (-7, 2), (1, 2), (0, 1), (-1, 2), (1, 1)];
    for (range, (p, q)) in jet.hessians().iter().zip(expected) {
        assert!(contains(*range, &BigRational::new(p.into(), q.into())), "{range:?} {p}/{q}");
        assert!(range.width() <= 16.0 * f64::EPSILON * range.mag(), "{range:?}");
    }
    assert_eq!(jet.hessians()[3], Interval::ZERO);
}
