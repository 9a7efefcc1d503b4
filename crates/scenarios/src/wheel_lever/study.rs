//! Runs of the filters: errors, bounds and convergence.

use estimators::kalman::wheels::WheelState;
use rand_chacha::ChaCha8Rng;

use super::filters::{Follower, Method};
use super::setting::{Drive, STEPS_PER_FIX, Setting};
use crate::metrics::wrap_angle;
use crate::{Context, ScenarioError, monte_carlo};

/// From here on a heading error must stay within its bound, s.
pub const SETTLED_S: usize = 20;
/// A heading within this at the end is right, degrees.
pub const CLOSE_DEG: f64 = 10.0;
/// The bound: so many standard deviations.
pub const ENVELOPE: f64 = 3.0;

/// A filter after a fix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Error of the heading in `(-pi, pi]`, rad.
    pub heading_rad: f64,
    /// Its standard deviation as the filter says, rad.
    pub heading_sd: f64,
    /// Estimated scale.
    pub scale: f64,
    /// Standard deviation of the scale, as the filter says.
    pub scale_sd: f64,
    /// Errors of scale, position (m) and lever arm (m): absolute values.
    pub errors: [f64; 3],
    /// Normalised estimation error squared.
    pub nees: f64,
}

impl Sample {
    /// A filter beside the truth.
    ///
    /// # Errors
    /// Those of the filter.
    pub fn of(filter: &dyn Follower, truth: &WheelState) -> Result<Self, ScenarioError> {
        let (state, deviations) = (filter.state(), filter.deviations());
        Ok(Self {
            heading_rad: wrap_angle(truth.heading_rad() - state.heading_rad()),
            heading_sd: deviations[0],
            scale: state.scale,
            scale_sd: deviations[1],
            errors: [
                (truth.scale - state.scale).abs(),
                (truth.position - state.position).norm(),
                (truth.lever - state.lever).norm(),
            ],
            nees: filter.nees(truth)?,
        })
    }

    /// Whether the heading error is within the bound.
    #[must_use]
    pub fn within(&self) -> bool {
        self.heading_rad.abs() <= ENVELOPE * self.heading_sd
    }
}

/// A filter along a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// After each fix; the first is that of second 1.
    pub samples: Vec<Sample>,
    /// Whether the heading error stayed within its bound from [`SETTLED_S`] on, at every step: the paper's convergence.
    pub convergent: bool,
    /// Least scale of any step.
    pub least_scale: f64,
}

impl Track {
    /// Whether the last heading is right.
    #[must_use]
    pub fn close(&self) -> bool {
        self.samples.last().is_some_and(|last| last.heading_rad.abs() <= CLOSE_DEG.to_radians())
    }

    /// Whether the last scale is negative.
    #[must_use]
    pub fn reversed(&self) -> bool {
        self.samples.last().is_some_and(|last| last.scale < 0.0)
    }

    /// Mean of the normalised errors from [`SETTLED_S`] on.
    #[must_use]
    pub fn mean_nees(&self) -> f64 {
        let late = self.samples.get(SETTLED_S - 1..).unwrap_or_default();
        late.iter().map(|sample| sample.nees).sum::<f64>() / late.len() as f64
    }
}

/// Runs of all filters in one setting.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The setting.
    pub setting: Setting,
    /// Standard deviation of the first heading, degrees.
    pub heading_deg: f64,
    /// Tracks by run, then in the order of [`Method::ALL`].
    pub runs: Vec<[Track; 3]>,
}

impl Cell {
    /// The tracks of a filter in the first `most` runs.
    pub fn tracks(&self, method: Method, most: usize) -> impl Iterator<Item = &Track> + Clone {
        self.runs.iter().take(most).map(move |tracks| &tracks[method as usize])
    }
}

/// Runs all filters `runs` times, on the same noises.
///
/// # Errors
/// Those of the filters.
pub fn cell(context: &Context<'_>, setting: &Setting, heading_deg: f64, runs: usize) -> Result<Cell, ScenarioError> {
    let name = format!("wheel-lever/{}/{heading_deg}", setting.name);
    let runs = monte_carlo::run(context, &name, runs, |_, rng: &mut ChaCha8Rng| {
        let drive = setting.drive(heading_deg, rng);
        let [a, b, c] = Method::ALL.map(|method| track(setting, method, &drive));
        Ok::<_, ScenarioError>([a?, b?, c?])
    })?;
    Ok(Cell { setting: *setting, heading_deg, runs })
}

fn track(setting: &Setting, method: Method, drive: &Drive) -> Result<Track, ScenarioError> {
    let mut filter = setting.start(method, drive)?;
    let mut track = Track { samples: Vec::with_capacity(drive.seconds.len()), convergent: true, least_scale: 1.0 };
    for (index, second) in drive.seconds.iter().enumerate() {
        for (k, (step, truth)) in second.steps.iter().zip(&second.truths).enumerate() {
            filter.predict(step)?;
            if k + 1 == STEPS_PER_FIX {
                filter.update(second.fix)?;
                let sample = Sample::of(&*filter, truth)?;
                track.convergent &= index + 1 < SETTLED_S || sample.within();
                track.samples.push(sample);
            } else if index >= SETTLED_S {
                let error = wrap_angle(truth.heading_rad() - filter.state().heading_rad());
                track.convergent &= error.abs() <= ENVELOPE * filter.deviations()[0];
            }
            track.least_scale = track.least_scale.min(filter.state().scale);
        }
    }
    Ok(track)
}
