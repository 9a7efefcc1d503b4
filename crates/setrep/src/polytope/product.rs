//! Cartesian product of polytopes in vertex form.

use super::{MAX_FACES, VPolytope};
use crate::{Matrix, SetError};

impl VPolytope {
    /// Cartesian product `{ (x, y) : x in X, y in Y }`: every pair of columns, remainders one after the other.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::OverBudget`] beyond [`MAX_FACES`] pairs.
    ///
    /// ```
    /// # use setrep::{Matrix, VPolytope};
    /// let segment = VPolytope::new(Matrix::from_rows(&[&[0.0, 1.0]])?)?;
    /// let square = segment.cartesian_product(&segment)?;
    /// assert_eq!((square.dim(), square.num_vertices()), (2, 4));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn cartesian_product(&self, other: &Self) -> Result<Self, SetError> {
        let count = self.num_vertices().saturating_mul(other.num_vertices());
        if count > MAX_FACES {
            return Err(SetError::OverBudget { count, limit: MAX_FACES });
        }
        let mut vertices = Matrix::zeros(self.dim() + other.dim(), 0);
        vertices.reserve_cols(count);
        for x in self.vertices.columns() {
            for y in other.vertices.columns() {
                vertices.append_columns(&[x, y].concat());
            }
        }
        Ok(Self { vertices, remainder: [&*self.remainder, &*other.remainder].concat() })
    }
}
