//! Robot logs as Problem 3: increments of a window of time, an unknown wheel scale, and an antenna arm that is added to the reference.
//!
//! The logs have no scale of their own, so "the scale" `s` is the least-squares one, together with the arm `l` of the reference's marker, which
//! is 2 cm off the point that the wheels move: `p = x + R(theta) l`. For the displacements `m_k` of the marker in the body frame
//!
//! ```text
//! m_k = s (U_k + n_k) + (e^{i dtheta_k} - 1) l
//! ```
//!
//! is linear in `(s, l)`. Where speed and rate are taken for the interval that begins with a sample ([`Rule::Begins`]), wheels and gyro alike seem 4 to 5 %
//! off; the gain of the gyro is calibrated then, by least squares, and only the scale of the wheels is left to find. The true state is `x = p - R l`, the true arm `l` and what is added to it. The noises are what is left, and the bounds are
//! 1.2 times their worst: by construction the reference with these constants keeps them.

use scalars::Interval;

use crate::ScenarioError;
use crate::data::wifibot::Sample;
use crate::guaranteed_invariant::lever::{Bounds, Constants, Increment, LeverTruth, fix, noise_between, prove};
use crate::guaranteed_invariant::robot_spans::Span;
use crate::metrics::wrap_angle;
use crate::truth::Exact;
use crate::vehicle::{Pose, TruePose};
use crate::wifibot::odometry::{Rule, SAFETY};
use crate::wifibot::wheels::fit;

/// A log as increments and reference poses.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// Number of the log.
    pub number: u32,
    /// Length of a window, s.
    pub window_s: f64,
    /// Reference poses of the point that the wheels move, headings not wrapped.
    pub states: Vec<TruePose>,
    /// Measured increments between them.
    pub increments: Vec<Increment>,
    /// What the turns of the gyro are multiplied by.
    pub gyro_gain: f64,
    /// The least-squares scale.
    pub scale: f64,
    /// The arm of the reference's marker, m.
    pub marker_m: [f64; 2],
}

impl Log {
    /// Cuts a log into windows; what is left after the last full window is not used.
    ///
    /// # Errors
    /// [`ScenarioError::Setting`] for a log without turns, which does not tell the scale and the marker's arm apart.
    pub fn new(number: u32, samples: &[Sample], rule: Rule, window_s: f64) -> Result<Self, ScenarioError> {
        let (mut markers, mut increments) = cut(samples, rule, window_s, 1.0);
        let gyro_gain = if rule == Rule::Ends { 1.0 } else { gain(&markers, &increments) };
        if gyro_gain != 1.0 {
            (markers, increments) = cut(samples, rule, window_s, gyro_gain);
        }
        let pairs = markers.windows(2).zip(&increments);
        let equations = pairs.map(|(pair, increment)| fit::equation(increment.shift_m, &pair[0], &pair[1]));
        let constants = fit::least_squares(equations).ok_or(ScenarioError::Setting {
            name: "log",
            expected: "one with turns",
            value: number.into(),
        })?;
        let [scale, l1, l2] = constants.into();
        let states = markers.iter().map(|pose| moved_by_wheels(pose, [l1, l2])).collect();
        Ok(Self { number, window_s, states, increments, gyro_gain, scale, marker_m: [l1, l2] })
    }

    /// The worst noises of the windows `0..windows`: rad, m, m.
    #[must_use]
    pub fn worst(&self, windows: usize) -> [f64; 3] {
        let noises = self.noises().take(windows);
        noises.fold([0.0; 3], |worst, noise| std::array::from_fn(|k| worst[k].max(noise[k].mag())))
    }

    /// Bounds `factor` times the worst of the windows `0..windows`, and `fix_m` on the fixes.
    #[must_use]
    pub fn bounds(&self, factor: f64, windows: usize, fix_m: f64) -> Bounds {
        let [turn_rad, along, across] = self.worst(windows).map(|worst| factor * worst);
        Bounds { turn_rad, shift_m: [along, across], fix_m }
    }

    /// The bounds that hold over the whole log by construction.
    #[must_use]
    pub fn stated_bounds(&self, fix_m: f64) -> Bounds {
        self.bounds(SAFETY, self.increments.len(), fix_m)
    }

    fn noises(&self) -> impl Iterator<Item = [Interval; 3]> {
        let steps = self.states.windows(2).zip(&self.increments);
        steps.map(|(pair, increment)| noise_between(&pair[0], &pair[1], increment, self.scale))
    }

    /// The scales for which the reference keeps the bounds on the displacements, over windows and spans: what no filter that is told these bounds
    /// can be narrower than, even with perfect fixes and headings. None if there is none.
    #[must_use]
    pub fn admissible_scales(&self, bounds: &Bounds, spans: &[Span]) -> Option<[f64; 2]> {
        let (mut lo, mut hi) = (0.0_f64, f64::INFINITY);
        // With n = m / s - u: |n| <= b says 1/s in [(u - b) / m, (u + b) / m].
        let mut add = |[m, u, b]: [f64; 3]| {
            if m != 0.0 {
                let (a, c) = ((u - b) / m, (u + b) / m);
                (lo, hi) = (lo.max(a.min(c)), hi.min(a.max(c)));
            }
        };
        for (noise, increment) in self.noises().zip(&self.increments) {
            for k in 0..2 {
                let (u, b) = (increment.shift_m[k], bounds.shift_m[k]);
                add([(noise[k + 1].mid() + u) * self.scale, u, b]);
            }
        }
        spans.iter().flat_map(|span| span.chords(self)).flatten().for_each(add);
        (0.0 < lo && lo <= hi).then(|| [1.0 / hi, 1.0 / lo])
    }

