//! [`PlainError`]: differences of the variables.

use lie_groups::LieGroup;
use nalgebra::{Matrix2, Matrix2x6, Matrix6, Matrix6x3, Vector1, Vector2, Vector6};

use super::model::{WheelError, blocks};
use super::state::{WheelState, WheelStep, quarter};
use crate::EstimatorError;
use crate::kalman::Chart;

/// The error of the extended Kalman filter: `(theta - thetahat in (-pi, pi], s - shat, x - xhat, X - Xhat)`.
///
/// ```text
/// A: x <- x + shat Rhat J U theta + Rhat U s      G: theta <- n_theta, x <- shat Rhat n_U
/// Z = y - xhat - Rhat Xhat                        H = [Rhat J Xhat, 0, I, Rhat],  N = I
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlainError;

impl Chart<6> for PlainError {
    type Point = WheelState;
    // Headings are not averaged.
    const FLAT: bool = false;

    fn shift(point: &WheelState, e: &Vector6<f64>) -> WheelState {
        WheelState {
            heading: point.heading.compose(&LieGroup::exp(&Vector1::new(e[0]))),
            scale: point.scale + e[1],
            position: point.position + e.fixed_rows::<2>(2),
            lever: point.lever + e.fixed_rows::<2>(4),
        }
    }

    fn difference(state: &WheelState, point: &WheelState) -> Result<Vector6<f64>, EstimatorError> {
        let turn = point.heading.inverse().compose(&state.heading).log()?;
        let (x, l) = (state.position - point.position, state.lever - point.lever);
        Ok(Vector6::new(turn[0], state.scale - point.scale, x[0], x[1], l[0], l[1]))
    }

    fn transport(_: &Vector6<f64>) -> Matrix6<f64> {
        Matrix6::identity()
    }

    fn check(point: &WheelState) -> Result<(), EstimatorError> {
        point.check()
    }
}

impl WheelError for PlainError {
    fn jacobians(state: &WheelState, step: &WheelStep) -> (Matrix6<f64>, Matrix6x3<f64>) {
        let (r, moved) = (state.rotation(), state.heading.act(&step.shift));
        let mut a = Matrix6::identity();
        a.fixed_view_mut::<2, 1>(2, 0).copy_from(&(quarter(&moved) * state.scale));
        a.fixed_view_mut::<2, 1>(2, 1).copy_from(&moved);
        let mut g = Matrix6x3::zeros();
        g[(0, 0)] = 1.0;
        g.fixed_view_mut::<2, 2>(2, 1).copy_from(&(r * state.scale));
        (a, g)
    }

    fn innovation_jacobian(state: &WheelState) -> Matrix2x6<f64> {
        let mut h = Matrix2x6::zeros();
        h.set_column(0, &quarter(&state.heading.act(&state.lever)));
        h.fixed_view_mut::<2, 2>(0, 2).copy_from(&Matrix2::identity());
        h.fixed_view_mut::<2, 2>(0, 4).copy_from(&state.rotation());
        h
    }

    fn frame(_: &WheelState) -> Matrix2<f64> {
        Matrix2::identity()
    }

    fn innovation(state: &WheelState, y: &Vector2<f64>) -> Vector2<f64> {
        y - state.antenna()
    }

    fn from_plain(_: &WheelState) -> Matrix6<f64> {
        blocks(&Matrix2::identity(), &Matrix2::identity())
    }

    fn to_plain(_: &WheelState) -> Matrix6<f64> {
        blocks(&Matrix2::identity(), &Matrix2::identity())
    }
}
