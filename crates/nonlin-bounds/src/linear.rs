//! [`Linear`]: a linear function from its matrices.

use scalars::Scalar;
use setrep::{Matrix, Part, SetError};

use crate::{BoundError, Function, Operand};

/// `y = A x + B p`, shapes `A: m x n`, `B: m x q`; `q = 0` unless given.
///
/// Its derivative is `A` exactly, so every affine enclosure of it is the function itself but for rounding.
///
/// ```
/// use nonlin_bounds::{DynFunction, Linear};
/// use setrep::Matrix;
///
/// let f = Linear::new(Matrix::from_rows(&[&[1.0, 0.5], &[0.0, 1.0]])?)?.with_parameters(Matrix::from_rows(&[&[0.0], &[2.0]])?)?;
/// let mut y = [0.0; 2];
/// f.value(&[1.0, 4.0], &[-1.0], &mut y)?;
/// assert_eq!(y, [3.0, 2.0]);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    variables: Matrix,
    parameters: Matrix,
}

impl Linear {
    /// `y = A x`.
    ///
    /// # Errors
    /// [`SetError::NonFinite`].
    pub fn new(a: Matrix) -> Result<Self, BoundError> {
        check_finite(&a)?;
        let parameters = Matrix::zeros(a.rows(), 0);
        Ok(Self { variables: a, parameters })
    }

    /// The same plus `B p`.
    ///
    /// # Errors
    /// [`BoundError::Dimension`] if `B` has not as many rows as `A`, [`SetError::NonFinite`].
    pub fn with_parameters(self, b: Matrix) -> Result<Self, BoundError> {
        BoundError::check_size(Operand::Outputs, self.variables.rows(), b.rows())?;
        check_finite(&b)?;
        Ok(Self { parameters: b, ..self })
    }
}

fn check_finite(matrix: &Matrix) -> Result<(), BoundError> {
    match matrix.as_slice().iter().position(|x| !x.is_finite()) {
        Some(index) => {
            let (row, col) = (index % matrix.rows().max(1), index / matrix.rows().max(1));
            Err(SetError::NonFinite { part: Part::Matrix, row, col, value: matrix[(row, col)] }.into())
        }
        None => Ok(()),
    }
}

impl Function for Linear {
    fn variables(&self) -> usize {
        self.variables.cols()
    }
    fn parameters(&self) -> usize {
        self.parameters.cols()
    }
    fn outputs(&self) -> usize {
        self.variables.rows()
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        y.fill(S::zero());
        let columns = self.variables.columns().chain(self.parameters.columns());
        for (column, &value) in columns.zip(x.iter().chain(p)) {
            for (sum, &a) in y.iter_mut().zip(column) {
                // What does not depend on a variable has no derivative by it.
                if a == 1.0 {
                    *sum += value;
                } else if a != 0.0 {
                    *sum += value.scale(a);
                }
            }
        }
    }
}
