//! What a Kalman filter asks of a model: a motion and a sensor, and their derivatives where it linearises.

use nalgebra::{SMatrix, SVector};

use super::chart::Chart;
use crate::EstimatorError;

/// How the state moves over a step: `x+ = f(x, u, w)` with `W` noises of mean 0.
pub trait Motion<C: Chart<N>, const N: usize, const W: usize> {
    /// What drives the model over a step.
    type Input: ?Sized;

    /// `f(x, u, w)`.
    fn transition(&self, x: &C::Point, u: &Self::Input, w: &SVector<f64, W>) -> C::Point;

    /// `Ok` if the sizes of the model fit; called when a filter is made and before it uses the model, which may have been replaced.
    ///
    /// # Errors
    /// [`EstimatorError::Size`].
    fn check(&self) -> Result<(), EstimatorError> {
        Ok(())
    }

    /// `Ok` if the input can be used.
    ///
    /// # Errors
    /// [`EstimatorError::Size`], [`EstimatorError::NotFinite`].
    fn check_input(&self, _: &Self::Input) -> Result<(), EstimatorError> {
        Ok(())
    }
}

/// A motion with derivatives.
pub trait SmoothMotion<C: Chart<N>, const N: usize, const W: usize>: Motion<C, N, W> {
    /// `(A, B)` at `w = 0`, shapes `N x N` and `N x W`: the error of `f(x, u, w)` is `A e + B w` to first order, `e` that of `x`, both in
    /// the coordinates of the chart.
    fn motion_jacobians(&self, x: &C::Point, u: &Self::Input) -> (SMatrix<f64, N, N>, SMatrix<f64, N, W>);
}

/// What is measured: `M` outputs `y = h(x, v)` with `V` noises of mean 0.
pub trait Sensor<C: Chart<N>, const N: usize, const M: usize, const V: usize> {
    /// `h(x, v)`.
    fn output(&self, x: &C::Point, v: &SVector<f64, V>) -> SVector<f64, M>;

    /// `y - yhat`; to be overridden where outputs are angles, so that a difference of `2 pi` is none.
    fn residual(&self, y: &SVector<f64, M>, predicted: &SVector<f64, M>) -> SVector<f64, M> {
        y - predicted
    }

    /// `Ok` if the sizes of the model fit; called when a filter is made and before it uses the model, which may have been replaced.
    ///
    /// # Errors
    /// [`EstimatorError::Size`].
    fn check(&self) -> Result<(), EstimatorError> {
        Ok(())
    }
}

/// A sensor with derivatives.
pub trait SmoothSensor<C: Chart<N>, const N: usize, const M: usize, const V: usize>: Sensor<C, N, M, V> {
    /// `(H, D)` at `v = 0`, shapes `M x N` and `M x V`: `h(x, v)` changes by `H e + D v` to first order, `e` in the coordinates of the
    /// chart around `x`.
    fn output_jacobians(&self, x: &C::Point) -> (SMatrix<f64, M, N>, SMatrix<f64, M, V>);
}

/// A pair is a model: a motion, then a sensor.
impl<C: Chart<N>, A: Motion<C, N, W>, B, const N: usize, const W: usize> Motion<C, N, W> for (A, B) {
    type Input = A::Input;
    fn transition(&self, x: &C::Point, u: &A::Input, w: &SVector<f64, W>) -> C::Point {
        self.0.transition(x, u, w)
    }
    fn check(&self) -> Result<(), EstimatorError> {
        self.0.check()
    }
    fn check_input(&self, u: &A::Input) -> Result<(), EstimatorError> {
        self.0.check_input(u)
    }
}

impl<C: Chart<N>, A: SmoothMotion<C, N, W>, B, const N: usize, const W: usize> SmoothMotion<C, N, W> for (A, B) {
    fn motion_jacobians(&self, x: &C::Point, u: &A::Input) -> (SMatrix<f64, N, N>, SMatrix<f64, N, W>) {
        self.0.motion_jacobians(x, u)
    }
}

impl<C: Chart<N>, A, B, const N: usize, const M: usize, const V: usize> Sensor<C, N, M, V> for (A, B)
where
    B: Sensor<C, N, M, V>,
{
    fn output(&self, x: &C::Point, v: &SVector<f64, V>) -> SVector<f64, M> {
        self.1.output(x, v)
    }
    fn residual(&self, y: &SVector<f64, M>, predicted: &SVector<f64, M>) -> SVector<f64, M> {
        self.1.residual(y, predicted)
    }
    fn check(&self) -> Result<(), EstimatorError> {
        self.1.check()
    }
}

impl<C: Chart<N>, A, B, const N: usize, const M: usize, const V: usize> SmoothSensor<C, N, M, V> for (A, B)
where
    B: SmoothSensor<C, N, M, V>,
{
    fn output_jacobians(&self, x: &C::Point) -> (SMatrix<f64, M, N>, SMatrix<f64, M, V>) {
        self.1.output_jacobians(x)
    }
}
