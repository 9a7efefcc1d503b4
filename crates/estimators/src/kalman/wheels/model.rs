//! [`Wheels`]: motion and sensor of Problem 3, for every [`WheelError`]; the filters made of them.

use nalgebra::{Matrix2, Matrix2x6, Matrix6, Matrix6x3, SMatrix, Vector2, Vector3, Vector6};

use super::imperfect::ImperfectError;
use super::plain::PlainError;
use super::state::{WheelState, WheelStep};
use super::two_frame::TwoFrameError;
use crate::EstimatorError;
use crate::error::check_finite;
use crate::kalman::{Chart, Ekf, Gaussian, Motion, Sensor, SmoothMotion, SmoothSensor};

/// An error of a [`WheelState`]: six coordinates in the order heading, scale, position, lever arm, and the Jacobians of the model in them.
///
/// The model's Jacobians by the usual letters of paper 002: `A` and `G` of the motion ([`jacobians`](Self::jacobians)), `H` and `N` of the
/// innovation `Z = N (y - yhat)` ([`innovation_jacobian`](Self::innovation_jacobian), [`frame`](Self::frame)`^-1`).
pub trait WheelError: Chart<6, Point = WheelState> {
    /// `(A, G)` of a step from `state`: the error after it is `A e + G (n_theta, n_U)` to first order.
    fn jacobians(state: &WheelState, step: &WheelStep) -> (Matrix6<f64>, Matrix6x3<f64>);

    /// `H`: the innovation of a measurement without noise is `Z = H e` to first order.
    fn innovation_jacobian(state: &WheelState) -> Matrix2x6<f64>;

    /// `N^-1 = D`: the frame of the innovation, `y - yhat = D Z`.
    fn frame(state: &WheelState) -> Matrix2<f64>;

    /// The innovation `Z = D^-1 (y - yhat)`.
    fn innovation(state: &WheelState, y: &Vector2<f64>) -> Vector2<f64>;

    /// Derivative of these coordinates by the plain ones: differences of heading (rad), scale, position and lever arm (m).
    fn from_plain(state: &WheelState) -> Matrix6<f64>;

    /// Derivative of the plain coordinates by these: the inverse of [`from_plain`](Self::from_plain).
    fn to_plain(state: &WheelState) -> Matrix6<f64>;

    /// A belief from standard deviations of heading (rad), scale, position and lever arm (m), without correlation.
    ///
    /// # Errors
    /// A state or a deviation that is not finite, a state that the chart does not have.
    fn belief(state: WheelState, deviations: &Vector6<f64>) -> Result<Gaussian<Self, 6>, EstimatorError> {
        Self::check(&state)?;
        check_finite("standard deviations", deviations.as_slice())?;
        Gaussian::from_root(state, &(Self::from_plain(&state) * SMatrix::from_diagonal(deviations)))
    }

    /// Standard deviations of heading (rad), scale, position and lever arm (m), to first order.
    fn deviations(belief: &Gaussian<Self, 6>) -> Vector6<f64> {
        let root = Self::to_plain(belief.mean()) * belief.root();
        Vector6::from_fn(|i, _| root.row(i).norm())
    }
}

/// The model of Problem 3 on [`WheelState`]; noises `(n_theta, n_U)` of a step (rad, units of the wheels), `v` of a fix (m).
///
/// **Source:** paper 002, (6) and (7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wheels;

/// The extended Kalman filter of Problem 3.
pub type WheelEkf = Ekf<Wheels, PlainError, 6, 2, 3, 2>;
/// The imperfect invariant extended Kalman filter of Problem 3.
pub type ImperfectIekf = Ekf<Wheels, ImperfectError, 6, 2, 3, 2>;
/// The filter of paper 002 for Problem 3. Its scale stays positive.
pub type TfgIekf = Ekf<Wheels, TwoFrameError, 6, 2, 3, 2>;

impl<C: WheelError> Motion<C, 6, 3> for Wheels {
    type Input = WheelStep;

    fn transition(&self, x: &WheelState, u: &WheelStep, w: &Vector3<f64>) -> WheelState {
        x.moved(&WheelStep::new(u.turn_rad + w[0], u.shift + w.fixed_rows::<2>(1)))
    }

    fn check_input(&self, u: &WheelStep) -> Result<(), EstimatorError> {
        u.check()
    }
}

impl<C: WheelError> SmoothMotion<C, 6, 3> for Wheels {
    fn motion_jacobians(&self, x: &WheelState, u: &WheelStep) -> (Matrix6<f64>, Matrix6x3<f64>) {
        C::jacobians(x, u)
    }
}

impl<C: WheelError> Sensor<C, 6, 2, 2> for Wheels {
    fn output(&self, x: &WheelState, v: &Vector2<f64>) -> Vector2<f64> {
        x.antenna() + v
    }
}

impl<C: WheelError> SmoothSensor<C, 6, 2, 2> for Wheels {
    fn output_jacobians(&self, x: &WheelState) -> (Matrix2x6<f64>, Matrix2<f64>) {
        (C::frame(x) * C::innovation_jacobian(x), Matrix2::identity())
    }
}

/// The block-diagonal matrix that leaves heading and scale as they are.
pub(super) fn blocks(position: &Matrix2<f64>, lever: &Matrix2<f64>) -> Matrix6<f64> {
    let mut m = Matrix6::identity();
    m.fixed_view_mut::<2, 2>(2, 2).copy_from(position);
    m.fixed_view_mut::<2, 2>(4, 4).copy_from(lever);
    m
}
