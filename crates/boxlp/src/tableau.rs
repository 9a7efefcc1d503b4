//! The exchange tableau: `x_B = T x_N`, dense, rows x variables.
//!
//! The variables are the structural ones `x_0 .. x_{n-1}`, boxed by `|x_j| <= 1`, and one *logical* a row, its activity
//! `s_i = A_i x`, boxed by the row's range. At first the logicals are basic, `s = A x`; an exchange swaps one basic with one
//! nonbasic variable. So ranged rows need no slack columns, an equality is a logical of zero width that never moves once
//! it is nonbasic, and a dependent row simply stays basic.
//!
//! All variables being boxed, *every* basis is dual feasible: put each nonbasic variable on the bound its reduced cost asks
//! for ([`Tableau::place`]). Rows are scaled by powers of two (exact) to 1-norms in [1/2, 1).

use crate::problem::{LANES, Problem, Range};

/// Smallest entry an exchange may divide by when a basis is rebuilt.
const REBUILD_PIVOT: f64 = 1e-9;

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

/// What a rebuild still has to do with a variable: exchange it (structural: in, logical: out), or nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mark {
    Basic,
    Lower,
    Upper,
}

/// What belongs to the basic variables, one entry a row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    /// The basic variable: `j < n` structural, `n + i` the logical of row `i`.
    pub(crate) variable: Vec<u32>,
    pub(crate) value: Vec<f64>,
    lower: Vec<f64>,
    upper: Vec<f64>,
}