    /// The log as a run of Problem 3 with an arm added to the marker's by the reference heading, and noises `draw` on the fixes, one a window.
    ///
    /// With `proven`, every step is proven to keep the bounds; without, the truth is whatever it is.
    ///
    /// # Errors
    /// [`ScenarioError::Truth`] if a step or a fix cannot be proven.
    pub fn run(
        &self,
        added_m: [f64; 2],
        bounds: &Bounds,
        proven: bool,
        mut draw: impl FnMut() -> [f64; 2],
    ) -> Result<LeverTruth, ScenarioError> {
        let arm_m = [self.marker_m[0] + added_m[0], self.marker_m[1] + added_m[1]];
        let constants = Constants { scale: self.scale, arm_m };
        for (step, (pair, increment)) in self.states.windows(2).zip(&self.increments).enumerate() {
            if proven {
                prove(&pair[0], &pair[1], increment, self.scale, bounds, step)?;
            }
        }
        let mut fixes = Vec::with_capacity(self.increments.len());
        for (step, state) in self.states.iter().enumerate().skip(1) {
            fixes.push((step, fix(state, &constants, draw(), bounds.fix_m, step)?));
        }
        Ok(LeverTruth { constants, states: self.states.clone(), increments: self.increments.clone(), fixes })
    }
}

/// Poses of the marker, a window apart, and the increments between them.
fn cut(samples: &[Sample], rule: Rule, window_s: f64, gyro_gain: f64) -> (Vec<Pose>, Vec<Increment>) {
    let (mut markers, mut increments): (Vec<Pose>, Vec<Increment>) = Default::default();
    let mut start = 0;
    for (index, sample) in samples.iter().enumerate() {
        let due = samples[0].time_s + window_s * markers.len() as f64;
        if sample.time_s >= due {
            let moved = increment(&samples[start..=index], rule, gyro_gain);
            markers.push(marker(markers.last(), moved.turn_rad, sample));
            if markers.len() > 1 {
                increments.push(moved);
            }
            start = index;
        }
    }
    (markers, increments)
}

/// The least-squares gain of the gyro; 1 without turns.
fn gain(markers: &[Pose], increments: &[Increment]) -> f64 {
    let turns = markers.windows(2).zip(increments);
    let (product, square) = turns.fold((0.0, 0.0), |(product, square), (pair, increment)| {
        let turn = increment.turn_rad;
        (product + turn * (pair[1].heading_rad - pair[0].heading_rad), square + turn * turn)
    });
    if square > 0.0 { product / square } else { 1.0 }
}

/// The reference of a sample; of its headings modulo a turn the one nearest to that of the pose before and the measured turn.
fn marker(before: Option<&Pose>, turn_rad: f64, sample: &Sample) -> Pose {
    let expected = before.map_or(0.0, |before| before.heading_rad + turn_rad);
    Pose { heading_rad: expected + wrap_angle(sample.heading_rad - expected), position: sample.position_m }
}

/// The state whose marker on the arm `l` is at a pose; exact by definition.
fn moved_by_wheels(marker: &Pose, l: [f64; 2]) -> TruePose {
    let (sin, cos) = marker.heading_rad.sin_cos();
    let position = [marker.position[0] - (cos * l[0] - sin * l[1]), marker.position[1] - (sin * l[0] + cos * l[1])];
    TruePose { heading: Exact::new(marker.heading_rad), ..TruePose::new(Pose { position, ..*marker }) }
}

