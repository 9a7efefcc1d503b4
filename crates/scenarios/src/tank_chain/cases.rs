//! The cases: a chain, a noise, all filters, and the yardstick.

use super::contenders::contenders;
use super::{ideal, plant};
use crate::noise::NoiseKind;
use crate::set_study::{Cell, RADIUS, study};
use crate::{Context, ScenarioError, monte_carlo};

/// A chain and a noise.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Number of tanks.
    pub n: usize,
    /// How the noises are drawn.
    pub kind: NoiseKind,
    /// Number of steps.
    pub steps: usize,
    /// Number of runs.
    pub runs: usize,
    /// Steps at which radii are listed.
    pub listed: &'static [usize],
    /// Number of runs for which the yardstick is computed at the listed steps: the first ones.
    pub ideals: usize,
}

impl Case {
    /// The label of the rows.
    #[must_use]
    pub fn label(&self) -> String {
        format!("n={}, {}", self.n, self.kind.name())
    }
}

/// All runs of a case.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What was run.
    pub case: Case,
    /// The filters' runs.
    pub cells: Vec<Cell>,
    /// Radii of the yardstick at the listed steps, run by run.
    pub ideal: Vec<Vec<f64>>,
}

impl Outcome {
    /// Runs a case.
    ///
    /// # Errors
    /// Those of the filters and sets; [`ScenarioError::Truth`].
    pub fn new(context: &Context<'_>, case: Case) -> Result<Self, ScenarioError> {
        let Case { n, kind, steps, runs, .. } = case;
        let label = format!("tank-chain, {}", case.label());
        let simulate = |rng: &mut _| plant::simulate(n, kind, steps, rng);
        let cells = study(context, &label, runs, simulate, &contenders(n), &[RADIUS])?;
        // The same label: the same noises.
        let ideal = monte_carlo::run(context, &label, case.ideals.min(runs), |_, rng| {
            ideal::radii(n, &simulate(rng)?, case.listed)
        })?;
        Ok(Self { case, cells, ideal })
    }

    /// Mean ratio of a filter's radius to that of the yardstick at the `index`-th listed step, over the runs that have one.
    #[must_use]
    pub fn ratio_to_ideal(&self, cell: &Cell, index: usize) -> Option<f64> {
        let radii = cell.at(0, *self.case.listed.get(index)?);
        let ratios: Vec<f64> = self.ideal.iter().zip(radii).map(|(ideal, radius)| radius / ideal[index]).collect();
        crate::results::mean_and_sd(&ratios).map(|(mean, _)| mean)
    }

    /// Mean radius of the yardstick at the `index`-th listed step; none if it was not computed.
    #[must_use]
    pub fn mean_ideal(&self, index: usize) -> Option<f64> {
        let radii: Vec<f64> = self.ideal.iter().filter_map(|run| run.get(index).copied()).collect();
        crate::results::mean_and_sd(&radii).map(|(mean, _)| mean)
    }
}
