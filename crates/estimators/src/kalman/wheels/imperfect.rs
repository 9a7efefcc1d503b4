//! [`ImperfectError`]: invariant where it can be, plain differences for the rest.

use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix2, Matrix2x6, Matrix6, Matrix6x3, Vector2, Vector3, Vector6};

use super::model::{WheelError, blocks};
use super::state::{WheelState, WheelStep, quarter};
use crate::EstimatorError;
use crate::kalman::Chart;

/// The error of the imperfect invariant filter: left-invariant on SE(2) for heading and position, `s - shat` and `X - Xhat` beside it;
/// that is, the left-invariant error on the product group SE(2) x R x R^2.
///
/// ```text
/// error: (theta, s, V(0, theta)^-1 Rhat'(x - xhat), X - Xhat)
/// A: x <- O'(x + shat J U theta + U s)            G: theta <- n_theta, x <- shat O' n_U
/// Z = Rhat'(y - xhat - Rhat Xhat)                 H = [J Xhat, 0, I, I],  N = Rhat'
/// ```
///
/// with `O` the turn of the step. `A`, `G` and `H` depend on the estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ImperfectError;

/// Heading and position as a pose.
fn pose(state: &WheelState) -> SE2<f64> {
    SE2::new(state.heading, &state.position)
}

/// The coordinates of the pose among the six.
fn of_pose(e: &Vector6<f64>) -> Vector3<f64> {
    Vector3::new(e[0], e[2], e[3])
}

impl Chart<6> for ImperfectError {
    type Point = WheelState;
    const FLAT: bool = false;

    fn shift(point: &WheelState, e: &Vector6<f64>) -> WheelState {
        let pose = pose(point).compose(&SE2::exp(&of_pose(e)));
        WheelState {
            heading: pose.rotation(),
            scale: point.scale + e[1],
            position: pose.translation(),
            lever: point.lever + e.fixed_rows::<2>(4),
        }
    }

    fn difference(state: &WheelState, point: &WheelState) -> Result<Vector6<f64>, EstimatorError> {
        let motion = pose(point).inverse().compose(&pose(state)).log()?;
        let l = state.lever - point.lever;
        Ok(Vector6::new(motion[0], state.scale - point.scale, motion[1], motion[2], l[0], l[1]))
    }

    fn transport(shift: &Vector6<f64>) -> Matrix6<f64> {
        let jr = SE2::jr(&of_pose(shift));
        let mut m = blocks(&jr.fixed_view::<2, 2>(1, 1).into(), &Matrix2::identity());
        m.fixed_view_mut::<2, 1>(2, 0).copy_from(&jr.fixed_view::<2, 1>(1, 0));
        m
    }

    fn check(point: &WheelState) -> Result<(), EstimatorError> {
        point.check()
    }
}

impl WheelError for ImperfectError {
    fn jacobians(state: &WheelState, step: &WheelStep) -> (Matrix6<f64>, Matrix6x3<f64>) {
        let back = step.turn().inverse().act_linear();
        let mut a = blocks(&back, &Matrix2::identity());
        a.fixed_view_mut::<2, 1>(2, 0).copy_from(&(back * quarter(&step.shift) * state.scale));
        a.fixed_view_mut::<2, 1>(2, 1).copy_from(&(back * step.shift));
        let mut g = Matrix6x3::zeros();
        g[(0, 0)] = 1.0;
        g.fixed_view_mut::<2, 2>(2, 1).copy_from(&(back * state.scale));
        (a, g)
    }

    fn innovation_jacobian(state: &WheelState) -> Matrix2x6<f64> {
        let mut h = Matrix2x6::zeros();
        h.set_column(0, &quarter(&state.lever));
        h.fixed_view_mut::<2, 2>(0, 2).copy_from(&Matrix2::identity());
        h.fixed_view_mut::<2, 2>(0, 4).copy_from(&Matrix2::identity());
        h
    }

    fn frame(state: &WheelState) -> Matrix2<f64> {
        state.rotation()
    }

    fn innovation(state: &WheelState, y: &Vector2<f64>) -> Vector2<f64> {
        state.heading.inverse().act(&(y - state.position)) - state.lever
    }

    fn from_plain(state: &WheelState) -> Matrix6<f64> {
        blocks(&state.rotation().transpose(), &Matrix2::identity())
    }

    fn to_plain(state: &WheelState) -> Matrix6<f64> {
        blocks(&state.rotation(), &Matrix2::identity())
    }
}
