//! The exchange tableau: `x_B = T x_N`, dense, rows x variables.
//!
//! The variables are the structural ones `x_0 .. x_{n-1}`, boxed by `|x_j| <= 1`, and one *logical* a row, its activity
//! `s_i = A_i x`, boxed by the row's range. At first the logicals are basic, `s = A x`; an exchange swaps one basic with one
//! nonbasic variable. So ranged rows need no slack columns, an equality is a logical of zero width that never moves once
//! it is nonbasic, and a dependent row simply stays basic.
//!
//! All variables being boxed, *every* basis is dual feasible: put each nonbasic variable on the bound its reduced cost asks
//! for ([`Tableau::place`]). Rows are scaled by powers of two (exact) to 1-norms in [1/2, 1).

use self::basis::{Columns, Rows};
use self::rebuild::Mark;
use crate::problem::{LANES, Problem, Range};

pub(crate) mod basis;
mod edit;
mod exchange;
mod rebuild;

/// Tableau, basis, and the current vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tableau {
    variables: usize,
    stride: usize,
    /// `T`, row by row, each padded with zeros to `stride`.
    matrix: Vec<f64>,
    pub(crate) rows: Rows,
    pub(crate) columns: Columns,
    /// Copy of the pivot row during an exchange.
    pivot_row: Vec<f64>,
    /// Scratch of [`Tableau::rebuild`].
    marks: Vec<Mark>,
    /// Scratch of [`Tableau::retain_rows`]: the new number of each logical.
    numbers: Vec<u32>,
    /// How far the bounds are moved inward, see [`Tableau::set_bounds`].
    margin: f64,
    /// Exchanges since the tableau was built from the data.
    pub(crate) age: usize,
}

/// A basic variable outside its bounds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Violation {
    pub(crate) row: usize,
    /// 1 above the upper bound, -1 below the lower one.
    pub(crate) sign: f64,
    pub(crate) amount: f64,
}

/// A nonbasic variable moved to its other bound: column and change of value.
pub(crate) type Flip = (u32, f64);

impl Tableau {
    /// The tableau of `problem` on its logical basis, with room for all that a solve needs.
    pub(crate) fn build(&mut self, problem: &Problem) {
        self.marks
            .resize(problem.variables() + problem.rows(), Mark::Settled);
        self.load(problem);
    }

    fn load(&mut self, problem: &Problem) {
        self.variables = problem.variables();
        self.stride = problem.stride();
        self.margin = 0.0;
        self.age = 0;
        self.pivot_row.resize(self.stride, 0.0);
        self.columns.reset(self.variables, self.stride);
        self.rows.truncate(0);
        self.matrix.clear();
        for (i, range) in problem.ranges().iter().enumerate() {
            self.matrix
                .extend(problem.padded_row(i).iter().map(|a| a * range.scale));
            let (lower, upper) = scaled_range(range, self.margin);
            self.rows.push((self.variables + i) as u32, lower, upper);
        }
    }

    /// Sets the bounds of all variables from the data, moved inward by `margin` (by a quarter of the width at most).
    pub(crate) fn set_bounds(&mut self, problem: &Problem, margin: f64) {
        self.margin = margin;
        let n = self.variables;
        let bounds = |v: u32| match (v as usize).checked_sub(n) {
            None => (margin - 1.0, 1.0 - margin),
            Some(i) => scaled_range(&problem.ranges()[i], margin),
        };
        for (r, &v) in self.rows.variable.iter().enumerate() {
            (self.rows.lower[r], self.rows.upper[r]) = bounds(v);
        }
        for j in 0..n {
            let (lower, upper) = bounds(self.columns.variable[j]);
            self.columns.set_bounds(j, lower, upper);
        }
    }

    pub(crate) fn row(&self, r: usize) -> &[f64] {
        &self.matrix[r * self.stride..][..self.stride]
    }

    /// Reduced costs of the objective `c'x` on the current basis.
    pub(crate) fn price(&mut self, objective: &[f64]) {
        let n = self.variables;
        for (cost, &v) in self.columns.cost.iter_mut().zip(&self.columns.variable) {
            *cost = objective.get(v as usize).copied().unwrap_or(0.0);
        }
        for (&v, row) in self
            .rows
            .variable
            .iter()
            .zip(self.matrix.chunks_exact(self.stride))
        {
            if (v as usize) < n {
                let c = objective[v as usize];
                if c != 0.0 {
                    add_multiple(c, row, &mut self.columns.cost);
                }
            }
        }
    }

    /// Puts every nonbasic variable on the bound its reduced cost asks for (a zero cost leaves it where it is) and computes
    /// the basic ones.
    pub(crate) fn place(&mut self) {
        self.columns.place();
        for (value, row) in self
            .rows
            .value
            .iter_mut()
            .zip(self.matrix.chunks_exact(self.stride))
        {
            *value = dot(row, &self.columns.value);
        }
    }

    /// The basic variable furthest outside its bounds, if that is more than `tolerance`.
    pub(crate) fn worst(&self, tolerance: f64) -> Option<Violation> {
        let Rows {
            value,
            lower,
            upper,
            ..
        } = &self.rows;
        let mut row = usize::MAX;
        let mut amount = tolerance;
        for (r, ((x, lo), hi)) in value.iter().zip(lower).zip(upper).enumerate() {
            let (above, below) = (x - hi, lo - x);
            let miss = if above > below { above } else { below };
            if miss > amount {
                amount = miss;
                row = r;
            }
        }
        let sign = if value.get(row)? > &upper[row] {
            1.0
        } else {
            -1.0
        };
        Some(Violation { row, sign, amount })
    }
}

/// Range of a scaled logical, moved inward.
fn scaled_range(range: &Range, margin: f64) -> (f64, f64) {
    let (lower, upper) = (range.lo * range.scale, range.hi * range.scale);
    let inward = margin.min(0.25 * (upper - lower));
    (lower + inward, upper - inward)
}

/// `target += factor * row`.
fn add_multiple(factor: f64, row: &[f64], target: &mut [f64]) {
    for (t, a) in target.iter_mut().zip(row) {
        *t += factor * a;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a
        .as_chunks::<LANES>()
        .0
        .iter()
        .zip(b.as_chunks::<LANES>().0)
    {
        for l in 0..LANES {
            sums[l] += a[l] * b[l];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
