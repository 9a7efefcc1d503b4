//! The settings of plant and filters, and what is looked at.

use rand_chacha::ChaCha8Rng;

use super::filters::{ESTIMATE, Kind, filter};
use super::plant::{Bearing, simulate};
use crate::ScenarioError;
use crate::contest::{Arena, Contestant, Noise, Truth, Watch};

/// Steps of a run, 520 s: errors grow with the range, so the paper's Table 2 says how long its runs were, to about 5 %.
pub const STEPS: usize = 1040;
/// Steps at which half widths are shown.
pub const MARKS: [usize; 5] = [1, 10, 100, 500, 1000];

/// Half widths beyond this, m or m/s, are a divergence.
const LIMIT: f64 = 1e4;
/// Containment in sets of thousands of generators is looked at now and then.
const STRIDE: usize = 20;

/// A setting of plant and filters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// What stands for the bearing.
    pub bearing: Bearing,
    /// Noises.
    pub noise: Noise,
    /// Number of steps.
    pub steps: usize,
    /// Initial estimate.
    pub estimate: [f64; 4],
}

impl Setting {
    /// The settings that fit the paper's tables.
    #[must_use]
    pub fn fitted(noise: Noise) -> Self {
        Self { bearing: Bearing::Atan, noise, steps: STEPS, estimate: ESTIMATE }
    }
}

impl Arena<4, 2> for Setting {
    const NAME: &'static str = "vehicle-polar";
    type Kind = Kind;

    fn simulate(&self, rng: &mut ChaCha8Rng) -> Result<Truth<4, 2>, ScenarioError> {
        simulate(self.bearing, self.noise, self.steps, rng)
    }

    fn start(&self, kind: Kind) -> Result<Box<dyn Contestant<4>>, ScenarioError> {
        filter(kind, self.bearing, self.estimate)
    }

    fn watch(&self) -> Watch<'static> {
        Watch { late: 0, marks: &MARKS, limit: LIMIT, stride: STRIDE, bounded: self.noise.is_bounded() }
    }
}
