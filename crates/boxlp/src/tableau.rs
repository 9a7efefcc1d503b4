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
use crate::real::Real;

pub(crate) mod basis;
mod edit;
mod exchange;
mod rebuild;
mod refine;

/// With more rows than this, fewer exchanges are worth the care of choosing the violated row.
const MANY: usize = 40;

/// Tableau, basis, and the current vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tableau<T> {
    variables: usize,
    stride: usize,
    /// `T`, row by row, each padded with zeros to `stride`.
    matrix: Vec<T>,
    pub(crate) rows: Rows<T>,
    pub(crate) columns: Columns<T>,
    /// Devex weights, one a row: estimates of `1 + |T_r|^2` over the columns since a run began. Empty if there are few rows.
    weights: Vec<T>,
    /// Copy of the pivot row during an exchange.
    pivot_row: Vec<T>,
    /// Scratch of [`Tableau::rebuild`].
    marks: Vec<Mark>,
    /// Scratch of [`Tableau::retain_rows`]: the new number of each logical.
    numbers: Vec<u32>,
    /// How far the bounds are moved inward, see [`Tableau::set_bounds`].
    margin: f64,
    /// Exchanges since the tableau was built from the data.
    pub(crate) age: usize,
    /// One of these exchanges divided by a small number, or the tableau came from one with more digits.
    pub(crate) delicate: bool,
}

/// A basic variable outside its bounds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Violation<T> {
    pub(crate) row: usize,
    /// 1 above the upper bound, -1 below the lower one.
    pub(crate) sign: T,
    pub(crate) amount: T,
}

/// A nonbasic variable moved to its other bound: column and change of value.
pub(crate) type Flip<T> = (u32, T);

impl<T: Real> Tableau<T> {
    /// The tableau of `problem` on its logical basis, with room for all that a solve needs.
    pub(crate) fn build(&mut self, problem: &Problem) {
        self.marks.resize(problem.variables() + problem.rows(), Mark::Settled);
        self.load(problem);
    }

    fn load(&mut self, problem: &Problem) {
        self.variables = problem.variables();
        self.stride = problem.stride();
        self.margin = 0.0;
        self.age = 0;
        self.delicate = false;
        self.pivot_row.resize(self.stride, T::ZERO);
        self.columns.reset(self.variables, self.stride);
        self.rows.truncate(0);
        self.matrix.clear();
        for (i, range) in problem.ranges().iter().enumerate() {
            self.matrix.extend(problem.padded_row(i).iter().map(|a| T::from(a * range.scale)));
            let (lower, upper) = scaled_range(range, self.margin);
            self.rows.push((self.variables + i) as u32, lower, upper);
        }
    }

    /// Becomes `other`, a tableau of the same problem, rounded.
    pub(crate) fn round(&mut self, other: &Tableau<impl Real>) {
        for (target, source) in [
            (&mut self.matrix, &other.matrix),
            (&mut self.rows.value, &other.rows.value),
            (&mut self.rows.lower, &other.rows.lower),
            (&mut self.rows.upper, &other.rows.upper),
            (&mut self.columns.value, &other.columns.value),
            (&mut self.columns.lower, &other.columns.lower),
            (&mut self.columns.upper, &other.columns.upper),
            (&mut self.columns.side, &other.columns.side),
            (&mut self.columns.cost, &other.columns.cost),
        ] {
            target.clear();
            target.extend(source.iter().map(|x| T::from(x.to_f64())));
        }
        self.rows.variable.clone_from(&other.rows.variable);
        self.columns.variable.clone_from(&other.columns.variable);
        self.age = 0;
        self.delicate = true;
    }

