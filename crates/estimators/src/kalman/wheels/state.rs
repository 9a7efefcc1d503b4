//! [`WheelState`] and [`WheelStep`]: what is estimated, and what drives it.

use lie_groups::{LieGroup, SO2};
use nalgebra::{Matrix2, Vector2};

use crate::EstimatorError;
use crate::error::check_finite;

/// State of a wheeled robot with unknown wheel radius and antenna: `(R, s, x, X)` of paper 002, in its own variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelState {
    /// Heading `R`.
    pub heading: SO2<f64>,
    /// Way of the robot over way of its wheels, `s`. Some filters let it become negative.
    pub scale: f64,
    /// Position `x` of the middle of the axle, m.
    pub position: Vector2<f64>,
    /// Position `X` of the antenna in the frame of the robot, m.
    pub lever: Vector2<f64>,
}

/// What gyro and wheels say of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelStep {
    /// Turn `Omega`, rad.
    pub turn_rad: f64,
    /// Displacement `U` by the wheels, in the frame of the robot at the start of the step.
    pub shift: Vector2<f64>,
}

impl WheelStep {
    /// A turn (rad) and a displacement.
    #[must_use]
    pub fn new(turn_rad: f64, shift: Vector2<f64>) -> Self {
        Self { turn_rad, shift }
    }

    /// The turn as a rotation.
    pub(super) fn turn(&self) -> SO2<f64> {
        SO2::from_angle(self.turn_rad)
    }

    pub(super) fn check(&self) -> Result<(), EstimatorError> {
        check_finite("turn", &[self.turn_rad])?;
        check_finite("displacement", self.shift.as_slice())
    }
}

impl WheelState {
    /// The state with a heading (rad), a scale, a position and a lever arm (m).
    #[must_use]
    pub fn new(heading_rad: f64, scale: f64, position: Vector2<f64>, lever: Vector2<f64>) -> Self {
        Self { heading: SO2::from_angle(heading_rad), scale, position, lever }
    }

    /// The state after a step, (6): `(R Omega, s, x + s R U, X)`.
    ///
    /// **Source:** paper 002, (6).
    #[must_use]
    pub fn moved(&self, step: &WheelStep) -> Self {
        Self {
            heading: self.heading.compose(&step.turn()),
            position: self.position + self.heading.act(&step.shift) * self.scale,
            ..*self
        }
    }

    /// Where the antenna is, (7): `x + R X`, m.
    #[must_use]
    pub fn antenna(&self) -> Vector2<f64> {
        self.position + self.heading.act(&self.lever)
    }

    /// Heading in `(-pi, pi]`, rad.
    #[must_use]
    pub fn heading_rad(&self) -> f64 {
        let unit = self.heading.unit();
        unit.im.atan2(unit.re)
    }

    /// The matrix `R`.
    pub(super) fn rotation(&self) -> Matrix2<f64> {
        self.heading.act_linear()
    }

    pub(super) fn check(&self) -> Result<(), EstimatorError> {
        let unit = self.heading.unit();
        check_finite("heading", &[unit.re, unit.im])?;
        check_finite("scale", &[self.scale])?;
        check_finite("position", self.position.as_slice())?;
        check_finite("lever arm", self.lever.as_slice())
    }
}

/// A quarter turn to the left, the paper's `J`.
pub(super) fn quarter(v: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v[1], v[0])
}
