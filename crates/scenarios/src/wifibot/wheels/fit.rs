//! Scale and lever arm by least squares from the reference, and the Cramer-Rao bound of the scale from fixes.

use estimators::kalman::wheels::{WheelState, WheelStep};
use lie_groups::{LieGroup, SE2, SO2};
use nalgebra::{Matrix2, Matrix2x3, Matrix2x6, Matrix3, Matrix6, SMatrix, Vector2, Vector3};

use crate::ScenarioError;
use crate::vehicle::Pose;
use crate::wifibot::odometry::{Course, Window, element};

/// The lever arm that is added to the reference with its own heading, m: where the receiver is thought to be.
pub const ADDED_LEVER_M: [f64; 2] = [0.5, 0.3];

/// What the reference says of a log.
///
/// Over a window the reference point moves by `s d + (R - I) l` in the frame of its start, with `d` the displacement by the wheels, `R` the turn
/// and `l` the lever arm of the reference point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Scale `s` of the wheels.
    pub scale: f64,
    /// Lever arm `l` of the reference point from the middle of the axle, m.
    pub lever: Vector2<f64>,
    /// Root mean squares over the windows of what is left: turn (rad), displacement along and across (m).
    pub residuals: [f64; 3],
}

impl Fit {
    /// The least-squares fit.
    ///
    /// # Errors
    /// [`ScenarioError::Setting`] for a course without turns, which says nothing of the lever arm.
    pub fn new(course: &Course) -> Result<Self, ScenarioError> {
        let fit = least_squares(equations(course)).ok_or(ScenarioError::Setting {
            name: "course",
            expected: "one with turns",
            value: f64::from(course.number),
        })?;
        let mut squares = Vector3::zeros();
        for ((rows, moved), window) in equations(course).zip(&course.windows) {
            let rest = moved - rows * fit;
            squares += Vector3::new(window.error[0], rest[0], rest[1]).map(|x| x * x);
        }
        let residuals = squares.map(|square: f64| (square / course.windows.len() as f64).sqrt());
        Ok(Self { scale: fit[0], lever: Vector2::new(fit[1], fit[2]), residuals: residuals.into() })
    }

    /// The true state at a reference pose, the added lever arm included.
    #[must_use]
    pub fn state(&self, pose: &Pose) -> WheelState {
        let lever = self.lever + Vector2::from(ADDED_LEVER_M);
        let start = WheelState::new(pose.heading_rad, self.scale, Vector2::from(pose.position), lever);
        WheelState { position: start.position - start.heading.act(&self.lever), ..start }
    }

    /// Least standard deviation of an unbiased estimate of the scale from fixes of `fix_m` at the start and after every window, first
    /// heading, scale, position and lever arm unknown, the increments exact.
    ///
    /// # Errors
    /// [`ScenarioError::Setting`] for a course that does not tell them apart.
    pub fn bound(&self, course: &Course, fix_m: f64) -> Result<f64, ScenarioError> {
        let start = self.state(&course.start);
        let (mut turn, mut way) = (SO2::identity(), Vector2::zeros());
        let mut information = Matrix6::zeros();
        let mut add = |turn: &SO2<f64>, way: &Vector2<f64>| {
            // y = x + R(theta) (s D + Q l) with the dead-reckoned way D and turn Q.
            let r = start.heading.act_linear();
            let arm = r * (way * start.scale + turn.act(&start.lever));
            let mut rows = Matrix2x6::zeros();
            rows.set_column(0, &Vector2::new(-arm[1], arm[0]));
            rows.set_column(1, &(r * way));
            rows.fixed_view_mut::<2, 2>(0, 2).copy_from(&Matrix2::identity());
            rows.fixed_view_mut::<2, 2>(0, 4).copy_from(&(r * turn.act_linear()));
            information += rows.transpose() * rows;
        };
        add(&turn, &way);
        for window in &course.windows {
            let step = increment(window);
            way += turn.act(&step.shift);
            turn = turn.compose(&SO2::from_angle(step.turn_rad));
            add(&turn, &way);
        }
        let unknown =
            ScenarioError::Setting { name: "course", expected: "one with turns", value: course.number.into() };
        let covariance: SMatrix<f64, 6, 6> = information.cholesky().ok_or(unknown)?.inverse();
        Ok(fix_m * covariance[(1, 1)].sqrt())
    }
}

/// The increment of a window as the filters get it.
#[must_use]
pub fn increment(window: &Window) -> WheelStep {
    let [turn, forward, left] = window.motion;
    WheelStep::new(turn, Vector2::new(forward, left))
}

/// The equations of the fit, window by window.
fn equations(course: &Course) -> impl Iterator<Item = Equation> {
    let starts = std::iter::once(&course.start).chain(course.windows.iter().map(|window| &window.end));
    starts.zip(&course.windows).map(|(start, window)| {
        let [_, d1, d2] = window.motion;
        equation([d1, d2], start, &window.end)
    })
}

/// Coefficients of `(s, l)` and what they amount to.
pub type Equation = (Matrix2x3<f64>, Vector2<f64>);

/// `s d + (R - I) l` is the displacement of the reference point from one pose to another.
#[must_use]
pub fn equation(d: [f64; 2], from: &Pose, to: &Pose) -> Equation {
    let moved: SE2<f64> = element(from).inverse().compose(&element(to));
    let swing = moved.act_linear() - Matrix2::identity();
    let rows = Matrix2x3::new(d[0], swing[(0, 0)], swing[(0, 1)], d[1], swing[(1, 0)], swing[(1, 1)]);
    (rows, moved.translation())
}

/// The `(s, l)` of least squares; none if the equations do not tell them apart.
pub fn least_squares(equations: impl Iterator<Item = Equation>) -> Option<Vector3<f64>> {
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (rows, moved) in equations {
        normal += rows.transpose() * rows;
        right += rows.transpose() * moved;
    }
    normal.cholesky().map(|factor| factor.solve(&right))
}
