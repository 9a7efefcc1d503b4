//! The drive of paper 002, section VI-B, and what it leaves open.
//!
//! The robot drives on a circle at pi/25 rad/s for 50 s (one turn), then straight for 10 s, always at 5 m/s; increments come at 10 Hz, fixes
//! of the antenna at 1 Hz. The paper does not say the true lever arm, the first spreads but that of the heading, nor whether its noises
//! are rates (sd times the period) or densities (times its root): [`BEST`] is what came nearest to Table I, [`ALT`] another that does, [`VARIANTS`] are others.

use std::f64::consts::PI;

use estimators::kalman::wheels::{WheelState, WheelStep};
use nalgebra::{Vector2, Vector6};
use rand::Rng;

use super::filters::{Follower, Method, Noises};
use crate::ScenarioError;
use crate::noise::standard_normal;

/// Period of the increments, s.
pub const PERIOD_S: f64 = 0.1;
/// Increments between two fixes.
pub const STEPS_PER_FIX: usize = 10;
/// Length of a run, s.
pub const SECONDS: usize = 60;
/// End of the circle, s.
pub const CIRCLE_S: usize = 50;
/// Turn rate on the circle, rad/s.
pub const RATE_RAD_S: f64 = PI / 25.0;
/// Speed, m/s.
pub const SPEED_M_S: f64 = 5.0;
/// Standard deviations of the noises: gyro (rad/s), wheels (m/s), fix (m).
pub const SIGMAS: [f64; 3] = [0.05, 0.1, 1.0];

/// How the standard deviation of a rate becomes that of an increment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// Times the period.
    Rate,
    /// Times its root.
    Density,
}

/// What the paper leaves open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Label in the rows.
    pub name: &'static str,
    /// True lever arm, m; the estimate starts at 0.
    pub lever: [f64; 2],
    /// First standard deviations of scale, position (m) and lever arm (m).
    pub spread: [f64; 3],
    /// What the noises' standard deviations mean.
    pub reading: Reading,
    /// Whether there is a fix before the first step.
    pub fix_at_0: bool,
}

/// The setting that came nearest to Table I.
pub const BEST: Setting =
    Setting { name: "BEST", lever: [0.5, 0.0], spread: [0.5, 10.0, 20.0], reading: Reading::Rate, fix_at_0: false };
/// Another one.
pub const ALT: Setting = Setting { name: "ALT", lever: [5.0, 0.0], spread: [0.2, 3.0, 20.0], ..BEST };
/// Others.
pub const VARIANTS: [Setting; 5] = [
    Setting { name: "spread of X 1 m", spread: [0.5, 10.0, 1.0], ..BEST },
    Setting { name: "spread of s 0.1, x 1 m, X 1 m", spread: [0.1, 1.0, 1.0], ..BEST },
    Setting { name: "noise as density", reading: Reading::Density, ..BEST },
    Setting { name: "fix at 0 s", fix_at_0: true, ..BEST },
    Setting { name: "X = (5, 0), noise as density", reading: Reading::Density, ..ALT },
];

/// A second of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Second {
    /// What gyro and wheels say.
    pub steps: [WheelStep; STEPS_PER_FIX],
    /// True states after each step.
    pub truths: [WheelState; STEPS_PER_FIX],
    /// The fix at the end, m.
    pub fix: [f64; 2],
}

/// A simulated run.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// True first state.
    pub start: WheelState,
    /// The first estimate.
    pub guess: WheelState,
    /// Standard deviation of its heading, rad.
    pub heading_sd: f64,
    /// The fix before the first step, where there is one.
    pub first_fix: Option<[f64; 2]>,
    /// The rest.
    pub seconds: Vec<Second>,
}

impl Setting {
    /// Noises of an increment and of a fix.
    #[must_use]
    pub fn noises(&self) -> Noises {
        let factor = match self.reading {
            Reading::Rate => PERIOD_S,
            Reading::Density => PERIOD_S.sqrt(),
        };
        let [gyro, wheels, fix_m] = SIGMAS;
        Noises { step: [gyro * factor, wheels * factor, wheels * factor], fix_m }
    }

    /// Simulates a run whose first heading is off by a Gaussian of `heading_deg`; nothing else is drawn about the start.
    pub fn drive<R: Rng>(&self, heading_deg: f64, rng: &mut R) -> Drive {
        let noises = self.noises();
        let heading_sd = heading_deg.to_radians();
        let start = WheelState::new(0.0, 1.0, Vector2::zeros(), Vector2::from(self.lever));
        let guess = WheelState::new(heading_sd * standard_normal(rng), 1.0, start.position, Vector2::zeros());
        let fix = |state: &WheelState, rng: &mut R| -> [f64; 2] {
            let noise = Vector2::new(standard_normal(rng), standard_normal(rng)) * noises.fix_m;
            (state.antenna() + noise).into()
        };
        let first_fix = self.fix_at_0.then(|| fix(&start, rng));
        let mut truth = start;
        let seconds = (0..SECONDS).map(|second| {
            let rate = if second < CIRCLE_S { RATE_RAD_S } else { 0.0 };
            let step = WheelStep::new(rate * PERIOD_S, Vector2::new(SPEED_M_S * PERIOD_S, 0.0));
            let truths = std::array::from_fn(|_| {
                let [turn, along, across] = noises.step.map(|sd| sd * standard_normal(rng));
                truth = truth.moved(&WheelStep::new(step.turn_rad + turn, step.shift + Vector2::new(along, across)));
                truth
            });
            Second { steps: [step; STEPS_PER_FIX], truths, fix: fix(&truth, rng) }
        });
        let seconds = seconds.collect();
        Drive { start, guess, heading_sd, first_fix, seconds }
    }

    /// A filter at the start of a run.
    ///
    /// # Errors
    /// Those of the filter.
    pub fn start(&self, method: Method, drive: &Drive) -> Result<Box<dyn Follower>, ScenarioError> {
        let [s, x, l] = self.spread;
        let mut filter = method.start(drive.guess, &Vector6::new(drive.heading_sd, s, x, x, l, l), &self.noises())?;
        if let Some(fix) = drive.first_fix {
            filter.update(fix)?;
        }
        Ok(filter)
    }
}
