//! Dense real matrices, flat and column-major: one generator is one contiguous chunk.

use core::ops::{Index, IndexMut};

use crate::{Part, SetError};

/// A dense `rows x cols` matrix of `f64`, stored column after column.
///
/// A generator matrix has one row a dimension and one column a generator, so appending generators moves nothing. Entries may be
/// any `f64`; the sets check that theirs are finite.
#[derive(Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct Matrix {
    rows: usize,
    cols: usize,
    data: Vec<f64>,
}

impl Matrix {
    /// The `rows x cols` matrix of zeros.
    #[must_use]
    pub fn zeros(rows: usize, cols: usize) -> Self {
        Self { rows, cols, data: vec![0.0; rows * cols] }
    }

    /// The identity of size `n`.
    #[must_use]
    pub fn identity(n: usize) -> Self {
        Self::from_diagonal(&vec![1.0; n])
    }

    /// The square matrix with the given diagonal and zeros elsewhere.
    #[must_use]
    pub fn from_diagonal(diagonal: &[f64]) -> Self {
        let mut matrix = Self::zeros(diagonal.len(), diagonal.len());
        for (i, &d) in diagonal.iter().enumerate() {
            matrix[(i, i)] = d;
        }
        matrix
    }

    /// A matrix from its rows, as one writes it down.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the rows differ in length.
    ///
    /// ```
    /// # use setrep::Matrix;
    /// let m = Matrix::from_rows(&[&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]])?;
    /// assert_eq!((m.rows(), m.cols(), m[(1, 2)]), (2, 3, 6.0));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn from_rows(rows: &[&[f64]]) -> Result<Self, SetError> {
        let cols = rows.first().map_or(0, |row| row.len());
        let mut matrix = Self::zeros(rows.len(), cols);
        for (i, row) in rows.iter().enumerate() {
            SetError::check_size(Part::Matrix, cols, row.len())?;
            for (j, &x) in row.iter().enumerate() {
                matrix[(i, j)] = x;
            }
        }
        Ok(matrix)
    }

    /// A matrix from its columns (generators).
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the columns differ in length.
    pub fn from_columns(columns: &[&[f64]]) -> Result<Self, SetError> {
        let mut matrix = Self::zeros(columns.first().map_or(0, |column| column.len()), 0);
        for column in columns {
            matrix.push_col(column)?;
        }
        Ok(matrix)
    }

    /// A matrix from its entries in column-major order.
    ///
    /// # Errors
    /// [`SetError::Dimension`] unless there are `rows * cols` entries.
    pub fn from_column_slice(rows: usize, cols: usize, data: &[f64]) -> Result<Self, SetError> {
        SetError::check_size(Part::Matrix, rows.saturating_mul(cols), data.len())?;
        Ok(Self { rows, cols, data: data.to_vec() })
    }

    /// Overwrites shape and entries from column-major order; allocates nothing within capacity.
    ///
    /// # Errors
    /// [`SetError::Dimension`] unless there are `rows * cols` entries.
    pub fn assign_column_slice(&mut self, rows: usize, cols: usize, data: &[f64]) -> Result<(), SetError> {
        SetError::check_size(Part::Matrix, rows.saturating_mul(cols), data.len())?;
        (self.rows, self.cols) = (rows, cols);
        self.data.clear();
        self.data.extend_from_slice(data);
        Ok(())
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    #[must_use]
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// Entry in row `i` and column `j`, if it exists. `matrix[(i, j)]` is the form that panics outside.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> Option<f64> {
        (i < self.rows && j < self.cols).then(|| self.data[j * self.rows + i])
    }

    /// Column `j` as a slice.
    ///
    /// # Panics
    /// If `j >= cols`, as indexing a slice does.
    #[must_use]
    pub fn col(&self, j: usize) -> &[f64] {
        &self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// Column `j` as a mutable slice.
    ///
    /// # Panics
    /// If `j >= cols`, as indexing a slice does.
    pub fn col_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// The columns in order.
    pub fn columns(&self) -> impl ExactSizeIterator<Item = &[f64]> + Clone {
        self.data.chunks_exact(self.rows.max(1))
    }

    /// All entries, column after column.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        &self.data
    }

    /// All entries, column after column, mutable.
    pub fn as_mut_slice(&mut self) -> &mut [f64] {
        &mut self.data
    }

    /// Appends a column; the first column of a `0 x 0` matrix sets the number of rows.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the column has the wrong length.
    pub fn push_col(&mut self, column: &[f64]) -> Result<(), SetError> {
        if self.data.is_empty() && self.rows == 0 && self.cols == 0 {
            self.rows = column.len();
        }
        SetError::check_size(Part::Matrix, self.rows, column.len())?;
        self.data.extend_from_slice(column);
        self.cols += 1;
        Ok(())
    }

    /// The transpose.
    #[must_use]
    pub fn transpose(&self) -> Self {
        let mut transpose = Self::zeros(self.cols, self.rows);
        for j in 0..self.cols {
            for i in 0..self.rows {
                transpose[(j, i)] = self[(i, j)];
            }
        }
        transpose
    }

    /// Makes this the `rows x cols` matrix of zeros; allocates nothing within capacity.
    pub fn reset(&mut self, rows: usize, cols: usize) {
        (self.rows, self.cols) = (rows, cols);
        self.data.clear();
        self.data.resize(rows * cols, 0.0);
    }

    /// Appends `columns` (whole columns, column-major).
    pub(crate) fn append_columns(&mut self, columns: &[f64]) {
        debug_assert_eq!(columns.len() % self.rows.max(1), 0);
        self.data.extend_from_slice(columns);
        self.cols += columns.len() / self.rows.max(1);
    }

    /// Appends the column `value * e_i`.
    pub(crate) fn push_axis(&mut self, i: usize, value: f64) {
        let start = self.data.len();
        self.data.resize(start + self.rows, 0.0);
        self.data[start + i] = value;
        self.cols += 1;
    }

    /// Appends `columns` columns of zeros.
    pub(crate) fn push_zero_cols(&mut self, columns: usize) {
        self.cols += columns;
        self.data.resize(self.rows * self.cols, 0.0);
    }

    /// Appends `rows` rows of zeros.
    pub(crate) fn push_zero_rows(&mut self, rows: usize) {
        let (old, new) = (self.rows, self.rows + rows);
        self.data.resize(new * self.cols, 0.0);
        for j in (0..self.cols).rev() {
            self.data.copy_within(j * old..(j + 1) * old, j * new);
            self.data[j * new + old..(j + 1) * new].fill(0.0);
        }
        self.rows = new;
    }

    /// Keeps the rows for whose index `keep` says `true`, in their order.
    pub(crate) fn retain_rows(&mut self, keep: impl Fn(usize) -> bool) {
        let old = self.rows;
        self.rows = (0..old).filter(|&i| keep(i)).count();
        let mut end = 0;
        for start in (0..self.cols).map(|j| j * old) {
            for i in (0..old).filter(|&i| keep(i)) {
                self.data[end] = self.data[start + i];
                end += 1;
            }
        }
        self.data.truncate(end);
    }

    /// Drops the columns from `cols` on.
    pub(crate) fn truncate_cols(&mut self, cols: usize) {
        self.data.truncate(cols * self.rows);
        self.cols = self.cols.min(cols);
    }

    /// Overwrites column `to` by column `from`.
    pub(crate) fn copy_col(&mut self, from: usize, to: usize) {
        self.data.copy_within(from * self.rows..(from + 1) * self.rows, to * self.rows);
    }

    /// Makes room for `columns` more columns.
    pub(crate) fn reserve_cols(&mut self, columns: usize) {
        self.data.reserve(columns * self.rows);
    }

    /// Exchanges the storage with a `rows x cols` array held by `data`.
    pub(crate) fn swap_storage(&mut self, rows: usize, data: &mut Vec<f64>) {
        core::mem::swap(&mut self.data, data);
        self.rows = rows;
    }
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for Matrix {
    fn clone(&self) -> Self {
        Self { rows: self.rows, cols: self.cols, data: self.data.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        (self.rows, self.cols) = (source.rows, source.cols);
        self.data.clone_from(&source.data);
    }
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;

    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.col(j)[i]
    }
}

impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        &mut self.col_mut(j)[i]
    }
}

/// What is stored of a matrix; reading it back checks the sizes.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    rows: usize,
    cols: usize,
    data: Vec<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for Matrix {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        SetError::check_size(Part::Matrix, parts.rows.saturating_mul(parts.cols), parts.data.len())?;
        Ok(Self { rows: parts.rows, cols: parts.cols, data: parts.data })
    }
}
