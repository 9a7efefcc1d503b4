//! [`LinearSystem`]: a linear model with polytopic bounds.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix};

use crate::EstimatorError;
use crate::error::{check_finite, check_size};

/// A linear system with bounded noises and linear invariants,
///
/// ```text
/// x_k = A x_{k-1} + B_u u_{k-1} + B_w w_{k-1}    w in W
/// y_k = C x_k + D_u u_k + D_v v_k                v in V
/// E x_k in [d]
/// ```
///
/// Every part may be written to between calls, as the system varies over time; sizes and entries are checked where a part is used. Matrices
/// without an effect may be left out: a default matrix without columns for no input, without rows for no invariant.
///
/// **Source:** paper 003, (B.1); a range `[d]` states an inexact invariant.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearSystem {
    /// `A: n x n`.
    pub a: Matrix,
    /// `B_u: n x n_u`.
    pub b_u: Matrix,
    /// `B_w: n x n_w`.
    pub b_w: Matrix,
    /// `W`, in dimension `n_w`.
    pub w: ConstrainedZonotope,
    /// `C: n_y x n`.
    pub c: Matrix,
    /// `D_u: n_y x n_u`.
    pub d_u: Matrix,
    /// `D_v: n_y x n_v`.
    pub d_v: Matrix,
    /// `V`, in dimension `n_v`.
    pub v: ConstrainedZonotope,
    /// `E: n_d x n`.
    pub e: Matrix,
    /// `[d]`, `n_d` intervals.
    pub d: Vec<Interval>,
}

impl LinearSystem {
    /// `x_k = A x_{k-1} + w`, `y_k = C x_k + v`: noises added to every state and every output, no inputs, no invariants.
    ///
    /// # Errors
    /// Sizes that do not fit, entries that are not finite.
    pub fn new(a: Matrix, w: ConstrainedZonotope, c: Matrix, v: ConstrainedZonotope) -> Result<Self, EstimatorError> {
        let (n, m) = (a.rows(), c.rows());
        let (b_u, b_w) = (Matrix::zeros(n, 0), Matrix::identity(n));
        let (d_u, d_v) = (Matrix::zeros(m, 0), Matrix::identity(m));
        let system = Self { a, b_u, b_w, w, c, d_u, d_v, v, e: Matrix::zeros(0, n), d: Vec::new() };
        system.check_dynamics(n)?;
        system.check_measurement(n)?;
        Ok(system)
    }

    /// The same with the invariant `E x in [d]`.
    #[must_use]
    pub fn with_invariant(self, e: Matrix, d: Vec<Interval>) -> Self {
        Self { e, d, ..self }
    }

    /// `Ok` if (B.1a) is a system of `n` states.
    pub(super) fn check_dynamics(&self, n: usize) -> Result<(), EstimatorError> {
        check_shape("matrix A", (n, n), &self.a)?;
        check_shape("matrix B_u", (n, self.b_u.cols()), &self.b_u)?;
        check_shape("matrix B_w", (n, self.w.dim()), &self.b_w)
    }

    /// `Ok` if (B.1b) measures `n` states.
    pub(super) fn check_measurement(&self, n: usize) -> Result<(), EstimatorError> {
        let m = self.c.rows();
        check_shape("matrix C", (m, n), &self.c)?;
        check_shape("matrix D_u", (m, self.d_u.cols()), &self.d_u)?;
        check_shape("matrix D_v", (m, self.v.dim()), &self.d_v)
    }

    /// `Ok` if the invariant is one of `n` states.
    pub(super) fn check_invariant(&self, n: usize) -> Result<(), EstimatorError> {
        check_size("range of the invariant", self.e.rows(), self.d.len())?;
        if self.d.is_empty() {
            return Ok(());
        }
        check_shape("matrix E", (self.d.len(), n), &self.e)?;
        match self.d.iter().position(Interval::is_empty) {
            Some(index) => Err(EstimatorError::EmptyRange { what: "range of the invariant", index }),
            None => Ok(()),
        }
    }
}

/// `Ok` if a matrix has this shape and finite entries. One without entries may have any.
fn check_shape(what: &'static str, (rows, cols): (usize, usize), matrix: &Matrix) -> Result<(), EstimatorError> {
    if rows * cols == 0 && matrix.as_slice().is_empty() {
        return Ok(());
    }
    check_size(what, rows, matrix.rows())?;
    check_size(what, cols, matrix.cols())?;
    check_finite(what, matrix.as_slice())
}