/// The motion of the wheels over a window, composed sample by sample.
fn increment(samples: &[Sample], rule: Rule, gyro_gain: f64) -> Increment {
    let (mut turn_rad, mut shift_m) = (0.0_f64, [0.0_f64; 2]);
    for pair in samples.windows(2) {
        let speeds = rule.read(&pair[0], &pair[1]);
        let period_s = pair[1].time_s - pair[0].time_s;
        let turned = gyro_gain * period_s * speeds.gyro_rad_s;
        // The chord of the arc points along the mean heading; its length differs from the arc's by turned^2 / 24, 1e-6 of it here.
        let (sin, cos) = (turn_rad + 0.5 * turned).sin_cos();
        let (along, across) = (period_s * speeds.forward_m_s, period_s * speeds.lateral_m_s);
        shift_m = [shift_m[0] + cos * along - sin * across, shift_m[1] + sin * along + cos * across];
        turn_rad += turned;
    }
    Increment { turn_rad, shift_m }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The marker of the test's robot, m.
    const MARKER_M: [f64; 2] = [0.02, -0.01];

    /// Samples of a drive at 50 Hz along an S; the wheels see the speed divided by `scale`, with a slow error.
    fn drive(seconds: usize, scale: f64) -> Vec<Sample> {
        let (mut heading_rad, mut axle) = (0.0_f64, [0.0_f64; 2]);
        let mut samples = Vec::new();
        for k in 0..=50 * seconds + 7 {
            let time_s = 0.02 * k as f64;
            let gyro_rad_s = 0.3 * (0.2 * time_s).cos();
            if k > 0 {
                let (sin, cos) = (heading_rad + 0.01 * gyro_rad_s).sin_cos();
                axle = [axle[0] + 0.01 * cos, axle[1] + 0.01 * sin];
                heading_rad += 0.02 * gyro_rad_s;
            }
            let (sin, cos) = heading_rad.sin_cos();
            let [l1, l2] = MARKER_M;
            samples.push(Sample {
                time_s,
                gyro_rad_s,
                forward_m_s: 0.5 / scale + 0.004 * (0.1 * time_s).sin(),
                lateral_m_s: 0.0,
                heading_rad,
                position_m: [axle[0] + cos * l1 - sin * l2, axle[1] + sin * l1 + cos * l2],
            });
        }
        samples
    }

    fn log(window_s: f64) -> Log {
        Log::new(9, &drive(60, 0.95), Rule::Ends, window_s).unwrap()
    }

    /// Scale and marker are found; what the marker's arm does is no noise of the wheels.
    #[test]
    fn the_constants_are_found() {
        let log = log(1.0);
        assert_eq!((log.states.len(), log.increments.len()), (61, 60));
        assert!((log.scale - 0.95).abs() < 4e-3, "{}", log.scale);
        let [l1, l2] = log.marker_m;
        assert!((l1 - MARKER_M[0]).abs() < 2e-3 && (l2 - MARKER_M[1]).abs() < 2e-3, "{l1}, {l2}");
        let [_, along, across] = log.worst(60);
        assert!(along < 6e-3 && across < 1e-3, "{along}, {across}");
        let straight: Vec<Sample> =
            drive(60, 1.0).iter().map(|s| Sample { heading_rad: 0.0, gyro_rad_s: 0.0, ..*s }).collect();
        assert!(matches!(Log::new(9, &straight, Rule::Ends, 1.0), Err(ScenarioError::Setting { .. })));
    }

    /// A gyro that sees too much is calibrated where the rule asks for it.
    #[test]
    fn the_gain_of_the_gyro_is_found() {
        let fast: Vec<Sample> =
            drive(60, 0.95).iter().map(|s| Sample { gyro_rad_s: s.gyro_rad_s / 0.96, ..*s }).collect();
        let log = Log::new(9, &fast, Rule::Begins, 1.0).unwrap();
        assert!((log.gyro_gain - 0.96).abs() < 1e-3 && log.worst(60)[0] < 2e-3, "{}", log.gyro_gain);
        let log = Log::new(9, &fast, Rule::Ends, 1.0).unwrap();
        assert!(log.gyro_gain == 1.0 && log.worst(60)[0] > 0.01);
    }

    /// Long windows turn as far as they turn.
    #[test]
    fn long_windows_count_their_turns() {
        let log = log(15.0);
        let [turn, ..] = log.worst(log.increments.len());
        assert!(turn < 1e-9 && log.increments.len() == 4, "{turn}");
    }

    /// The stated bounds hold by construction; half of them do not.
    #[test]
    fn stated_bounds_are_proven() {
        let log = log(1.0);
        let truth = log.run([0.5, 0.3], &log.stated_bounds(0.05), true, || [0.05 - 1e-9, 0.0]).unwrap();
        assert_eq!(truth.fixes.len(), 60);
        assert_eq!(truth.constants.arm_m, [log.marker_m[0] + 0.5, log.marker_m[1] + 0.3]);
        let half = log.bounds(0.5 * SAFETY, 60, 0.05);
        assert!(log.run([0.5, 0.3], &half, true, || [0.0; 2]).is_err());
    }

    /// The admissible scales hold the least-squares one, and their width is about twice the bound on the speed.
    #[test]
    fn admissible_scales_follow_from_the_bound() {
        let log = log(1.0);
        let bounds = Bounds { turn_rad: 1.0, shift_m: [0.01, 0.1], fix_m: 1.0 };
        let [lo, hi] = log.admissible_scales(&bounds, &[]).unwrap();
        assert!(lo < log.scale && log.scale < hi);
        assert!(hi - lo < 2.0 * 0.95 * 0.01 / 0.5 && hi - lo > 0.5 * 2.0 * 0.95 * 0.01 / 0.5, "{}", hi - lo);
        // Ten seconds with five times the bound of one: half the width.
        let mut span = Span::new(&log, 10, SAFETY);
        span.chord_m = [0.05, 0.1];
        let [lo, hi] = log.admissible_scales(&bounds, &[span]).unwrap();
        assert!(lo < log.scale && log.scale < hi && hi - lo < 2.2 * 0.95 * 0.05 / 5.0, "{}", hi - lo);
    }
}