/// What belongs to the nonbasic variables, one entry a column; padded by fixed zeros.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns {
    pub(crate) variable: Vec<u32>,
    pub(crate) value: Vec<f64>,
    pub(crate) lower: Vec<f64>,
    pub(crate) upper: Vec<f64>,
    /// 1 at the upper bound, -1 at the lower one, 0 if the bounds coincide.
    pub(crate) side: Vec<f64>,
    /// Reduced costs `d`: the objective is `d'x_N`.
    pub(crate) cost: Vec<f64>,
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
    /// The tableau of `problem` on its logical basis.
    pub(crate) fn build(&mut self, problem: &Problem) {
        let (n, m) = (problem.variables(), problem.rows());
        self.variables = n;
        self.stride = problem.stride();
        self.margin = 0.0;
        self.matrix.clear();
        self.rows.clear();
        self.columns.reset(n, self.stride);
        self.pivot_row.clear();
        self.pivot_row.resize(self.stride, 0.0);
        self.fill(problem, m);
    }

    fn fill(&mut self, problem: &Problem, rows: usize) {
        self.age = 0;
        for i in 0..rows {
            let range = &problem.ranges()[i];
            self.matrix
                .extend(problem.padded_row(i).iter().map(|a| a * range.scale));
            let (lower, upper) = scaled_range(range, self.margin);
            self.rows.push((self.variables + i) as u32, lower, upper);
        }
    }

    /// The tableau of the same basis computed afresh from the data: ends the drift of many exchanges.
    ///
    /// The structural variables of the basis enter again by complete pivoting; one that is dependent on the others (to
    /// working accuracy) stays out: any basis will do.
    pub(crate) fn rebuild(&mut self, problem: &Problem) {
        let n = self.variables;
        let mut marks = core::mem::take(&mut self.marks);
        marks.clear();
        marks.resize(n, Mark::Basic);
        marks.resize(n + self.rows.variable.len(), Mark::Lower);
        for (&v, &side) in self.columns.variable.iter().zip(&self.columns.side) {
            marks[v as usize] = match v as usize >= n {
                true => Mark::Basic,
                false if side < 0.0 => Mark::Lower,
                false => Mark::Upper,
            };
        }
        let rows = problem.rows();
        let margin = self.margin;
        self.build(problem);
        self.set_bounds(problem, margin);
        for j in 0..n {
            if marks[j] == Mark::Lower {
                self.columns.flip(j);
            }
        }
        loop {
            let mut best = (REBUILD_PIVOT, 0, 0);
            for r in (0..rows).filter(|&r| marks[n + r] == Mark::Basic) {
                let row = self.row(r);
                for q in (0..n).filter(|&q| marks[q] == Mark::Basic) {
                    if row[q].abs() > best.0 {
                        best = (row[q].abs(), r, q);
                    }
                }
            }
            let (pivot, r, q) = best;
            if pivot <= REBUILD_PIVOT {
                break;
            }
            self.exchange(r, q, 0.0, &[]);
            marks[n + r] = Mark::Upper;
            marks[q] = Mark::Upper;
        }
        self.age = 0;
        self.marks = marks;
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

    /// Appends the last row of `problem`: its logical becomes basic.
    pub(crate) fn append_row(&mut self, problem: &Problem) {
        let (n, stride) = (self.variables, self.stride);
        let i = problem.rows() - 1;
        let range = &problem.ranges()[i];
        let source = problem.row(i);
        let start = self.matrix.len();
        self.matrix.resize(start + stride, 0.0);
        let (known, new) = self.matrix.split_at_mut(start);
        for j in 0..n {
            let v = self.columns.variable[j] as usize;
            new[j] = if v < n { source[v] * range.scale } else { 0.0 };
        }
        for (r, row) in known.chunks_exact(stride).enumerate() {
            let v = self.rows.variable[r] as usize;
            if v < n {
                add_multiple(source[v] * range.scale, row, new);
            }
        }
        let (lower, upper) = scaled_range(range, self.margin);
        self.rows.push((n + i) as u32, lower, upper);
    }

    /// Forgets the logicals for whose row `keep` says `false`; the others are renumbered in order.
    ///
    /// Returns `false`, with the tableau in need of a build, if a nonbasic logical cannot be exchanged into the basis.
    pub(crate) fn retain_rows(&mut self, keep: &[bool]) -> bool {
        let n = self.variables;
        for j in 0..n {
            let v = self.columns.variable[j] as usize;
            if v >= n && !keep[v - n] {
                let mut best = (REBUILD_PIVOT, usize::MAX);
                for r in 0..self.rows.variable.len() {
                    let a = self.row(r)[j].abs();
                    let b = self.rows.variable[r] as usize;
                    if a > best.0 && (b < n || keep[b - n]) {
                        best = (a, r);
                    }
                }
                if best.1 == usize::MAX {
                    return false;
                }
                self.exchange(best.1, j, 0.0, &[]);
            }
        }
        self.numbers.clear();
        let mut next = n as u32;
        for &kept in keep {
            self.numbers.push(next);
            next += u32::from(kept);
        }
        let mut kept = 0;
        for r in 0..self.rows.variable.len() {
            let v = self.rows.variable[r] as usize;
            if v < n || keep[v - n] {
                self.matrix
                    .copy_within(r * self.stride..(r + 1) * self.stride, kept * self.stride);
                self.rows.move_to(r, kept);
                kept += 1;
            }
        }
        self.rows.truncate(kept);
        self.matrix.truncate(kept * self.stride);
        for v in self
            .rows
            .variable
            .iter_mut()
            .chain(&mut self.columns.variable)
        {
            if *v as usize >= n {
                *v = self.numbers[*v as usize - n];
            }
        }
        true
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

    /// Largest difference between a row's activity at `point` and the value of its logical.
    pub(crate) fn drift(&self, problem: &Problem, point: &[f64]) -> f64 {
        let n = self.variables;
        let basic = self.rows.variable.iter().zip(&self.rows.value);
        let nonbasic = self.columns.variable.iter().zip(&self.columns.value);
        let mut drift = 0.0_f64;
        for (&v, &value) in basic.chain(nonbasic) {
            if let Some(i) = (v as usize).checked_sub(n) {
                let activity: f64 = problem.row(i).iter().zip(point).map(|(a, x)| a * x).sum();
                drift = drift.max((activity * problem.ranges()[i].scale - value).abs());
            }
        }
        drift
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

    /// One dual simplex step: `flips`, then the violated variable goes to its bound and the variable of column `q` enters.
    pub(crate) fn step(&mut self, violation: Violation, q: usize, flips: &[Flip]) {
        let r = violation.row;
        let mut value = self.rows.value[r];
        for &(j, change) in flips {
            value += self.matrix[r * self.stride + j as usize] * change;
            self.columns.flip(j as usize);
        }
        let target = if violation.sign > 0.0 {
            self.rows.upper[r]
        } else {
            self.rows.lower[r]
        };
        let change = (target - value) / self.matrix[r * self.stride + q];
        let entering = self.columns.value[q] + change;
        self.columns.value[q] = target;
        self.columns.side[q] = violation.sign;
        self.exchange(r, q, change, flips);
        self.rows.value[r] = entering;
    }

    /// Exchanges the basic variable of row `r` with the nonbasic one of column `q`, whose value changes by `change`.
    fn exchange(&mut self, r: usize, q: usize, change: f64, flips: &[Flip]) {
        let stride = self.stride;
        let (before, rest) = self.matrix.split_at_mut(r * stride);
        let (row, after) = rest.split_at_mut(stride);
        let inverse = 1.0 / row[q];
        let pivot_row = &mut self.pivot_row[..stride];
        pivot_row.copy_from_slice(row);
        pivot_row[q] = 0.0;
        let (values_before, values_after) = self.rows.value.split_at_mut(r);
        let elimination = Elimination {
            pivot_row,
            inverse,
            column: q,
            change,
            flips,
        };
        elimination.run(before, values_before);
        elimination.run(after, &mut values_after[1..]);
        let quotient = self.columns.cost[q] * inverse;
        add_multiple(-quotient, pivot_row, &mut self.columns.cost);
        self.columns.cost[q] = quotient;
        for (entry, p) in row.iter_mut().zip(&*pivot_row) {
            *entry = -inverse * p;
        }
        row[q] = inverse;
        core::mem::swap(&mut self.rows.variable[r], &mut self.columns.variable[q]);
        core::mem::swap(&mut self.rows.lower[r], &mut self.columns.lower[q]);
        core::mem::swap(&mut self.rows.upper[r], &mut self.columns.upper[q]);
        if self.columns.lower[q] == self.columns.upper[q] {
            self.columns.side[q] = 0.0;
        }
        self.age += 1;
    }
}

impl Rows {
    fn clear(&mut self) {
        self.truncate(0);
    }

    fn truncate(&mut self, rows: usize) {
        self.variable.truncate(rows);
        self.value.truncate(rows);
        self.lower.truncate(rows);
        self.upper.truncate(rows);
    }

    fn push(&mut self, variable: u32, lower: f64, upper: f64) {
        self.variable.push(variable);
        self.value.push(0.0);
        self.lower.push(lower);
        self.upper.push(upper);
    }

    fn move_to(&mut self, from: usize, to: usize) {
        self.variable[to] = self.variable[from];
        self.value[to] = self.value[from];
        self.lower[to] = self.lower[from];
        self.upper[to] = self.upper[from];
    }
}

impl Columns {
    /// The structural variables at their upper bounds.
    fn reset(&mut self, variables: usize, stride: usize) {
        self.variable.clear();
        self.variable.extend(0..variables as u32);
        for (array, value) in [
            (&mut self.value, 1.0),
            (&mut self.lower, -1.0),
            (&mut self.upper, 1.0),
            (&mut self.side, 1.0),
            (&mut self.cost, 0.0),
        ] {
            array.clear();
            array.resize(variables, value);
            array.resize(stride, 0.0);
        }
    }

    fn set_bounds(&mut self, j: usize, lower: f64, upper: f64) {
        self.lower[j] = lower;
        self.upper[j] = upper;
        if lower == upper {
            self.side[j] = 0.0;
        } else if self.side[j] == 0.0 {
            self.side[j] = 1.0;
        }
        self.value[j] = if self.side[j] < 0.0 { lower } else { upper };
    }

    fn flip(&mut self, j: usize) {
        self.side[j] = -self.side[j];
        self.value[j] = if self.side[j] < 0.0 {
            self.lower[j]
        } else {
            self.upper[j]
        };
    }

    fn place(&mut self) {
        let Self {
            value,
            lower,
            upper,
            side,
            cost,
            ..
        } = self;
        for ((((x, s), d), lo), hi) in value.iter_mut().zip(side).zip(cost).zip(lower).zip(upper) {
            let wish = if *d < 0.0 || (*d == 0.0 && *s < 0.0) {
                -1.0
            } else {
                1.0
            };
            *s = if lo < hi { wish } else { 0.0 };
            *x = if wish < 0.0 { *lo } else { *hi };
        }
    }
}

/// The elimination of the pivot column from the other rows, and the move of their basic variables.
struct Elimination<'a> {
    /// The pivot row, with 0 in the pivot column.
    pivot_row: &'a [f64],
    /// Reciprocal of the pivot.
    inverse: f64,
    column: usize,
    change: f64,
    flips: &'a [Flip],
}

impl Elimination<'_> {
    /// Dispatches on the padded number of columns: short rows are worth a loop of known length.
    fn run(&self, rows: &mut [f64], values: &mut [f64]) {
        match self.pivot_row.len() {
            4 => self.run_sized::<4>(rows, values),
            8 => self.run_sized::<8>(rows, values),
            12 => self.run_sized::<12>(rows, values),
            16 => self.run_sized::<16>(rows, values),
            stride => {
                for (row, value) in rows.chunks_exact_mut(stride).zip(values) {
                    self.update(row, self.pivot_row, value);
                }
            }
        }
    }

    fn run_sized<const S: usize>(&self, rows: &mut [f64], values: &mut [f64]) {
        if let Some(pivot_row) = self.pivot_row.first_chunk::<S>() {
            let pivot_row = *pivot_row;
            for (row, value) in rows.as_chunks_mut::<S>().0.iter_mut().zip(values) {
                self.update(row, &pivot_row, value);
            }
        }
    }

    #[inline(always)]
    fn update(&self, row: &mut [f64], pivot_row: &[f64], value: &mut f64) {
        for &(j, change) in self.flips {
            *value += row[j as usize] * change;
        }
        let entry = row[self.column];
        if entry != 0.0 {
            *value += entry * self.change;
            let quotient = entry * self.inverse;
            add_multiple(-quotient, pivot_row, row);
            row[self.column] = quotient;
        }
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
