//! One-second increments of wheel odometry, and how far they are from the reference.
//!
//! Speed and rate of a sample are those of the interval that ends with it ([`Rule::Ends`]): in the logs speed times interval is smooth, the
//! speed alone jumps with the length of the interval. (Read as those of the interval that begins, [`Rule::Begins`], the wheels would seem 5 %
//! off; they are off by half a per cent.)
//!
//! The state moves by `X_{k+1} = X_k D_k exp(w_k)`: `D_k` composes the small motions of the samples of a window, and
//! `w_k = log(D_k^-1 X_k^-1 X_{k+1})` is what the reference says they missed. The bounds on `w_k` are the worst of the whole log, each
//! component times [`SAFETY`]; so they hold on this log by construction and promise nothing about another.

use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;

use crate::ScenarioError;
use crate::data::LogError;
use crate::data::wifibot::Sample;
use crate::metrics::wrap_angle;
use crate::vehicle::Pose;

/// Length of a window, s; the next sample at or after it ends the window.
pub const WINDOW_S: f64 = 1.0;
/// The bounds are this many times the worst error of the log.
pub const SAFETY: f64 = 1.2;

/// Which interval speed and rate of a sample belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The one that ends with the sample.
    Ends,
    /// The one that begins with it.
    Begins,
}

impl Rule {
    /// Both rules.
    pub const ALL: [Self; 2] = [Self::Ends, Self::Begins];

    /// The name in the rows.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ends => "speed of the interval before",
            Self::Begins => "speed of the interval after",
        }
    }

    /// Of two samples in turn, the one whose speed and rate belong to the interval between them.
    #[must_use]
    pub fn read<'a>(self, before: &'a Sample, after: &'a Sample) -> &'a Sample {
        match self {
            Self::Ends => after,
            Self::Begins => before,
        }
    }
}

/// One window of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Turn (rad) and displacement in the body frame of the start (m), from odometry.
    pub motion: [f64; 3],
    /// The same as a tangent vector: `log D_k`.
    pub increment: Vector3<f64>,
    /// `w_k`, the error of the increment in the body frame of its end: rad, m, m.
    pub error: Vector3<f64>,
    /// Reference pose at the end.
    pub end: Pose,
}

/// A log cut into windows.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Number of the log.
    pub number: u32,
    /// Reference pose at the start.
    pub start: Pose,
    /// The windows, in order.
    pub windows: Vec<Window>,
}

impl Course {
    /// Cuts a log; what is left after the last full window is not used.
    ///
    /// # Errors
    /// [`LogError::TooShort`] for a log without a full window, [`ScenarioError::Group`] if an increment is off by half a turn.
    pub fn new(number: u32, samples: &[Sample]) -> Result<Self, ScenarioError> {
        Self::read(number, samples, Rule::Ends)
    }

    /// [`new`](Self::new) with a rule for the speeds.
    ///
    /// # Errors
    /// Those of `new`.
    pub fn read(number: u32, samples: &[Sample], rule: Rule) -> Result<Self, ScenarioError> {
        let too_short = || {
            let source = LogError::TooShort { found: samples.len(), needed: 1 + (WINDOW_S * 50.0) as usize };
            ScenarioError::Log { path: format!("wifibot{number}").into(), source }
        };
        let first = samples.first().ok_or_else(too_short)?;
        let mut windows: Vec<Window> = Vec::new();
        let mut start = 0;
        for (index, sample) in samples.iter().enumerate().skip(1) {
            if sample.time_s >= first.time_s + WINDOW_S * (windows.len() + 1) as f64 {
                windows.push(Window::new(&samples[start..=index], rule)?);
                start = index;
            }
        }
        if windows.is_empty() {
            return Err(too_short());
        }
        Ok(Self { number, start: reference(first), windows })
    }

    /// The worst error of the increments, component by component: rad, m, m.
    #[must_use]
    pub fn worst(&self) -> [f64; 3] {
        let worst = self.windows.iter().fold(Vector3::zeros(), |worst: Vector3<f64>, w| worst.sup(&w.error.abs()));
        worst.into()
    }

