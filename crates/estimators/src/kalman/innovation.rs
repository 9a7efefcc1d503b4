//! [`Joint`]: the joint spread of outputs and states, from which gain, innovation and corrected covariance fall out together.

use nalgebra::{SMatrix, SVector};

use super::gaussian::squared_distance;
use super::root::{Squeeze, Turn, add};
use crate::EstimatorError;
use crate::error::check_finite;

/// Smallest accepted ratio of a squared pivot of the innovation's covariance to the diagonal entry it came from.
const PIVOT_LIMIT: f64 = 1e-13;

/// What a measurement said beyond the prediction: `z = y - yhat` with its predicted covariance `P_yy`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Innovation<const M: usize> {
    residual: SVector<f64, M>,
    root: SMatrix<f64, M, M>,
}

impl<const M: usize> Innovation<M> {
    /// The innovation `z`.
    #[must_use]
    pub fn residual(&self) -> &SVector<f64, M> {
        &self.residual
    }

    /// Its predicted covariance `P_yy`.
    #[must_use]
    pub fn covariance(&self) -> SMatrix<f64, M, M> {
        self.root * self.root.transpose()
    }

    /// Normalised innovation squared, `z' P_yy^-1 z`; its mean is `M` for a filter whose model is right.
    #[must_use]
    pub fn nis(&self) -> f64 {
        squared_distance(&self.root, &self.residual)
    }
}

/// The lower triangular root of the joint covariance of outputs and states,
///
/// ```text
/// [ S_yy   0  ] [ S_yy   0  ]'   [ P_yy  P_yx ]
/// [  K_    S+ ] [  K_    S+ ]  = [ P_xy  P_xx ]
/// ```
///
/// so that the gain is `K = P_xy P_yy^-1 = K_ S_yy^-1` and the corrected covariance `P_xx - K P_yy K' = S+ S+'`, without a subtraction.
///
/// A rule of one's own ([`Observe`](super::Observe)) builds it from pairs of deviations.
#[derive(Debug, Clone, Copy)]
pub struct Joint<const N: usize, const M: usize> {
    outputs: SMatrix<f64, M, M>,
    cross: SMatrix<f64, N, M>,
    states: SMatrix<f64, N, N>,
}

impl<const N: usize, const M: usize> Default for Joint<N, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize, const M: usize> Joint<N, M> {
    /// No spread.
    #[must_use]
    pub fn new() -> Self {
        Self { outputs: SMatrix::zeros(), cross: SMatrix::zeros(), states: SMatrix::zeros() }
    }

    /// Adds `(y; x) (y; x)'` to the covariance: a column of its root, a sigma point beside the mean, a noise (`x = 0`).
    pub fn add(&mut self, mut y: SVector<f64, M>, mut x: SVector<f64, N>) {
        for j in 0..M {
            if let Some(turn) = Turn::new(self.outputs[(j, j)], y[j]) {
                turn.apply(&mut self.outputs.column_mut(j).as_mut_slice()[j..], &mut y.as_mut_slice()[j..]);
                turn.apply(self.cross.column_mut(j).as_mut_slice(), x.as_mut_slice());
            }
        }
        add(&mut self.states, x);
    }

    /// Takes `(y; x) (y; x)'` away, as sigma points of negative weight do; `what` names it in the error.
    ///
    /// # Errors
    /// [`EstimatorError::NotPositive`] if the covariance is not positive semidefinite without it; the spread is then spoiled.
    pub fn remove(
        &mut self,
        what: &'static str,
        mut y: SVector<f64, M>,
        mut x: SVector<f64, N>,
    ) -> Result<(), EstimatorError> {
        let lost = |index, value| EstimatorError::NotPositive { what, index, value };
        for j in 0..M {
            if let Some(squeeze) = Squeeze::new(self.outputs[(j, j)], y[j]).map_err(|value| lost(j, value))? {
                squeeze.apply(&mut self.outputs.column_mut(j).as_mut_slice()[j..], &mut y.as_mut_slice()[j..]);
                squeeze.apply(self.cross.column_mut(j).as_mut_slice(), x.as_mut_slice());
            }
        }
        for j in 0..N {
            if let Some(squeeze) = Squeeze::new(self.states[(j, j)], x[j]).map_err(|value| lost(M + j, value))? {
                squeeze.apply(&mut self.states.column_mut(j).as_mut_slice()[j..], &mut x.as_mut_slice()[j..]);
            }
        }
        Ok(())
    }

