//! Outputs that known points give, and their innovations.

use lie_groups::LieGroup;
use nalgebra::{SMatrix, SVector};
use setrep::Matrix;

use super::ErrorSide;
use crate::EstimatorError;
use crate::error::{check_finite, check_size};

/// What is measured: one block of `D` numbers for each known point.
#[derive(Debug, Clone, PartialEq)]
pub enum Outputs<const D: usize> {
    /// Left-invariant: `y_i = X . d_i + v_i`, points `d_i` of the body seen from the world. The origin gives the position.
    Left(Vec<SVector<f64, D>>),
    /// Right-invariant: `y_i = X^-1 . b_i + v_i`, points `b_i` of the world (landmarks) seen from the body.
    Right(Vec<SVector<f64, D>>),
}

impl<const D: usize> Outputs<D> {
    /// The position `X . 0`, as a satellite receiver at the origin of the body gives it.
    #[must_use]
    pub fn position() -> Self {
        Self::Left(vec![SVector::zeros()])
    }

    /// The known points.
    pub fn points(&self) -> &[SVector<f64, D>] {
        match self {
            Self::Left(points) | Self::Right(points) => points,
        }
    }
}

/// The innovation `z ~ C eps + B v`, `B` the same `D x D` block for each point.
pub(super) struct Innovation<const N: usize, const D: usize, const M: usize> {
    pub(super) z: SVector<f64, M>,
    pub(super) c: SMatrix<f64, M, N>,
    pub(super) b: SMatrix<f64, D, D>,
}

impl<const N: usize, const D: usize, const M: usize> Innovation<N, D, M> {
    /// The innovation of `y` at the estimate.
    ///
    /// | output | left error | right error |
    /// |---|---|---|
    /// | left: `y = X . d + v` | `z = Xhat^-1 . y - d`, `C = J(d)`, `B = R^-1` | `z = y - p`, `C = J(p)`, `B = I`, `p = Xhat . d` |
    /// | right: `y = X^-1 . b + v` | `z = p - y`, `C = J(p)`, `B = -I`, `p = Xhat^-1 . b` | `z = b - Xhat . y`, `C = J(b)`, `B = -R` |
    ///
    /// with `J(p) = d/d eps exp(eps) . p` and `R` the linear part of `Xhat`. Where output and error are of the same side, `C` does
    /// not depend on the estimate: the alternative innovation of paper 000, Remark 5.
    pub(super) fn new<G, Side>(estimate: &G, outputs: &Outputs<D>, y: &[f64]) -> Result<Self, EstimatorError>
    where
        G: LieGroup<f64, N, D>,
        Side: ErrorSide,
    {
        check_size("output", M, y.len())?;
        check_finite("output", y)?;
        let inverse = estimate.inverse();
        let identity = SMatrix::<f64, D, D>::identity();
        let b = match (outputs, Side::IS_LEFT) {
            (Outputs::Left(_), true) => inverse.act_linear(),
            (Outputs::Left(_), false) => identity,
            (Outputs::Right(_), true) => -identity,
            (Outputs::Right(_), false) => -estimate.act_linear(),
        };
        let (mut z, mut c) = (SVector::<f64, M>::zeros(), SMatrix::<f64, M, N>::zeros());
        for (i, (point, y)) in outputs.points().iter().zip(y.chunks_exact(D)).enumerate() {
            let y = SVector::<f64, D>::from_column_slice(y);
            let (p, z_i) = match (outputs, Side::IS_LEFT) {
                (Outputs::Left(_), true) => (*point, inverse.act(&y) - point),
                (Outputs::Left(_), false) => {
                    let p = estimate.act(point);
                    (p, y - p)
                }
                (Outputs::Right(_), true) => {
                    let p = inverse.act(point);
                    (p, p - y)
                }
                (Outputs::Right(_), false) => (*point, point - estimate.act(&y)),
            };
            z.fixed_rows_mut::<D>(i * D).copy_from(&z_i);
            c.fixed_view_mut::<D, N>(i * D, 0).copy_from(&G::act_jacobian(&p));
        }
        Ok(Self { z, c, b })
    }

    /// Generator `j` of the noise of the innovation: `B` on each block of column `j`.
    pub(super) fn noise(&self, generators: &Matrix, j: usize) -> SVector<f64, M> {
        let mut v = SVector::<f64, M>::zeros();
        for (i, block) in generators.col(j).chunks_exact(D).enumerate() {
            v.fixed_rows_mut::<D>(i * D).copy_from(&(self.b * SVector::<f64, D>::from_column_slice(block)));
        }
        v
    }

    /// `Q_v`, the covariation of the noise of the innovation.
    pub(super) fn noise_covariation(&self, generators: &Matrix) -> SMatrix<f64, M, M> {
        let mut q = SMatrix::zeros();
        for j in 0..generators.cols() {
            let v = self.noise(generators, j);
            q += v * v.transpose();
        }
        q
    }
}
