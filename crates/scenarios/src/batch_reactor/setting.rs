//! The settings of plant and filters, and what is looked at.

use rand_chacha::ChaCha8Rng;

use super::filters::{Kind, filter};
use super::plant::{Rates, simulate};
use crate::ScenarioError;
use crate::contest::{Arena, Contestant, Noise, Truth, Watch};

/// Steps of a run, 25 min: with the steps left out, the fit to all four entries of Table 1.
pub const STEPS: usize = 1500;
/// Steps left out of the root mean squares, 28 s.
pub const DROPPED: usize = 28;
/// Steps at which half widths are shown.
pub const MARKS: [usize; 7] = [1, 10, 30, 60, 120, 300, 1500];
/// Steps with rates per second.
pub const STEPS_PER_SECOND: usize = 200;

/// Half widths beyond this, atm, are a divergence: the pressures themselves are below 5.
const LIMIT: f64 = 50.0;

/// A setting of the plant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setting {
    /// Time unit of the rates.
    pub rates: Rates,
    /// Measurement noise.
    pub noise: Noise,
    /// Number of steps.
    pub steps: usize,
}

impl Setting {
    /// The paper's plant.
    #[must_use]
    pub fn of_the_paper(noise: Noise) -> Self {
        Self { rates: Rates::PerMinute, noise, steps: STEPS }
    }
}

impl Arena<2, 1> for Setting {
    const NAME: &'static str = "batch-reactor";
    type Kind = Kind;

    fn simulate(&self, rng: &mut ChaCha8Rng) -> Result<Truth<2, 1>, ScenarioError> {
        simulate(self.rates, self.noise, self.steps, rng)
    }

    fn start(&self, kind: Kind) -> Result<Box<dyn Contestant<2>>, ScenarioError> {
        filter(kind, self.rates)
    }

    fn watch(&self) -> Watch<'static> {
        Watch { late: DROPPED, marks: &MARKS, limit: LIMIT, stride: 1, bounded: self.noise.is_bounded() }
    }
}
