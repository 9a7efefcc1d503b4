//! ZSMF: the zonotopic set-membership filter on a vector space.

use nalgebra::{SMatrix, SVector};
use setrep::{Matrix, Reduction, Zonotope};

use crate::error::{check_finite, check_size};
use crate::error_set::{ErrorSet, noise_generators};
use crate::{Estimator, EstimatorError, Gain, Guarantee};

/// A model `x+ = f(x, u) + D_w w`, `y = h(x) + v` of `N` states, `M` outputs and `W` process noises, with its derivatives.
///
/// Derivatives are taken at the estimate. Nothing checks them against the functions.
pub trait Model<const N: usize, const M: usize, const W: usize> {
    /// What drives the model over a step.
    type Input;

    /// `f(x, u)`.
    fn transition(&self, x: &SVector<f64, N>, u: &Self::Input) -> SVector<f64, N>;

    /// `A = df/dx` (`N x N`).
    fn transition_jacobian(&self, x: &SVector<f64, N>, u: &Self::Input) -> SMatrix<f64, N, N>;

    /// `D_w` (`N x W`).
    fn noise_jacobian(&self, x: &SVector<f64, N>, u: &Self::Input) -> SMatrix<f64, N, W>;

    /// `h(x)`.
    fn output(&self, x: &SVector<f64, N>) -> SVector<f64, M>;

    /// `C = dh/dx` (`M x N`).
    fn output_jacobian(&self, x: &SVector<f64, N>) -> SMatrix<f64, M, N>;

    /// `y - h(x)`; to be overridden where outputs are angles.
    fn innovation(&self, x: &SVector<f64, N>, y: &SVector<f64, M>) -> SVector<f64, M> {
        y - self.output(x)
    }
}

/// Zonotopic set-membership filter (ZSMF) on `R^N`, with a Luenberger gain.
///
/// With the errors `e = x - xhat` in `<0, H>`, a step from `y_k` to `x_k+1` is
///
/// ```text
/// xhat+ = f(xhat, u) + L (y - h(xhat))
/// H+    = [(A - L C) R_s(H), D_w H_w, -L H_v]
/// ```
///
/// and an update alone is the same with `A = I` and no process noise. `R_s` is an order reduction, none by default; the gain is
/// F-radius optimal by default. The set is a [`Zonotope`] around the estimate.
///
/// **Guarantee:** [`Guarantee::FirstOrder`]. The terms of second order in `e` and the rounding of `xhat` are dropped. For a linear model
/// the set holds the state up to that rounding. For the vehicle of paper 000 it need not: with a first set that holds the
/// true state and an initial heading error of 45 or 90 degrees (rows 2 and 3 of its Table I) the state left the set in 20 of 20 runs
/// of `cargo xtask reproduce inzsmf`, by a factor of up to 9 (uniform noise) or 34 (constant noise at a vertex); without heading error
/// (rows 1 and 4) it never did.
/// **Source:** paper 000, (10), (12), (16).
///
/// ```
/// use estimators::{Estimator, Model, Zsmf};
/// use nalgebra::{Matrix1, Matrix1x2, Matrix2, SVector, Vector1, Vector2};
/// use setrep::{Reduction, Zonotope};
///
/// /// A mass on a line, pushed; its position is measured.
/// struct Mass;
/// impl Model<2, 1, 1> for Mass {
///     type Input = f64;
///     fn transition(&self, x: &Vector2<f64>, push: &f64) -> Vector2<f64> {
///         Vector2::new(x[0] + 0.1 * x[1], x[1] + 0.1 * push)
///     }
///     fn transition_jacobian(&self, _: &Vector2<f64>, _: &f64) -> Matrix2<f64> { Matrix2::new(1.0, 0.1, 0.0, 1.0) }
///     fn noise_jacobian(&self, _: &Vector2<f64>, _: &f64) -> Vector2<f64> { Vector2::new(0.0, 0.1) }
///     fn output(&self, x: &Vector2<f64>) -> Vector1<f64> { Vector1::new(x[0]) }
///     fn output_jacobian(&self, _: &Vector2<f64>) -> Matrix1x2<f64> { Matrix1x2::new(1.0, 0.0) }
/// }
///
/// let start = Zonotope::from_box(&[0.0, 0.0], &[1.0, 5.0])?;
/// let (push_noise, noise) = (Zonotope::from_box(&[0.0], &[0.1])?, Zonotope::from_box(&[0.0], &[0.2])?);
/// let mut filter = Zsmf::new(Mass, &start, &push_noise, &noise)?.with_reduction(Reduction::Girard, 20)?;
/// for k in 0..100 {
///     filter.step(&0.0, &[0.1 * f64::from(k)])?; // moving at speed 1
/// }
/// assert!((filter.estimate()[1] - 1.0).abs() < 0.1);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Zsmf<Mo, const N: usize, const M: usize, const W: usize> {
    model: Mo,
    estimate: SVector<f64, N>,
    errors: ErrorSet<N, M>,
    process: Matrix,
    noise: Matrix,
    /// `Q_v = H_v H_v'`.
    q_v: SMatrix<f64, M, M>,
}