    /// The bounds on the errors of the increments: [`SAFETY`] times the worst.
    #[must_use]
    pub fn bounds(&self) -> [f64; 3] {
        self.worst().map(|worst| SAFETY * worst)
    }
}

impl Window {
    fn new(samples: &[Sample], rule: Rule) -> Result<Self, ScenarioError> {
        let (start, end) = (&samples[0], &samples[samples.len() - 1]);
        let mut motion = SE2::identity();
        let mut turn = 0.0;
        for pair in samples.windows(2) {
            let (previous, sample) = (&pair[0], &pair[1]);
            let period_s = sample.time_s - previous.time_s;
            let read = rule.read(previous, sample);
            let small = period_s * Vector3::new(read.gyro_rad_s, read.forward_m_s, read.lateral_m_s);
            motion = motion.compose(&SE2::exp(&small));
            turn += small[0];
        }
        let moved = element(&reference(start)).inverse().compose(&element(&reference(end)));
        let shift = motion.translation();
        Ok(Self {
            motion: [turn, shift[0], shift[1]],
            increment: motion.log()?,
            error: motion.inverse().compose(&moved).log()?,
            end: reference(end),
        })
    }
}

/// The reference of a sample.
fn reference(sample: &Sample) -> Pose {
    Pose { heading_rad: wrap_angle(sample.heading_rad), position: sample.position_m }
}

/// A pose on the group.
#[must_use]
pub fn element(pose: &Pose) -> SE2<f64> {
    SE2::from_pose(pose.heading_rad, pose.position[0], pose.position[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of a drive on a circle at 50 Hz; odometry with a scale error.
    fn drive(seconds: usize, scale: f64) -> Vec<Sample> {
        let sample = |k: usize| {
            let time_s = 0.02 * k as f64;
            let pose = SE2::exp(&Vector3::new(0.3 * time_s, 0.2 * time_s, 0.0));
            let position = pose.translation();
            Sample {
                time_s: 5.0 + time_s,
                gyro_rad_s: 0.3 * scale,
                forward_m_s: 0.2 * scale,
                lateral_m_s: 0.0,
                heading_rad: 0.3 * time_s,
                position_m: position.into(),
            }
        };
        (0..=50 * seconds + 7).map(sample).collect()
    }

    #[test]
    fn exact_odometry_has_no_error() {
        let course = Course::new(9, &drive(12, 1.0)).unwrap();
        assert_eq!(course.windows.len(), 12);
        assert!(course.worst().iter().all(|&worst| worst < 1e-12), "{:?}", course.worst());
    }

    /// A scale error of 5 % shows as 5 % of the motion of a second.
    #[test]
    fn a_scale_error_shows_in_the_bounds() {
        let course = Course::new(9, &drive(12, 1.05)).unwrap();
        let [turn, forward, _] = course.bounds();
        assert!((turn / SAFETY - 0.015).abs() < 3e-4 * 1.05, "{turn}");
        assert!((forward / SAFETY - 0.010).abs() < 4e-4, "{forward}");
    }

    /// The increments followed by their errors lead along the reference.
    #[test]
    fn increments_and_errors_close_the_course() {
        let course = Course::new(9, &drive(7, 0.9)).unwrap();
        let mut state = element(&course.start);
        for window in &course.windows {
            state = state.compose(&SE2::exp(&window.increment)).compose(&SE2::exp(&window.error));
            let miss = element(&window.end).inverse().compose(&state).log().unwrap();
            assert!(miss.norm() < 1e-12);
        }
    }

    #[test]
    fn a_log_without_a_full_window_is_an_error() {
        let samples = &drive(1, 1.0)[..40];
        assert!(matches!(Course::new(9, samples), Err(ScenarioError::Log { .. })));
        assert!(matches!(Course::new(9, &[]), Err(ScenarioError::Log { .. })));
    }
}
