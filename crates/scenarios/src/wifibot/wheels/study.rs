//! Runs of the filters along the logs.

use std::f64::consts::PI;

use estimators::kalman::wheels::WheelState;
use nalgebra::{Vector2, Vector6};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::fit::{Fit, increment};
use crate::data::wifibot::Sample as Line;
use crate::noise::standard_normal;
use crate::wheel_lever::filters::{Method, Noises};
use crate::wheel_lever::study::{SETTLED_S, Sample, Track};
use crate::wifibot::odometry::{Course, Rule};
use crate::{Context, ScenarioError, monte_carlo};

/// Standard deviations of the fixes, m.
pub const FIXES_M: [f64; 2] = [1.0, 0.05];
/// First standard deviations of heading (rad; uniform over a turn), scale, position (m) and lever arm (m).
pub const SPREADS: [f64; 4] = [1.81, 0.2, 3.0, 1.0];
/// The process noises are this many times what the increments miss of the reference on average.
pub const SAFETY: f64 = 2.0;

/// A log in one reading with fixes of one quality.
#[derive(Clone, Debug)]
pub struct Case {
    /// Which interval speeds belong to.
    pub rule: Rule,
    /// Standard deviation of the fixes, m.
    pub fix_m: f64,
    /// What the reference says of scale and lever arm.
    pub fit: Fit,
    /// Least standard deviation of the scale, Cramer-Rao.
    pub bound: f64,
    /// Tracks by run, then in the order of [`Method::ALL`].
    pub runs: Vec<[Track; 3]>,
}

impl Case {
    /// The tracks of a filter.
    pub fn tracks(&self, method: Method) -> impl Iterator<Item = &Track> + Clone {
        self.runs.iter().map(move |tracks| &tracks[method as usize])
    }
}

/// All cases of a log.
#[derive(Clone, Debug)]
pub struct Study {
    /// Number of the log.
    pub number: u32,
    /// Its cases: both readings, fixes as in [`FIXES_M`] each.
    pub cases: Vec<Case>,
}

impl Study {
    /// Runs all filters with `runs` draws of noise and first heading, the same for all cases.
    ///
    /// # Errors
    /// Those of course, fit and filters.
    pub fn new(context: &Context<'_>, number: u32, lines: &[Line], runs: usize) -> Result<Self, ScenarioError> {
        let mut cases = Vec::new();
        for rule in Rule::ALL {
            let course = Course::read(number, lines, rule)?;
            let fit = Fit::new(&course)?;
            for fix_m in FIXES_M {
                let runs = monte_carlo::run(context, &format!("wifibot{number}-wheels"), runs, |_, rng| {
                    let [a, b, c] = tracks(&course, &fit, fix_m, rng);
                    Ok::<_, ScenarioError>([a?, b?, c?])
                })?;
                cases.push(Case { rule, fix_m, fit, bound: fit.bound(&course, fix_m)?, runs });
            }
        }
        Ok(Self { number, cases })
    }
}

fn tracks(course: &Course, fit: &Fit, fix_m: f64, rng: &mut ChaCha8Rng) -> [Result<Track, ScenarioError>; 3] {
    let heading_rad = PI * (2.0 * rng.random::<f64>() - 1.0);
    let mut fix = |truth: &WheelState| -> [f64; 2] {
        (truth.antenna() + Vector2::new(standard_normal(rng), standard_normal(rng)) * fix_m).into()
    };
    let first = fix(&fit.state(&course.start));
    let truths: Vec<WheelState> = course.windows.iter().map(|window| fit.state(&window.end)).collect();
    let fixes: Vec<[f64; 2]> = truths.iter().map(&mut fix).collect();
    let guess = WheelState::new(heading_rad, 1.0, Vector2::from(first), Vector2::zeros());
    Method::ALL.map(|method| {
        let [heading, s, x, l] = SPREADS;
        let noises = Noises { step: fit.residuals.map(|rest| SAFETY * rest), fix_m };
        let mut filter = method.start(guess, &Vector6::new(heading, s, x, x, l, l), &noises)?;
        filter.update(first)?;
        let mut track = Track { samples: Vec::with_capacity(truths.len()), convergent: true, least_scale: 1.0 };
        for ((window, truth), fix) in course.windows.iter().zip(&truths).zip(&fixes) {
            filter.predict(&increment(window))?;
            filter.update(*fix)?;
            let sample = Sample::of(&*filter, truth)?;
            track.convergent &= track.samples.len() + 1 < SETTLED_S || sample.within();
            track.least_scale = track.least_scale.min(sample.scale);
            track.samples.push(sample);
        }
        Ok(track)
    })
}
