//! Random polynomials, as functions and in exact rationals.

use nonlin_bounds::Function;
use num_rational::BigRational;
use scalars::{Interval, Scalar};

use super::random::Random;

/// The exact value of a finite number.
pub(crate) fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// Whether an exact number lies in an interval.
pub(crate) fn lies_in(x: &BigRational, interval: Interval) -> bool {
    interval.is_bounded() && *x >= rational(interval.lo()) && *x <= rational(interval.hi())
}

/// Sums of monomials `a x_1^k_1 .. x_n^k_n`, one sum an output.
#[derive(Debug, Clone)]
pub(crate) struct Polynomials {
    pub(crate) variables: usize,
    pub(crate) outputs: Vec<Vec<(f64, Vec<i32>)>>,
}

impl Polynomials {
    /// Up to five monomials an output of the given degree at most.
    pub(crate) fn random(variables: usize, outputs: usize, degree: usize, random: &mut Random) -> Self {
        let monomial = |random: &mut Random| {
            let mut exponents = vec![0; variables];
            for _ in 0..random.below(degree + 1) {
                exponents[random.below(variables)] += 1;
            }
            (random.unit() * 4.0, exponents)
        };
        let output = |random: &mut Random| (0..=random.below(5)).map(|_| monomial(random)).collect();
        Self { variables, outputs: (0..outputs).map(|_| output(random)).collect() }
    }

    /// The exact value of an output.
    pub(crate) fn exact(&self, output: usize, x: &[BigRational]) -> BigRational {
        let monomial = |(a, exponents): &(f64, Vec<i32>)| {
            exponents.iter().zip(x).fold(rational(*a), |product, (&k, x)| product * x.pow(k))
        };
        self.outputs[output].iter().map(monomial).sum()
    }
}

impl Function for Polynomials {
    fn variables(&self) -> usize {
        self.variables
    }
    fn outputs(&self) -> usize {
        self.outputs.len()
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (y, monomials) in y.iter_mut().zip(&self.outputs) {
            *y = monomials.iter().fold(S::zero(), |sum, (a, exponents)| {
                let powers = exponents.iter().zip(x).filter(|(k, _)| **k > 0);
                sum + powers.fold(S::from_f64(*a), |product, (&k, &x)| product * x.powi(k))
            });
        }
    }
}
