//! Random polynomials and polytopes with so few bits that their values and members are exact floats.

use nonlin_bounds::Function;
use scalars::Scalar;
use setrep::{Matrix, VPolytope};

use crate::common::random::Random;

/// `y_i = sum_t c_t prod_k x_k^(e_tk)` with integer coefficients and degree at most 3.
#[derive(Debug, Clone)]
pub(crate) struct Polynomials {
    pub(crate) variables: usize,
    pub(crate) outputs: Vec<Vec<(f64, Vec<usize>)>>,
}

impl Polynomials {
    /// `outputs` polynomials of up to four terms; every third one is affine.
    pub(crate) fn random(random: &mut Random, variables: usize, outputs: usize) -> Self {
        let output = |random: &mut Random| {
            let degree = if random.below(3) == 0 { 1 } else { 3 };
            let term = |random: &mut Random| {
                let coefficient = random.below(9) as f64 - 4.0;
                (coefficient, (0..random.below(degree + 1)).map(|_| random.below(variables)).collect())
            };
            (0..=random.below(4)).map(|_| term(random)).collect()
        };
        Self { variables, outputs: (0..outputs).map(|_| output(random)).collect() }
    }

    /// The values at a point, exact for members of [`polytope`].
    pub(crate) fn exact(&self, x: &[f64]) -> Vec<f64> {
        let term = |(c, factors): &(f64, Vec<usize>)| factors.iter().fold(*c, |product, &k| product * x[k]);
        self.outputs.iter().map(|terms| terms.iter().map(term).sum()).collect()
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
        for (y, terms) in y.iter_mut().zip(&self.outputs) {
            *y = S::zero();
            for (c, factors) in terms {
                // A square as such, so that its range over an interval with 0 is not doubled.
                let product = match factors[..] {
                    [i, j] if i == j => x[i].sqr(),
                    _ => factors.iter().fold(S::one(), |product, &k| product * x[k]),
                };
                *y += product.scale(*c);
            }
        }
    }
}

/// Up to `3 n + 2` points with multiples of 1/4 as coordinates, at most 8; in one case of three with a remainder.
pub(crate) fn polytope(random: &mut Random, n: usize) -> VPolytope {
    let size = 1 + random.below(16);
    let center: Vec<f64> = (0..n).map(|_| (random.below(33) as f64 - 16.0) / 4.0).collect();
    let coordinate =
        |random: &mut Random, k: usize| center[k] + (random.below(2 * size + 1) as f64 - size as f64) / 4.0;
    let count = 1 + random.below(3 * n + 2);
    let entries: Vec<f64> = (0..count * n).map(|i| coordinate(random, i % n)).collect();
    let scale = if random.below(3) == 0 { 0.25 } else { 0.0 };
    let remainder: Vec<f64> = (0..n).map(|_| scale * random.below(3) as f64).collect();
    VPolytope::with_remainder(Matrix::from_column_slice(n, count, &entries).unwrap(), &remainder).unwrap()
}

/// A member: weights and the place in the remainder are multiples of 1/8.
pub(crate) fn member(random: &mut Random, set: &VPolytope) -> Vec<f64> {
    let mut x = vec![0.0; set.dim()];
    let few = random.below(3) == 0;
    let fixed = random.below(set.num_vertices());
    for _ in 0..8 {
        let vertex = if few { fixed } else { random.below(set.num_vertices()) };
        x.iter_mut().zip(set.vertices().col(vertex)).for_each(|(x, v)| *x += v / 8.0);
    }
    for (x, r) in x.iter_mut().zip(set.remainder()) {
        *x += r * (random.below(17) as f64 - 8.0) / 8.0;
    }
    x
}

/// A point of the hull: its middle, a vertex, or any.
pub(crate) fn expansion_point(random: &mut Random, set: &VPolytope) -> Vec<f64> {
    let hull = set.interval_hull();
    match random.below(3) {
        0 => hull.mid(),
        1 => set.vertices().col(random.below(set.num_vertices())).to_vec(),
        _ => random.point(&hull),
    }
}
