//! Exterior products `g_1 ^ .. ^ g_k` of columns in `R^n`: all `k x k` minors at once, without division.
//!
//! The `n`-fold product is the determinant (volumes), the `(n-1)`-fold one a normal of the columns (facets). Components are indexed by
//! row subsets `S` of size `k`; a column is appended by Laplace expansion along it,
//! `m_S(g_1 .. g_k) = sum_{i in S} (-1)^(k + pos_S(i)) g_k[i] m_{S - i}(g_1 .. g_{k-1})`, `pos_S` counting from 1. Subsets of
//! columns are visited in lexicographic order and share the products of their prefixes.

use core::ops::ControlFlow;

use scalars::Scalar;

use crate::SetError;

/// One term of the expansion: target component, source component, row, and whether it is subtracted.
#[derive(Debug, Clone, Copy)]
struct Term {
    target: usize,
    source: usize,
    row: usize,
    negative: bool,
}

/// Exterior products of up to `k` columns in `R^n`, over `f64` or intervals.
#[derive(Debug, Clone)]
pub(crate) struct Wedge<S> {
    n: usize,
    k: usize,
    /// `terms[d]`: from products of `d` columns to products of `d + 1`.
    terms: Vec<Vec<Term>>,
    /// `minors[d]`: the product of the first `d` columns of the current subset; `minors[0] = [1]`.
    minors: Vec<Vec<S>>,
    subset: Vec<usize>,
}

impl<S: Scalar> Wedge<S> {
    /// Tables for products of `k <= n` columns in `R^n`, for an `n` that [`subset_count`] admits.
    pub(crate) fn new(n: usize, k: usize) -> Self {
        let subsets: Vec<Vec<u32>> = (0..=k).map(|d| row_subsets(n, d)).collect();
        let terms = subsets.windows(2).map(|pair| expansion(&pair[0], &pair[1])).collect();
        let mut minors: Vec<Vec<S>> = subsets.iter().map(|level| vec![S::zero(); level.len()]).collect();
        minors[0][0] = S::one();
        Self { n, k, terms, minors, subset: Vec::with_capacity(k) }
    }

    /// Whether the tables are those of products of `k` columns in `R^n`.
    pub(crate) fn fits(&self, n: usize, k: usize) -> bool {
        (self.n, self.k) == (n, k)
    }

    /// The product of the given columns of a column-major array.
    pub(crate) fn of(&mut self, columns: &[f64], subset: &[usize]) -> &[S] {
        for (depth, &j) in subset.iter().enumerate() {
            self.extend(depth, &columns[j * self.n..(j + 1) * self.n]);
        }
        &self.minors[subset.len()]
    }

    /// Visits the product of every `k`-subset of the columns, with the subset (ascending).
    pub(crate) fn for_each(&mut self, columns: &[f64], visit: &mut impl FnMut(&[usize], &[S]) -> ControlFlow<()>) {
        self.subset.clear();
        let _ = self.descend(columns, 0, visit);
    }

    fn descend(
        &mut self,
        columns: &[f64],
        from: usize,
        visit: &mut impl FnMut(&[usize], &[S]) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let depth = self.subset.len();
        if depth == self.k {
            return visit(&self.subset, &self.minors[depth]);
        }
        // The last columns are needed for the rest of the subset.
        let end = (columns.len() / self.n + 1 + depth).saturating_sub(self.k);
        for j in from..end {
            self.extend(depth, &columns[j * self.n..(j + 1) * self.n]);
            self.subset.push(j);
            self.descend(columns, j + 1, visit)?;
            self.subset.pop();
        }
        ControlFlow::Continue(())
    }

    /// `minors[depth + 1]` from `minors[depth]` and one more column.
    fn extend(&mut self, depth: usize, column: &[f64]) {
        let (before, after) = self.minors.split_at_mut(depth + 1);
        let (source, target) = (&before[depth], &mut after[0]);
        target.fill(S::zero());
        for term in &self.terms[depth] {
            let product = source[term.source].scale(column[term.row]);
            if term.negative {
                target[term.target] -= product;
            } else {
                target[term.target] += product;
            }
        }
    }
}

/// Turns the `(n-1)`-fold product, whose component `t` leaves out row `n - 1 - t`, into the normal it stands for, in place:
/// `l_i = (-1)^i m_{all but i}`, so that `l'g = 0` for every factor `g`.
pub(crate) fn normal_from_minors<S: Scalar>(minors: &[S], normal: &mut [S]) {
    let n = minors.len();
    for (i, l) in normal.iter_mut().enumerate() {
        let minor = minors[n - 1 - i];
        *l = if i % 2 == 0 { minor } else { -minor };
    }
}

/// Most dimensions whose tables of minors are built: they grow as `n 2^n`.
pub(crate) const MAX_DIM: usize = 14;

/// Number of `k`-subsets of `m` columns in `R^n`, saturating; saturated where the dimension is too large for the tables.
pub(crate) fn subset_count(n: usize, m: usize, k: usize) -> u64 {
    if k > m {
        return 0;
    }
    if n > MAX_DIM {
        return u64::MAX;
    }
    let mut count: u128 = 1;
    for i in 0..k {
        count = count * (m - i) as u128 / (i + 1) as u128;
        if count > u64::MAX.into() {
            return u64::MAX;
        }
    }
    count as u64
}

/// Refuses more than `limit` of the `k`-subsets of `m` columns in `R^n`, and dimensions too large for the tables.
pub(crate) fn check_subsets(n: usize, m: usize, k: usize, limit: u64) -> Result<u64, SetError> {
    match subset_count(n, m, k) {
        subsets if subsets <= limit => Ok(subsets),
        _ if n > MAX_DIM => Err(SetError::TooManyDimensions { dim: n, limit: MAX_DIM }),
        subsets => Err(SetError::TooManySubsets { subsets, limit }),
    }
}

/// The `d`-subsets of `0..n` as bit masks, ascending.
fn row_subsets(n: usize, d: usize) -> Vec<u32> {
    (0..1_u32 << n).filter(|rows| rows.count_ones() as usize == d).collect()
}

/// The Laplace expansion along an appended column, between the row subsets of two sizes.
fn expansion(from: &[u32], to: &[u32]) -> Vec<Term> {
    let mut terms = Vec::new();
    for (target, &subset) in to.iter().enumerate() {
        let rows = (0..32).filter(|i| subset >> i & 1 == 1);
        let last = subset.count_ones() as usize - 1;
        for (position, row) in rows.enumerate() {
            let rest = subset & !(1 << row);
            if let Ok(source) = from.binary_search(&rest) {
                terms.push(Term { target, source, row, negative: (last - position) % 2 == 1 });
            }
        }
    }
    terms
}
