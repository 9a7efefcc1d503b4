//! Robot logs as Problem 3: increments of a window of time, an unknown wheel scale, and an antenna arm that is added to the reference.
//!
//! The logs have no scale of their own, so "the scale" is the least-squares one: `s = sum <U_k, m_k> / sum |U_k|^2` for the displacements
//! `m_k` of the reference in the body frame. The noises are what is left, `n_k = m_k / s - U_k`, and the bounds are 1.2 times
//! their worst: by construction the reference with this scale keeps them.

use scalars::Interval;

use crate::ScenarioError;
use crate::data::wifibot::Sample;
use crate::guaranteed_invariant::lever::{Bounds, Constants, Increment, LeverTruth, fix, noise_between, prove};
use crate::metrics::wrap_angle;
use crate::truth::Exact;
use crate::vehicle::{Pose, TruePose};
use crate::wifibot::odometry::SAFETY;

/// Which interval the speed and the rate of a sample belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpeedRule {
    /// The interval that ends with the sample (what the logs mean: see [`crate::wifibot::odometry`]).
    Ends,
    /// The interval that begins with it.
    Begins,
}

impl SpeedRule {
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
}

/// A log as increments and reference poses.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// Number of the log.
    pub number: u32,
    /// Length of a window, s.
    pub window_s: f64,
    /// Reference poses, headings not wrapped.
    pub states: Vec<TruePose>,
    /// Measured increments between them.
    pub increments: Vec<Increment>,
    /// The least-squares scale.
    pub scale: f64,
}

