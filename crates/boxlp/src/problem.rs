//! The data of a problem: `A x in [lower, upper]` over the box `|x_j| <= 1`.

use crate::LpError;
use crate::rounding::norm1_up;

/// Largest number of variables or rows for which the error bounds of [`crate::rounding`] are derived.
const MAX_SIZE: usize = 1 << 24;

/// Rows are stored in multiples of this many numbers, so that inner loops have no remainder.
pub(crate) const LANES: usize = 4;

/// The feasible set `{ x : lower_i <= A_i x <= upper_i, |x_j| <= 1 }`.
///
/// `A: m x n`, row by row; a range may be one-sided (an infinite end), an equality has `lower == upper`. No row at all
/// is fine: the set is the box.
///
/// A row's activity `A_i x` lies in `[-|A_i|_1, |A_i|_1]` over the box, so infinite ends are clipped there (upward, hence
/// without loss): all ranges the solver sees are finite.
///
/// ```
/// use boxlp::Problem;
/// let mut problem = Problem::new(2)?;
/// problem.push_row(&[1.0, 1.0], 0.5, 0.5)?;
/// problem.push_row(&[1.0, -1.0], f64::NEG_INFINITY, 0.25)?;
/// assert_eq!((problem.variables(), problem.rows()), (2, 2));
/// # Ok::<(), boxlp::LpError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Problem {
    variables: usize,
    stride: usize,
    matrix: Vec<f64>,
    ranges: Vec<Range>,
}

/// One row's range and what follows from its entries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    /// As given, possibly infinite.
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    /// `[lower, upper]` clipped to the activities the box allows: always finite.
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Upper bound of `|A_i|_1`.
    pub(crate) norm: f64,
    /// Power of two that brings `norm` near 1; the tableau works on scaled rows.
    pub(crate) scale: f64,
}

impl Problem {
    /// The box `|x_j| <= 1` of `variables` dimensions, without rows.
    ///
    /// # Errors
    /// [`LpError::TooLarge`] above 2^24 variables.
    pub fn new(variables: usize) -> Result<Self, LpError> {
        let mut problem = Self { variables: 0, stride: LANES, matrix: Vec::new(), ranges: Vec::new() };
        problem.reset(variables)?;
        Ok(problem)
    }

    /// The problem with the matrix given column by column (`columns[j * m + i] = A_ij`) and one range a row.
    ///
    /// ```
    /// use boxlp::Problem;
    /// let problem = Problem::from_columns(3, &[1.0, 0.0, 1.0, 1.0, 0.0, 2.0], &[0.0, -1.0], &[0.0, 1.0])?;
    /// assert_eq!(problem.row(1), &[0.0, 1.0, 2.0]);
    /// # Ok::<(), boxlp::LpError>(())
    /// ```
    ///
    /// # Errors
    /// [`LpError::Length`], [`LpError::Entry`], [`LpError::Range`], [`LpError::RowOverflow`] or [`LpError::TooLarge`].
    pub fn from_columns(variables: usize, columns: &[f64], lower: &[f64], upper: &[f64]) -> Result<Self, LpError> {
        let mut problem = Self::new(variables)?;
        problem.assign_columns(variables, columns, lower, upper)?;
        Ok(problem)
    }

    /// [`from_columns`](Self::from_columns) into the memory of this problem: allocates nothing within capacity.
    ///
    /// # Errors
    /// Those of [`from_columns`](Self::from_columns); the problem is then the box without rows.
    pub fn assign_columns(
        &mut self,
        variables: usize,
        columns: &[f64],
        lower: &[f64],
        upper: &[f64],
    ) -> Result<(), LpError> {
        self.reset(variables)?;
        let rows = lower.len();
        check_length(rows, upper.len())?;
        check_length(variables.saturating_mul(rows), columns.len())?;
        self.matrix.resize(rows * self.stride, 0.0);
        if rows > 0 {
            for (j, column) in columns.chunks_exact(rows).enumerate() {
                for (i, &value) in column.iter().enumerate() {
                    self.matrix[i * self.stride + j] = value;
                }
            }
        }
        for i in 0..rows {
            let row = &self.matrix[i * self.stride..][..variables];
            match Range::new(i, row, lower[i], upper[i]) {
                Ok(range) => self.ranges.push(range),
                Err(error) => {
                    self.truncate_rows(0);
                    return Err(error);
                }
            }
        }
        Ok(())
    }

    /// Makes this the box of `variables` dimensions without rows, keeping its memory.
    ///
    /// # Errors
    /// [`LpError::TooLarge`] above 2^24 variables.
    pub fn reset(&mut self, variables: usize) -> Result<(), LpError> {
        if variables > MAX_SIZE {
            return Err(LpError::TooLarge { size: variables });
        }
        self.variables = variables;
        self.stride = variables.div_ceil(LANES).max(1) * LANES;
        self.truncate_rows(0);
        Ok(())
    }

    /// Becomes a copy of `other`: allocates nothing within capacity.
    pub fn assign(&mut self, other: &Self) {
        self.variables = other.variables;
        self.stride = other.stride;
        self.matrix.clone_from(&other.matrix);
        self.ranges.clone_from(&other.ranges);
    }