impl<Mo: Model<N, M, W>, const N: usize, const M: usize, const W: usize> Zsmf<Mo, N, M, W> {
    /// A filter that starts with `x_0` in `initial`, whose center is the estimate. The noises keep `w` in `process` (dimension
    /// `W`) and `v` in `noise` (dimension `M`), both around 0.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] for a set of the wrong dimension, [`EstimatorError::NotCentered`] for a noise not around 0.
    pub fn new(model: Mo, initial: &Zonotope, process: &Zonotope, noise: &Zonotope) -> Result<Self, EstimatorError> {
        let process = noise_generators("process noise", process, W)?;
        let noise = noise_generators("output noise", noise, M)?;
        let mut q_v = SMatrix::zeros();
        for column in noise.columns() {
            let v = SVector::<f64, M>::from_column_slice(column);
            q_v += v * v.transpose();
        }
        let errors = ErrorSet::new(initial, process.cols(), noise.cols())?;
        Ok(Self { model, estimate: SVector::from_column_slice(initial.center()), errors, process, noise, q_v })
    }

    /// Sets the rule for the gain.
    #[must_use]
    pub fn with_gain(mut self, gain: Gain<N, M>) -> Self {
        self.errors.set_gain_rule(gain);
        self
    }

    /// Reduces the set to at most `order` generators before each map, paper 000 Remark 1. The set of a step then has at most
    /// `order` generators and those of the two noises.
    ///
    /// # Errors
    /// [`SetError::TooFewGenerators`](setrep::SetError::TooFewGenerators) for `order < N`.
    pub fn with_reduction(mut self, method: Reduction, order: usize) -> Result<Self, EstimatorError> {
        self.errors.set_reduction(Some((method, order)))?;
        Ok(self)
    }

    /// The estimate `xhat`, the center of the set.
    pub fn estimate(&self) -> &SVector<f64, N> {
        &self.estimate
    }

    /// The model.
    pub fn model(&self) -> &Mo {
        &self.model
    }

    /// The rule for the gain.
    pub fn gain(&self) -> &Gain<N, M> {
        self.errors.gain_rule()
    }

    /// The order reduction, if any.
    pub fn reduction(&self) -> Option<(Reduction, usize)> {
        self.errors.reduction()
    }

    fn read(&self, y: &[f64]) -> Result<SVector<f64, M>, EstimatorError> {
        check_size("output", M, y.len())?;
        check_finite("output", y)?;
        Ok(SVector::from_column_slice(y))
    }

    /// The common part of the three calls: `input` `None` for an update alone, `output` `None` for a prediction.
    fn advance(&mut self, input: Option<&Mo::Input>, output: Option<&[f64]>) -> Result<(), EstimatorError> {
        let y = output.map(|y| self.read(y)).transpose()?;
        let x = self.estimate;
        let mut next = input.map_or(x, |u| self.model.transition(&x, u));
        let a = input.map_or(SMatrix::identity(), |u| self.model.transition_jacobian(&x, u));
        self.errors.begin()?;
        self.errors.translate(&-x)?;
        let mut gain = None;
        let mut closed = a;
        if let Some(y) = y {
            let c = self.model.output_jacobian(&x);
            let l = self.errors.gain(&a, &c, &self.q_v, input.is_some())?;
            next += l * self.model.innovation(&x, &y);
            closed -= l * c;
            gain = Some(l);
        }
        check_finite("estimate", next.as_slice())?;
        self.errors.map(&closed)?;
        if let Some(u) = input {
            let d = self.model.noise_jacobian(&x, u);
            self.errors.add_process(|j| d * SVector::from_column_slice(self.process.col(j)))?;
        }
        if let Some(l) = gain {
            self.errors.add_output(|j| -l * SVector::from_column_slice(self.noise.col(j)))?;
        }
        self.errors.translate(&next)?;
        self.errors.commit();
        self.estimate = next;
        Ok(())
    }
}

impl<Mo: Model<N, M, W>, const N: usize, const M: usize, const W: usize> Estimator for Zsmf<Mo, N, M, W> {
    type Input = Mo::Input;
    type Output = [f64];
    type Set = Zonotope;

    fn predict(&mut self, input: &Mo::Input) -> Result<(), EstimatorError> {
        self.advance(Some(input), None)
    }

    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        self.advance(None, Some(output))
    }

    fn step(&mut self, input: &Mo::Input, output: &[f64]) -> Result<(), EstimatorError> {
        self.advance(Some(input), Some(output))
    }

    fn enclosure(&self) -> &Zonotope {
        self.errors.set()
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::FirstOrder
    }
}
