//! What a quadratic enclosure is built from and in.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};
use setrep::Matrix;

use crate::Domain;

/// What a quadratic enclosure is built from and in.
#[derive(Debug, Clone, Default)]
pub(crate) struct Parts {
    /// Generators, with the components of the remainder of model size among them, and the rest of the remainder.
    pub(super) columns: Matrix,
    pub(super) rest: Vec<f64>,
    /// `p = c - gamma`, `H - gamma`, `H - c`, `L = p'Q`, `f''(H) G`.
    pub(super) shift: Vec<Interval>,
    pub(super) steps: Vec<Interval>,
    pub(super) about_center: Vec<Interval>,
    pub(super) cross: Vec<Interval>,
    pub(super) curved: Vec<Interval>,
    /// Generators, constraints and ranges of `K`, and the columns that are not zero.
    pub(super) generators: Matrix,
    pub(super) rows: Matrix,
    pub(super) ranges: Vec<Interval>,
    pub(super) kept: Matrix,
    pub(super) kept_rows: Matrix,
    pub(super) zeros: Vec<f64>,
}

impl Parts {
    /// `H - gamma`, `H - c` and `c - gamma`.
    pub(super) fn boxes(&mut self, domain: &Domain<'_>, center: &[f64]) {
        self.steps.clear();
        self.about_center.clear();
        self.shift.clear();
        for ((side, &at), &c) in domain.hull.iter().zip(domain.at).zip(center) {
            self.steps.push(side.add_f64(-at));
            self.about_center.push(side.add_f64(-c));
            self.shift.push(Interval::point(c).add_f64(-at));
        }
    }

    /// `L = p'Q` of a packed Hessian.
    pub(super) fn cross(&mut self, hessian: &[Interval]) {
        multiply(hessian, &self.shift, &mut self.cross);
        self.cross.iter_mut().for_each(|entry| *entry = entry.scale(0.5));
    }

    /// Bound of what the rest `e` of the remainder does to the quadratic term: `z - gamma = y + e`, and
    /// `e'Q (2 (z - gamma) - e) + 2 L e` is missing from the terms in `y`.
    pub(super) fn lost(&self, hessian: &[Interval]) -> f64 {
        let mut sum = 0.0;
        if self.rest.iter().all(|&r| r == 0.0) {
            return sum;
        }
        let n = self.rest.len();
        let mut entries = hessian.iter();
        for j in 0..n {
            sum = add_up(sum, mul_up(2.0 * self.cross[j].mag(), self.rest[j]));
            for (k, entry) in (j..n).zip(&mut entries) {
                let half = mul_up(0.5, entry.mag());
                let reach = |k: usize| add_up(2.0 * self.steps[k].mag(), self.rest[k]);
                sum = add_up(sum, mul_up(half, mul_up(self.rest[j], reach(k))));
                if j < k {
                    sum = add_up(sum, mul_up(half, mul_up(self.rest[k], reach(j))));
                }
            }
        }
        sum
    }
}

/// `h x` of a packed symmetric matrix into `product`.
pub(super) fn multiply(packed: &[Interval], x: &[Interval], product: &mut Vec<Interval>) {
    let n = x.len();
    product.clear();
    product.resize(n, Interval::ZERO);
    let mut entries = packed.iter();
    for j in 0..n {
        for (k, entry) in (j..n).zip(&mut entries) {
            if *entry == Interval::ZERO {
                continue;
            }
            if x[k] != Interval::ZERO {
                product[j] += *entry * x[k];
            }
            if j < k && x[j] != Interval::ZERO {
                product[k] += *entry * x[j];
            }
        }
    }
}
