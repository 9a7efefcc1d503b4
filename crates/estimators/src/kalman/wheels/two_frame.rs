//! [`TwoFrameError`]: the error of paper 002, which moves as a function of itself.

use lie_groups::{LieGroup, RPlus, ScaledSO2, TfgScaleLever2};
use nalgebra::{Matrix2, Matrix2x6, Matrix6, Matrix6x3, Vector2, Vector6};

use super::model::{WheelError, blocks};
use super::state::{WheelState, WheelStep, quarter};
use crate::EstimatorError;
use crate::kalman::Chart;

/// The error of the TFG-IEKF: the logarithm of the left-invariant error of `(R, s, x, X' = X / s)` on the two-frame group with scale, written
/// in the variables of [`WheelState`].
///
/// ```text
/// error: log of E = (Rhat' R, s / shat, Rhat'(x - xhat) / shat, (X - R' Rhat Xhat) / s)                (27)
/// update, (e_R, e_s, e_x, e_X) = exp(K Z): (R e_R, s e_s, x + s R e_x, s e_s e_X + e_R' X)             (29)
/// A: x <- O'(x + J U theta + U s)                G: theta <- n_theta, x <- O' n_U, X <- (J Xhat / shat) n_theta
/// Z = Rhat'(y - xhat - Rhat Xhat) / shat         H = [0, 0, I, I],  N = Rhat' / shat
/// ```
///
/// with `O` the turn of the step. `A` and `H` do not depend on the estimate, and `A` is exact for errors of any size. The scale is multiplied by
/// `e_s > 0`: it stays positive. States whose scale is not positive are refused.
///
/// **Source:** paper 002, (27), (29), (35).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TwoFrameError;

impl Chart<6> for TwoFrameError {
    type Point = WheelState;
    const FLAT: bool = false;

    fn shift(point: &WheelState, xi: &Vector6<f64>) -> WheelState {
        let e = TfgScaleLever2::exp(xi);
        let (turn, growth) = (e.frame().rotation(), e.frame().scaling().scale());
        WheelState {
            heading: point.heading.compose(&turn),
            scale: point.scale * growth,
            position: point.position + point.heading.act(&e.fixed()[0]) * point.scale,
            lever: e.body()[0] * (point.scale * growth) + turn.inverse().act(&point.lever),
        }
    }

    fn difference(state: &WheelState, point: &WheelState) -> Result<Vector6<f64>, EstimatorError> {
        let back = point.heading.inverse();
        let turn = back.compose(&state.heading);
        let position = back.act(&(state.position - point.position)) / point.scale;
        let lever = (state.lever - turn.inverse().act(&point.lever)) / state.scale;
        let frame = ScaledSO2::new(turn, RPlus::from_scale(state.scale / point.scale)?);
        Ok(TfgScaleLever2::new(frame, [position], [lever]).log()?)
    }

    fn transport(shift: &Vector6<f64>) -> Matrix6<f64> {
        TfgScaleLever2::jr(shift)
    }

    fn check(point: &WheelState) -> Result<(), EstimatorError> {
        point.check()?;
        if point.scale > 0.0 {
            Ok(())
        } else {
            Err(EstimatorError::NotPositive { what: "scale", index: 0, value: point.scale })
        }
    }
}

impl WheelError for TwoFrameError {
    fn jacobians(state: &WheelState, step: &WheelStep) -> (Matrix6<f64>, Matrix6x3<f64>) {
        let back = step.turn().inverse().act_linear();
        let mut a = blocks(&back, &Matrix2::identity());
        a.fixed_view_mut::<2, 1>(2, 0).copy_from(&(back * quarter(&step.shift)));
        a.fixed_view_mut::<2, 1>(2, 1).copy_from(&(back * step.shift));
        let mut g = Matrix6x3::zeros();
        g[(0, 0)] = 1.0;
        g.fixed_view_mut::<2, 2>(2, 1).copy_from(&back);
        g.fixed_view_mut::<2, 1>(4, 0).copy_from(&(quarter(&state.lever) / state.scale));
        (a, g)
    }

    fn innovation_jacobian(_: &WheelState) -> Matrix2x6<f64> {
        let mut h = Matrix2x6::zeros();
        h.fixed_view_mut::<2, 2>(0, 2).copy_from(&Matrix2::identity());
        h.fixed_view_mut::<2, 2>(0, 4).copy_from(&Matrix2::identity());
        h
    }

    fn frame(state: &WheelState) -> Matrix2<f64> {
        state.rotation() * state.scale
    }

    fn innovation(state: &WheelState, y: &Vector2<f64>) -> Vector2<f64> {
        (state.heading.inverse().act(&(y - state.position)) - state.lever) / state.scale
    }

    fn from_plain(state: &WheelState) -> Matrix6<f64> {
        let inverse = 1.0 / state.scale;
        let mut m = blocks(&(state.rotation().transpose() * inverse), &(Matrix2::identity() * inverse));
        m[(1, 1)] = inverse;
        m.fixed_view_mut::<2, 1>(4, 0).copy_from(&(quarter(&state.lever) * inverse));
        m
    }

    fn to_plain(state: &WheelState) -> Matrix6<f64> {
        let mut m = blocks(&(state.rotation() * state.scale), &(Matrix2::identity() * state.scale));
        m[(1, 1)] = state.scale;
        m.fixed_view_mut::<2, 1>(4, 0).copy_from(&-quarter(&state.lever));
        m
    }
}