    /// The root `S_yy` of the outputs' covariance.
    pub(super) fn outputs(&self) -> &SMatrix<f64, M, M> {
        &self.outputs
    }

    /// Ratio of a squared pivot of the outputs' covariance to the diagonal entry it came from; NaN if that is 0.
    fn pivot_ratio(&self, j: usize) -> f64 {
        // Relative to the largest entry, whose square may leave the range.
        let row = self.outputs.row(j) / self.outputs.row(j).amax();
        row[j].powi(2) / row.norm_squared()
    }

    /// `P_xy P_yy^-1 y`; where `P_yy` is singular, what is off its range counts as 0.
    pub(super) fn gain(&self, y: &SVector<f64, M>) -> SVector<f64, N> {
        let mut z = SVector::<f64, M>::zeros();
        for i in 0..M {
            if self.pivot_ratio(i) >= PIVOT_LIMIT {
                let known: f64 = (0..i).map(|j| self.outputs[(i, j)] * z[j]).sum();
                z[i] = (y[i] - known) / self.outputs[(i, i)];
            }
        }
        self.cross * z
    }

    /// The root of the states' covariance given the outputs; all of it where there are none.
    pub(super) fn states(&self) -> &SMatrix<f64, N, N> {
        &self.states
    }

    /// Correction `K z` and corrected root for an innovation `z`.
    pub(super) fn condition(
        &self,
        residual: SVector<f64, M>,
    ) -> Result<(SVector<f64, N>, SMatrix<f64, N, N>, Innovation<M>), EstimatorError> {
        check_finite("innovation", residual.as_slice())?;
        check_finite("covariance of the innovation", self.outputs.as_slice())?;
        // A ratio 0 / 0 is not accepted either.
        if !(0..M).all(|j| self.pivot_ratio(j) >= PIVOT_LIMIT) {
            let pivot_ratio = (0..M).map(|j| self.pivot_ratio(j)).fold(f64::INFINITY, f64::min);
            let pivot_ratio = if pivot_ratio < PIVOT_LIMIT { pivot_ratio } else { 0.0 };
            return Err(EstimatorError::SingularInnovation { outputs: M, pivot_ratio, limit: PIVOT_LIMIT });
        }
        let mut z = residual;
        for i in 0..M {
            let known: f64 = (0..i).map(|j| self.outputs[(i, j)] * z[j]).sum();
            z[i] = (z[i] - known) / self.outputs[(i, i)];
        }
        Ok((self.cross * z, self.states, Innovation { residual, root: self.outputs }))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector2, Vector3};

    use super::Joint;

    /// Gain and covariance against the textbook's formulas, and Joseph's.
    #[test]
    fn conditioning_is_the_kalman_update() {
        let s = Matrix3::new(1.0, 0.0, 0.0, 0.5, 2.0, 0.0, -0.3, 0.7, 0.4);
        let h = Matrix2x3::new(1.0, 0.0, 2.0, 0.0, -1.0, 0.5);
        let r = Matrix2::new(0.3, 0.0, 0.1, 0.2);
        let mut joint = Joint::new();
        for x in s.column_iter() {
            joint.add(h * x, x.into_owned());
        }
        for v in r.column_iter() {
            joint.add(v.into_owned(), Vector3::zeros());
        }
        let residual = Vector2::new(0.4, -1.5);
        let (shift, root, innovation) = joint.condition(residual).unwrap();
        let (p, noise) = (s * s.transpose(), r * r.transpose());
        let p_yy = h * p * h.transpose() + noise;
        let inverse = p_yy.try_inverse().unwrap();
        let gain = p * h.transpose() * inverse;
        assert!((shift - gain * residual).norm() < 1e-14);
        assert!((innovation.covariance() - p_yy).norm() < 1e-14);
        assert!((innovation.nis() - residual.dot(&(inverse * residual))).abs() < 1e-13);
        let closed = Matrix3::identity() - gain * h;
        let joseph = closed * p * closed.transpose() + gain * noise * gain.transpose();
        assert!((root * root.transpose() - joseph).norm() < 1e-14);

        // What was added can be taken away again, but not more.
        let before = joint;
        let (y, x) = (Vector2::new(0.2, 0.1), Vector3::new(-0.1, 0.0, 0.05));
        joint.add(y, x);
        joint.remove("test", y, x).unwrap();
        assert!((joint.outputs - before.outputs).norm() < 1e-13 && (joint.states - before.states).norm() < 1e-13);
        assert!(joint.remove("test", 100.0 * y, x).is_err());
    }
}
