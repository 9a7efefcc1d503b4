//! The textbook constrained zonotope in plain floating point.

use nalgebra::{DMatrix, DVector};
use setrep::{ConstrainedZonotope, Matrix, SetError};

/// `{ c + G xi : |xi| <= 1, A xi = b }`, shapes `c: n`, `G: n x ng`, `A: nc x ng`, `b: nc` (paper 003, Definition 1).
#[derive(Debug, Clone, PartialEq)]
pub struct CgRep {
    /// `c`.
    pub center: DVector<f64>,
    /// `G`.
    pub generators: DMatrix<f64>,
    /// `A`.
    pub constraints: DMatrix<f64>,
    /// `b`.
    pub offsets: DVector<f64>,
}

impl CgRep {
    /// The zonotope `{ c + G xi }`, with the rows of `G`.
    #[must_use]
    pub fn zonotope(center: &[f64], generators: &[&[f64]]) -> Self {
        let generators = from_rows(generators);
        let constraints = DMatrix::zeros(0, generators.ncols());
        Self { center: DVector::from_column_slice(center), generators, constraints, offsets: DVector::zeros(0) }
    }

    /// The same set with the constraints `A xi = b`, given by the rows of `A`.
    #[must_use]
    pub fn constrained(mut self, constraints: &[&[f64]], offsets: &[f64]) -> Self {
        (self.constraints, self.offsets) = (from_rows(constraints), DVector::from_column_slice(offsets));
        self
    }

    /// The box `center +- diag(radii)`.
    #[must_use]
    pub fn from_box(center: &DVector<f64>, radii: &DVector<f64>) -> Self {
        Self {
            center: center.clone(),
            generators: DMatrix::from_diagonal(radii),
            constraints: DMatrix::zeros(0, radii.len()),
            offsets: DVector::zeros(0),
        }
    }

    /// Dimension `n`.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.center.len()
    }

    /// `R X + t` (10).
    #[must_use]
    pub fn affine(&self, map: &DMatrix<f64>, translation: &DVector<f64>) -> Self {
        Self { center: map * &self.center + translation, generators: map * &self.generators, ..self.clone() }
    }

    /// Minkowski sum (11).
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let generators = beside(&self.generators, &other.generators);
        let constraints = diagonal(&self.constraints, &other.constraints);
        Self {
            center: &self.center + &other.center,
            generators,
            constraints,
            offsets: stacked(&self.offsets, &other.offsets),
        }
    }

    /// Generalised intersection `{ x in X : R x in Y }`, with the row that equation (12) misses in print.
    #[must_use]
    pub fn intersect(&self, map: &DMatrix<f64>, other: &Self) -> Self {
        let (columns, added) = (self.generators.ncols(), other.generators.ncols());
        let link = beside(&(map * &self.generators), &-&other.generators);
        let both = diagonal(&self.constraints, &other.constraints);
        let (rows, linked) = (both.nrows(), link.nrows());
        let mut constraints = both.resize_vertically(rows + linked, 0.0);
        constraints.rows_mut(rows, linked).copy_from(&link);
        let offsets = stacked(&stacked(&self.offsets, &other.offsets), &(&other.center - map * &self.center));
        let generators = self.generators.clone().resize_horizontally(columns + added, 0.0);
        Self { center: self.center.clone(), generators, constraints, offsets }
    }

    /// The same numbers as a set whose supports, hulls and membership are proven.
    ///
    /// # Errors
    /// [`SetError::NonFinite`] after an overflow.
    pub fn to_set(&self) -> Result<ConstrainedZonotope, SetError> {
        ConstrainedZonotope::from_cg_rep(
            self.center.as_slice(),
            &to_matrix(&self.generators)?,
            &to_matrix(&self.constraints)?,
            self.offsets.as_slice(),
        )
    }
}

fn from_rows(rows: &[&[f64]]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.first().map_or(0, |row| row.len()), |i, j| rows[i][j])
}

fn to_matrix(matrix: &DMatrix<f64>) -> Result<Matrix, SetError> {
    Matrix::from_column_slice(matrix.nrows(), matrix.ncols(), matrix.as_slice())
}

/// `[A B]`.
fn beside(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let mut both = a.clone().resize_horizontally(a.ncols() + b.ncols(), 0.0);
    both.columns_mut(a.ncols(), b.ncols()).copy_from(b);
    both
}

/// `[A 0; 0 B]`.
fn diagonal(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let mut both = a.clone().resize(a.nrows() + b.nrows(), a.ncols() + b.ncols(), 0.0);
    both.view_mut((a.nrows(), a.ncols()), b.shape()).copy_from(b);
    both
}

fn stacked(a: &DVector<f64>, b: &DVector<f64>) -> DVector<f64> {
    DVector::from_iterator(a.len() + b.len(), a.iter().chain(b.iter()).copied())
}