    /// Appends the row `lower <= row x <= upper` and returns its index.
    ///
    /// # Errors
    /// [`LpError::Length`], [`LpError::Entry`], [`LpError::Range`], [`LpError::RowOverflow`] or [`LpError::TooLarge`].
    pub fn push_row(&mut self, row: &[f64], lower: f64, upper: f64) -> Result<usize, LpError> {
        check_length(self.variables, row.len())?;
        let index = self.rows();
        if index >= MAX_SIZE {
            return Err(LpError::TooLarge { size: index + 1 });
        }
        let range = Range::new(index, row, lower, upper)?;
        self.matrix.extend_from_slice(row);
        self.matrix.resize((index + 1) * self.stride, 0.0);
        self.ranges.push(range);
        Ok(index)
    }

    /// Replaces the range of row `row`.
    ///
    /// # Errors
    /// [`LpError::RowIndex`] or [`LpError::Range`].
    pub fn set_range(&mut self, row: usize, lower: f64, upper: f64) -> Result<(), LpError> {
        if row >= self.rows() {
            return Err(LpError::RowIndex { row, rows: self.rows() });
        }
        self.ranges[row] = Range::new(row, self.row(row), lower, upper)?;
        Ok(())
    }

    /// Keeps the first `rows` rows.
    pub fn truncate_rows(&mut self, rows: usize) {
        self.ranges.truncate(rows);
        self.matrix.truncate(self.ranges.len() * self.stride);
    }

    /// Keeps the rows for whose index `keep` says `true`, in their order.
    pub fn retain_rows(&mut self, mut keep: impl FnMut(usize) -> bool) {
        let mut kept = 0;
        for i in 0..self.rows() {
            if keep(i) {
                self.ranges[kept] = self.ranges[i];
                self.matrix.copy_within(i * self.stride..(i + 1) * self.stride, kept * self.stride);
                kept += 1;
            }
        }
        self.truncate_rows(kept);
    }

    /// Number of variables `n`.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Number of rows `m`.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.ranges.len()
    }

    /// The entries of row `i`.
    ///
    /// # Panics
    /// If there is no row `i`, as indexing a slice does.
    #[must_use]
    pub fn row(&self, i: usize) -> &[f64] {
        &self.matrix[i * self.stride..][..self.variables]
    }

    /// The range `(lower, upper)` of row `i`, as given.
    ///
    /// # Panics
    /// If there is no row `i`, as indexing a slice does.
    #[must_use]
    pub fn range(&self, i: usize) -> (f64, f64) {
        (self.ranges[i].lower, self.ranges[i].upper)
    }

    pub(crate) fn stride(&self) -> usize {
        self.stride
    }

    pub(crate) fn padded_row(&self, i: usize) -> &[f64] {
        &self.matrix[i * self.stride..][..self.stride]
    }

    /// By how much a point misses the rows at most, as a share of their 1-norms; plain rounding.
    pub(crate) fn largest_miss(&self, point: &[f64]) -> f64 {
        let mut largest = 0.0_f64;
        for (row, range) in self.matrix.chunks_exact(self.stride).zip(&self.ranges) {
            let activity: f64 = row.iter().zip(point).map(|(a, x)| a * x).sum();
            largest = largest.max((activity - range.hi).max(range.lo - activity) * range.scale);
        }
        largest
    }

    pub(crate) fn ranges(&self) -> &[Range] {
        &self.ranges
    }
}

impl PartialEq for Problem {
    fn eq(&self, other: &Self) -> bool {
        self.variables == other.variables && self.matrix == other.matrix && self.ranges == other.ranges
    }
}

impl Range {
    fn new(index: usize, row: &[f64], lower: f64, upper: f64) -> Result<Self, LpError> {
        // NaN fails both comparisons.
        if !(lower <= upper && lower < f64::INFINITY && upper > f64::NEG_INFINITY) {
            return Err(LpError::Range { row: index, lower, upper });
        }
        let norm = norm1_up(row);
        if !norm.is_finite() {
            return Err(match row.iter().position(|v| !v.is_finite()) {
                Some(column) => LpError::Entry { row: index, column, value: row[column] },
                None => LpError::RowOverflow { row: index },
            });
        }
        // A range beyond the reach of the row (lower > norm) keeps its near end: nothing satisfies it, and a bound on
        // nothing is valid whatever stands at the far end.
        let lo = if lower < -norm { upper.min(-norm) } else { lower };
        let hi = if upper > norm { lower.max(norm) } else { upper };
        Ok(Self { lower, upper, lo, hi, norm, scale: reciprocal_power_of_two(norm) })
    }
}

/// The power of two that brings a norm into [1/2, 1) (1 for a zero norm; clamped to the normal numbers).
fn reciprocal_power_of_two(norm: f64) -> f64 {
    if norm < f64::MIN_POSITIVE {
        return 1.0;
    }
    let biased = norm.to_bits() >> 52; // 1..=2046: positive, normal, finite
    f64::from_bits((2045 - biased.min(2044)) << 52)
}

pub(crate) fn check_length(expected: usize, found: usize) -> Result<(), LpError> {
    if expected == found { Ok(()) } else { Err(LpError::Length { expected, found }) }
}
