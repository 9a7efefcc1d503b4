//! Conversions between [`Matrix`] and nalgebra's matrices (both column-major).

use nalgebra::{DMatrix, Dim, RawStorage, SMatrix};

use crate::{Matrix, Part, SetError};

impl<R: Dim, C: Dim, S: RawStorage<f64, R, C>> From<&nalgebra::Matrix<f64, R, C, S>> for Matrix {
    fn from(source: &nalgebra::Matrix<f64, R, C, S>) -> Self {
        let mut matrix = Self::zeros(source.nrows(), source.ncols());
        for (target, &x) in matrix.as_mut_slice().iter_mut().zip(source.iter()) {
            *target = x;
        }
        matrix
    }
}

impl Matrix {
    /// Copies a statically sized matrix; allocates nothing within capacity.
    pub fn assign<const R: usize, const C: usize>(&mut self, source: &SMatrix<f64, R, C>) {
        // The sizes agree by construction, so the assignment cannot fail.
        let _ = self.assign_column_slice(R, C, source.as_slice());
    }

    /// This matrix as nalgebra's dynamically sized one.
    #[must_use]
    pub fn to_dmatrix(&self) -> DMatrix<f64> {
        DMatrix::from_column_slice(self.rows(), self.cols(), self.as_slice())
    }

    /// This matrix as nalgebra's statically sized one.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if it is not `R x C`.
    pub fn to_smatrix<const R: usize, const C: usize>(&self) -> Result<SMatrix<f64, R, C>, SetError> {
        SetError::check_size(Part::Matrix, R, self.rows())?;
        SetError::check_size(Part::Matrix, C, self.cols())?;
        Ok(SMatrix::from_column_slice(self.as_slice()))
    }
}