    /// Sets the bounds of all variables from the data, moved inward by `margin` (by a quarter of the width at most).
    pub(crate) fn set_bounds(&mut self, problem: &Problem, margin: f64) {
        self.margin = margin;
        let n = self.variables;
        let bounds = |v: u32| match (v as usize).checked_sub(n) {
            None => (T::from(margin - 1.0), T::from(1.0 - margin)),
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

    pub(crate) fn row(&self, r: usize) -> &[T] {
        &self.matrix[r * self.stride..][..self.stride]
    }

    /// Reduced costs of the objective `c'x` on the current basis.
    pub(crate) fn price(&mut self, objective: &[f64]) {
        let n = self.variables;
        for (cost, &v) in self.columns.cost.iter_mut().zip(&self.columns.variable) {
            *cost = T::from(objective.get(v as usize).copied().unwrap_or(0.0));
        }
        for (&v, row) in self.rows.variable.iter().zip(self.matrix.chunks_exact(self.stride)) {
            if (v as usize) < n {
                let c = objective[v as usize];
                if c != 0.0 {
                    add_multiple(T::from(c), row, &mut self.columns.cost);
                }
            }
        }
    }

    /// Puts every nonbasic variable on the bound its reduced cost asks for (a zero cost leaves it where it is) and computes
    /// the basic ones.
    pub(crate) fn place(&mut self) {
        self.weights.clear();
        if self.rows.variable.len() > MANY && self.stride > MANY {
            self.weights.resize(self.rows.variable.len(), T::ONE);
        }
        self.columns.place();
        for (value, row) in self.rows.value.iter_mut().zip(self.matrix.chunks_exact(self.stride)) {
            *value = dot(row, &self.columns.value);
        }
    }

    /// Moves the reduced costs away from zero, each by another amount: among costs that are zero but for rounding the method would cycle.
    pub(crate) fn shift_costs(&mut self) {
        let Columns { cost, side, .. } = &mut self.columns;
        let largest = cost.iter().fold(T::ZERO, |most, d| if d.abs() > most { d.abs() } else { most });
        let largest = if largest > T::ZERO { largest } else { T::ONE };
        let mut share = 0.0_f64;
        for (cost, side) in cost.iter_mut().zip(side) {
            // Multiples of the golden ratio modulo 1: no two are close.
            share = (share + 0.618_033_988_749_895).fract();
            *cost += *side * largest * T::from(T::SHIFT * (1.0 + share));
        }
    }

    /// A basic variable more than `tolerance` outside its bounds, if there is one: the furthest, or the
    /// one whose bound is furthest from the vertex in terms of the columns, by the estimate of the weights.
    pub(crate) fn worst(&self, tolerance: T) -> Option<Violation<T>> {
        if !self.weights.is_empty() {
            return self.steepest(tolerance);
        }
        let Rows { value, lower, upper, .. } = &self.rows;
        let mut row = usize::MAX;
        let mut amount = tolerance;
        for (r, ((x, lo), hi)) in value.iter().zip(lower).zip(upper).enumerate() {
            let (above, below) = (*x - *hi, *lo - *x);
            let miss = if above > below { above } else { below };
            if miss > amount {
                amount = miss;
                row = r;
            }
        }
        let sign = if value.get(row)? > &upper[row] { T::ONE } else { -T::ONE };
        Some(Violation { row, sign, amount })
    }

    fn steepest(&self, tolerance: T) -> Option<Violation<T>> {
        let Rows { value, lower, upper, .. } = &self.rows;
        let mut best: Option<Violation<T>> = None;
        let mut steepness = T::ZERO;
        for (row, (((x, lo), hi), weight)) in value.iter().zip(lower).zip(upper).zip(&self.weights).enumerate() {
            let (above, below) = (*x - *hi, *lo - *x);
            let (amount, sign) = if above > below { (above, T::ONE) } else { (below, -T::ONE) };
            if amount > tolerance {
                let square = (amount * amount).over(*weight);
                if best.is_none() || square > steepness {
                    steepness = square;
                    best = Some(Violation { row, sign, amount });
                }
            }
        }
        best
    }
}

/// Range of a scaled logical, moved inward.
fn scaled_range<T: Real>(range: &Range, margin: f64) -> (T, T) {
    let (lower, upper) = (range.lo * range.scale, range.hi * range.scale);
    let inward = margin.min(0.25 * (upper - lower));
    (T::from(lower + inward), T::from(upper - inward))
}

/// `target += factor * row`.
///
/// By index: zipped iterators are generic functions of their own, which are calls where units of code are compiled apart.
#[inline(always)]
fn add_multiple<T: Real>(factor: T, row: &[T], target: &mut [T]) {
    let len = target.len().min(row.len());
    let (row, target) = (&row[..len], &mut target[..len]);
    for k in 0..len {
        target[k] += factor * row[k];
    }
}

fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    let mut sums = [T::ZERO; LANES];
    for (a, b) in a.as_chunks::<LANES>().0.iter().zip(b.as_chunks::<LANES>().0) {
        for l in 0..LANES {
            sums[l] += a[l] * b[l];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