impl Log {
    /// Cuts a log into windows; what is left after the last full window is not used.
    #[must_use]
    pub fn new(number: u32, samples: &[Sample], rule: SpeedRule, window_s: f64) -> Self {
        let mut states: Vec<TruePose> = Vec::new();
        let mut increments = Vec::new();
        let mut start = 0;
        for (index, sample) in samples.iter().enumerate() {
            let due = samples[0].time_s + window_s * states.len() as f64;
            if sample.time_s >= due {
                let moved = increment(&samples[start..=index], rule);
                states.push(state(states.last(), moved.turn_rad, sample));
                if states.len() > 1 {
                    increments.push(moved);
                }
                start = index;
            }
        }
        let scale = least_squares_scale(&states, &increments);
        Self { number, window_s, states, increments, scale }
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

    /// The scales for which the reference keeps the bounds on the displacements: what no filter that is told these bounds can be narrower
    /// than, even with perfect fixes and headings. None if there is none.
    #[must_use]
    pub fn admissible_scales(&self, bounds: &Bounds) -> Option<[f64; 2]> {
        // With n = m / s - U: |n| <= b says 1/s in [(U - b) / m, (U + b) / m].
        let (mut lo, mut hi) = (0.0_f64, f64::INFINITY);
        for (noise, increment) in self.noises().zip(&self.increments) {
            for k in 0..2 {
                let (u, b) = (increment.shift_m[k], bounds.shift_m[k]);
                let moved = (noise[k + 1].mid() + u) * self.scale;
                if moved != 0.0 {
                    let (a, c) = ((u - b) / moved, (u + b) / moved);
                    (lo, hi) = (lo.max(a.min(c)), hi.min(a.max(c)));
                }
            }
        }
        (0.0 < lo && lo <= hi).then(|| [1.0 / hi, 1.0 / lo])
    }

    /// The log as a run of Problem 3 with an arm added by the reference heading and noises `draw` on the fixes, one a window.
    ///
    /// With `proven`, every step is proven to keep the bounds; without, the truth is whatever it is.
    ///
    /// # Errors
    /// [`ScenarioError::Truth`] if a step or a fix cannot be proven.
    pub fn run(
        &self,
        arm_m: [f64; 2],
        bounds: &Bounds,
        proven: bool,
        mut draw: impl FnMut() -> [f64; 2],
    ) -> Result<LeverTruth, ScenarioError> {
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

/// The reference of a sample; of its headings modulo a turn the one nearest to that of the state before and the measured turn.
fn state(before: Option<&TruePose>, turn_rad: f64, sample: &Sample) -> TruePose {
    let expected = before.map_or(0.0, |before| before.heading.value() + turn_rad);
    let heading_rad = expected + wrap_angle(sample.heading_rad - expected);
    TruePose { heading: Exact::new(heading_rad), ..TruePose::new(Pose { heading_rad, position: sample.position_m }) }
}

/// The motion of the wheels over a window, composed sample by sample.
fn increment(samples: &[Sample], rule: SpeedRule) -> Increment {
    let (mut turn_rad, mut shift_m) = (0.0_f64, [0.0_f64; 2]);
    for pair in samples.windows(2) {
        let speeds = if rule == SpeedRule::Ends { &pair[1] } else { &pair[0] };
        let period_s = pair[1].time_s - pair[0].time_s;
        let turned = period_s * speeds.gyro_rad_s;
        // The chord of the arc points along the mean heading; its length differs from the arc's by turned^2 / 24, 1e-6 of it here.
        let (sin, cos) = (turn_rad + 0.5 * turned).sin_cos();
        let (along, across) = (period_s * speeds.forward_m_s, period_s * speeds.lateral_m_s);
        shift_m = [shift_m[0] + cos * along - sin * across, shift_m[1] + sin * along + cos * across];
        turn_rad += turned;
    }
    Increment { turn_rad, shift_m }
}

fn least_squares_scale(states: &[TruePose], increments: &[Increment]) -> f64 {
    let (mut product, mut square) = (0.0, 0.0);
    for (pair, increment) in states.windows(2).zip(increments) {
        let moved = noise_between(&pair[0], &pair[1], &Increment { turn_rad: 0.0, shift_m: [0.0; 2] }, 1.0);
        let [u1, u2] = increment.shift_m;
        product += u1 * moved[1].mid() + u2 * moved[2].mid();
        square += u1 * u1 + u2 * u2;
    }
    product / square
}

#[cfg(test)]
mod tests {
    use crate::wifibot::odometry::SAFETY;

    use super::*;

    /// Samples of a drive at 50 Hz on a circle; the wheels see the speed divided by `scale`, with a slow error.
    fn drive(seconds: usize, scale: f64) -> Vec<Sample> {
        let sample = |k: usize| {
            let time_s = 0.02 * k as f64;
            let heading_rad = 0.3 * time_s;
            let radius_m = 0.5 / 0.3;
            Sample {
                time_s,
                gyro_rad_s: 0.3,
                forward_m_s: 0.5 / scale + 0.004 * (0.1 * time_s).sin(),
                lateral_m_s: 0.0,
                heading_rad,
                position_m: [radius_m * heading_rad.sin(), radius_m * (1.0 - heading_rad.cos())],
            }
        };
        (0..=50 * seconds + 7).map(sample).collect()
    }

    #[test]
    fn the_least_squares_scale_is_found() {
        let log = Log::new(9, &drive(60, 0.95), SpeedRule::Ends, 1.0);
        assert_eq!((log.states.len(), log.increments.len()), (61, 60));
        assert!((log.scale - 0.95).abs() < 4e-3, "{}", log.scale);
    }

    /// A window may turn by more than half a turn.
    #[test]
    fn long_windows_count_their_turns() {
        let log = Log::new(9, &drive(60, 0.95), SpeedRule::Ends, 15.0);
        let [turn, ..] = log.worst(log.increments.len());
        assert!(turn < 1e-9 && log.increments.len() == 4, "{turn}");
    }

    /// The stated bounds hold by construction; half of them do not.
    #[test]
    fn stated_bounds_are_proven() {
        let log = Log::new(9, &drive(60, 0.95), SpeedRule::Ends, 1.0);
        let truth = log.run([0.5, 0.3], &log.stated_bounds(0.05), true, || [0.05 - 1e-9, 0.0]).unwrap();
        assert_eq!(truth.fixes.len(), 60);
        let half = log.bounds(0.5 * SAFETY, 60, 0.05);
        assert!(log.run([0.5, 0.3], &half, true, || [0.0; 2]).is_err());
    }

    /// The admissible scales hold the least-squares one, and their width is about twice the bound on the speed.
    #[test]
    fn admissible_scales_follow_from_the_bound() {
        let log = Log::new(9, &drive(60, 0.95), SpeedRule::Ends, 1.0);
        let bounds = Bounds { turn_rad: 1.0, shift_m: [0.01, 0.1], fix_m: 1.0 };
        let [lo, hi] = log.admissible_scales(&bounds).unwrap();
        assert!(lo < log.scale && log.scale < hi);
        assert!(hi - lo < 2.0 * 0.95 * 0.01 / 0.5 && hi - lo > 0.5 * 2.0 * 0.95 * 0.01 / 0.5, "{}", hi - lo);
    }
}
