//! A log cut into windows of one second: odometry increments, the reference, and how far apart they are.

use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;

use crate::ScenarioError;
use crate::data::wifibot::Sample;
use crate::vehicle::Pose;

/// Length of a window, s; position fixes come at its ends.
pub const WINDOW_S: f64 = 1.0;

/// Bounds on the increments' errors are the log's own worst times this.
pub const SAFETY: f64 = 1.2;

/// A drive in windows: `X_{i+1} = X_i exp(xi_i) exp(w_i)` on SE(2), with `w_i` within [`bounds`](Self::bounds).
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Times of the window ends from the first one on, s.
    pub times_s: Vec<f64>,
    /// Reference poses at those times.
    pub reference: Vec<Pose>,
    /// Odometry increments `xi_i = (theta [rad], forward [m], lateral [m])`, one fewer than times.
    pub increments: Vec<Vector3<f64>>,
    /// Bounds on `|w_i|` by component: [`SAFETY`] times the largest over the log.
    pub bounds: [f64; 3],
}

impl Drive {
    /// Cuts a log. Odometry is integrated on the group, sample by sample, each rate held until the next sample.
    ///
    /// # Errors
    /// [`ScenarioError::Setting`] for a log shorter than two windows, [`ScenarioError::Group`] if odometry and reference differ by half a turn
    /// within a window.
    pub fn from_log(samples: &[Sample]) -> Result<Self, ScenarioError> {
        let mut drive =
            Self { times_s: Vec::new(), reference: Vec::new(), increments: Vec::new(), bounds: [0.0; 3] };
        let mut motion = SE2::identity();
        let mut window_end = f64::NEG_INFINITY;
        for (k, sample) in samples.iter().enumerate() {
            if sample.time_s >= window_end {
                if k > 0 {
                    drive.increments.push(motion.log()?);
                    motion = SE2::identity();
                }
                drive.times_s.push(sample.time_s - samples[0].time_s);
                drive.reference.push(Pose { heading_rad: sample.heading_rad, position: sample.position_m });
                window_end = sample.time_s + WINDOW_S;
            }
            if let Some(next) = samples.get(k + 1) {
                let dt_s = next.time_s - sample.time_s;
                let rates = Vector3::new(sample.gyro_rad_s, sample.forward_m_s, sample.lateral_m_s);
                motion = motion.compose(&SE2::exp(&(dt_s * rates)));
            }
        }
        if drive.increments.len() < 2 {
            let value = drive.times_s.last().copied().unwrap_or_default();
            return Err(ScenarioError::Setting { name: "length of the log [s]", expected: "two windows or more", value });
        }
        for error in drive.increment_errors()? {
            for (bound, e) in drive.bounds.iter_mut().zip(error.iter()) {
                *bound = bound.max(SAFETY * e.abs());
            }
        }
        Ok(drive)
    }

    /// `w_i = log(exp(-xi_i) X_i^-1 X_{i+1})` of every window, from the reference poses.
    fn increment_errors(&self) -> Result<Vec<Vector3<f64>>, ScenarioError> {
        let pose = |pose: &Pose| SE2::from_pose(pose.heading_rad, pose.position[0], pose.position[1]);
        let windows = self.reference.windows(2).zip(&self.increments);
        let errors = windows.map(|(ends, xi)| {
            let moved = pose(&ends[0]).inverse().compose(&pose(&ends[1]));
            SE2::exp(&-xi).compose(&moved).log()
        });
        Ok(errors.collect::<Result<_, _>>()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A circle driven exactly: constant rates, reference from the exact solution.
    fn circle(seconds: usize) -> Vec<Sample> {
        let at = |k: usize| {
            let time_s = 0.02 * k as f64;
            let pose = SE2::exp(&(time_s * Vector3::new(0.4, 0.2, 0.0)));
            Sample {
                time_s: 3.0 + time_s,
                gyro_rad_s: 0.4,
                forward_m_s: 0.2,
                lateral_m_s: 0.0,
                heading_rad: 0.4 * time_s,
                position_m: pose.translation().into(),
            }
        };
        (0..=50 * seconds).map(at).collect()
    }

    #[test]
    fn an_exact_circle_has_exact_increments() {
        let drive = Drive::from_log(&circle(10)).unwrap();
        assert_eq!((drive.times_s.len(), drive.increments.len()), (drive.reference.len(), drive.reference.len() - 1));
        assert!((9..=10).contains(&drive.increments.len()));
        assert!(drive.bounds.iter().all(|&bound| bound < 1e-12), "{:?}", drive.bounds);
        let first = drive.increments[0];
        assert!((first[0] - 0.4).abs() < 0.01 && (first[1] - 0.2).abs() < 0.01);
    }

    /// A wheel radius 5 % too large shows in the forward bound, with the safety factor.
    #[test]
    fn a_scale_error_becomes_the_bound() {
        let mut samples = circle(10);
        for sample in &mut samples {
            sample.forward_m_s *= 1.05;
        }
        let drive = Drive::from_log(&samples).unwrap();
        assert!((drive.bounds[1] / (SAFETY * 0.05 * 0.2 * WINDOW_S) - 1.0).abs() < 0.05, "{:?}", drive.bounds);
    }

    #[test]
    fn a_log_of_one_window_is_refused() {
        assert!(matches!(Drive::from_log(&circle(1)), Err(ScenarioError::Setting { .. })));
    }
}
