//! The constraints `a'y >= 0` of a cone: floats for the filter, integers for the exact predicates.

use std::cell::OnceCell;

use num_bigint::BigInt;

use super::exact::{decompose, integer_row, ray_of, scale_by_power};
use super::incidence::{BitSets, iter};

/// Integers `A` with the shift `p` that makes `A 2^-p` the scaled row (or ray).
pub(super) struct IntegerRow {
    pub(super) entries: Box<[BigInt]>,
    pub(super) shift: i64,
}

/// Rows of a homogeneous system `a_i'y >= 0`, scaled by powers of two: each column, then each row, to a largest entry in `[1, 2)`.
///
/// In the scaled coordinates `y_k` stands for `y_k 2^-c_k`, `c` the column exponents. Scaling is exact but for underflow (below `1e-307` of the
/// largest entry), which the filters' error bounds count.
pub(super) struct Rows<'a> {
    dim: usize,
    source: Vec<f64>,
    scaled: Vec<f64>,
    norms: Vec<f64>,
    underflow: bool,
    column_exponents: Vec<i32>,
    row_exponents: Vec<i32>,
    integers: Vec<OnceCell<IntegerRow>>,
    facets: Option<&'a FacetRows>,
}

/// Rows that are the facets of a hull: each vanishes at some points. Their floats are not needed and stay zero.
pub(super) struct FacetRows {
    /// The points as rows, in the coordinates that the rays of the facets' system have.
    pub(super) points: Rows<'static>,
    /// The points at each facet, as indices into `columns`.
    pub(super) incidence: BitSets,
    /// The rows of `points` that the incidence speaks of.
    pub(super) columns: Vec<usize>,
}

impl FacetRows {
    /// Facet `i` in integers.
    fn integers(&self, i: usize) -> IntegerRow {
        let point = |k: usize| &*self.points.integers(self.columns[k]).entries;
        let tight = iter(self.incidence.get(i)).map(point);
        let loose = (0..self.columns.len()).filter(|&k| !self.incidence.contains(i, k)).map(point);
        // The points of a facet determine it; a row of zeros would constrain nothing.
        let entries =
            ray_of(self.points.dim(), tight, loose).unwrap_or_else(|| vec![BigInt::ZERO; self.points.dim()].into());
        IntegerRow { entries, shift: 0 }
    }
}

/// The exponent `k` with `2^k <= |x| < 2^(k+1)`; `None` for zero.
fn binary_exponent(x: f64) -> Option<i32> {
    let (mantissa, exponent) = decompose(x);
    (mantissa != 0).then(|| exponent + 63 - mantissa.unsigned_abs().leading_zeros() as i32)
}

impl<'a> Rows<'a> {
    /// Rows from finite entries, row after row.
    pub(super) fn new(dim: usize, source: Vec<f64>) -> Self {
        let mut exponents = vec![i32::MIN; dim];
        for row in source.chunks_exact(dim) {
            for (largest, &x) in exponents.iter_mut().zip(row) {
                *largest = (*largest).max(binary_exponent(x).unwrap_or(i32::MIN));
            }
        }
        // A power of two that brings the largest entry of the column to [1, 2); columns of zeros stay.
        for exponent in &mut exponents {
            *exponent = if *exponent == i32::MIN { 0 } else { -*exponent };
        }
        Self::with_column_exponents(exponents, source)
    }

    /// Rows in given coordinates: column `k` is scaled by `2^(c_k)`.
    pub(super) fn with_column_exponents(column_exponents: Vec<i32>, source: Vec<f64>) -> Self {
        let dim = column_exponents.len();
        let count = source.len() / dim;
        let mut rows = Self {
            dim,
            scaled: Vec::with_capacity(source.len()),
            norms: Vec::with_capacity(count),
            underflow: false,
            row_exponents: Vec::with_capacity(count),
            integers: (0..count).map(|_| OnceCell::new()).collect(),
            column_exponents,
            source,
            facets: None,
        };
        rows.scale();
        rows
    }

    /// The facets of a hull as the first rows, and half-spaces `b - a'x >= 0` as the others.
    pub(super) fn of_facets(facets: &'a FacetRows, half_spaces: &[f64]) -> Self {
        let points = &facets.points;
        let exponents = points.column_exponents.iter().map(|c| -c).collect();
        let mut source = vec![0.0; facets.incidence.len() * points.dim()];
        source.extend_from_slice(half_spaces);
        let mut rows = Self::with_column_exponents(exponents, source);
        rows.facets = Some(facets);
        rows
    }

    fn scale(&mut self) {
        for row in self.source.chunks_exact(self.dim) {
            let exponents =
                row.iter().zip(&self.column_exponents).filter_map(|(&x, c)| binary_exponent(x).map(|k| k + c));
            let shift = -exponents.max().unwrap_or(0);
            let mut norm = 0.0;
            for (&x, &c) in row.iter().zip(&self.column_exponents) {
                let value = scale_by_power(x, i64::from(c + shift));
                // What is subnormal after scaling may have been rounded.
                self.underflow |= x != 0.0 && value.abs() < f64::MIN_POSITIVE;
                norm += value.abs();
                self.scaled.push(value);
            }
            self.row_exponents.push(shift);
            self.norms.push(norm * (1.0 + 1e-12));
        }
    }

    /// Number of coordinates of `y`.
    #[inline]
    pub(super) fn dim(&self) -> usize {
        self.dim
    }

    /// Number of rows.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.norms.len()
    }

    /// The scaled floats of row `i`.
    #[inline]
    pub(super) fn row(&self, i: usize) -> &[f64] {
        &self.scaled[i * self.dim..(i + 1) * self.dim]
    }

    /// All scaled floats, row after row.
    pub(super) fn scaled(&self) -> &[f64] {
        &self.scaled
    }

    /// Upper bound of the sum of magnitudes of row `i`; zero for a row of zeros only.
    #[inline]
    pub(super) fn norm(&self, i: usize) -> f64 {
        self.norms[i]
    }

    /// Whether some scaled entry may differ from its exact value by underflow.
    #[inline]
    pub(super) fn has_underflow(&self) -> bool {
        self.underflow
    }

    /// `c_k`: scaled `y_k` is `y_k 2^-c_k`.
    pub(super) fn column_exponent(&self, k: usize) -> i32 {
        self.column_exponents[k]
    }

    /// Row `i` in integers.
    pub(super) fn integers(&self, i: usize) -> &IntegerRow {
        self.integers[i].get_or_init(|| {
            if let Some(facets) = self.facets.filter(|facets| i < facets.incidence.len()) {
                return facets.integers(i);
            }
            let (entries, shift) = integer_row(&self.source[i * self.dim..(i + 1) * self.dim], &self.column_exponents);
            IntegerRow { entries, shift: i64::from(shift) - i64::from(self.row_exponents[i]) }
        })
    }

    /// The rows with the chosen columns only.
    pub(super) fn select_columns(&self, columns: &[usize]) -> Self {
        let source = self.source.chunks_exact(self.dim).flat_map(|row| columns.iter().map(|&k| row[k])).collect();
        Self::new(columns.len(), source)
    }
}
