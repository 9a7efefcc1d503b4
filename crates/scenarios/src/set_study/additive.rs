//! [`Additive`]: simulation of plants whose noises are added to states and outputs.

use nonlin_bounds::DynFunction;
use rand::Rng;
use scalars::Interval;

use super::Trajectory;
use super::trajectory::{measure, without_noise};
use crate::ScenarioError;
use crate::noise::{BoxNoise, NoiseKind};
use crate::truth::{TruthError, output_within};

/// A plant `x_{k+1} = f((x_k, 0); u_k) + w_k`, `y_k = g((x_k, 0)) + v_k`, written with the noises as the last variables of `f` and `g`, one
/// added to each state and each output.
///
/// Its states are plain floats: an exact trajectory, since the noise that leads from one to the next is enclosed and proven to keep its
/// bounds.
#[derive(Clone, Copy)]
pub struct Additive<'a> {
    /// `f`.
    pub dynamics: &'a dyn DynFunction,
    /// Bounds on the absolute values of `w`.
    pub process: &'a [f64],
    /// `g`.
    pub measurement: &'a dyn DynFunction,
    /// Bounds on the absolute values of `v`.
    pub output: &'a [f64],
}

impl std::fmt::Debug for Additive<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Additive").field("process", &self.process).field("output", &self.output).finish_non_exhaustive()
    }
}

impl Additive<'_> {
    /// A run from `start` with these inputs, one a step.
    ///
    /// # Errors
    /// [`ScenarioError::Truth`] if a step or an output cannot be proven, [`ScenarioError::Bound`] if sizes do not fit.
    pub fn simulate<R: Rng>(
        &self,
        start: &[f64],
        inputs: Vec<Vec<f64>>,
        kind: NoiseKind,
        rng: &mut R,
    ) -> Result<Trajectory, ScenarioError> {
        let (mut process, mut output) = (BoxNoise::new(kind, self.process), BoxNoise::new(kind, self.output));
        let mut run = Trajectory::default();
        let mut state = start.to_vec();
        for step in 0..=inputs.len() {
            let enclosure: Vec<Interval> = state.iter().map(|&x| Interval::point(x)).collect();
            run.outputs.push(measure(self.measurement, &enclosure, &output.draw(rng), self.output, step)?);
            if let Some(input) = inputs.get(step) {
                state = advanced(self.dynamics, &enclosure, input, &process.draw(rng), self.process, step)?;
            }
            run.states.push(enclosure);
        }
        run.inputs = inputs;
        Ok(run)
    }
}

/// A state near `f((x, 0); u) + w`, a noise added to each state, that is reached by a noise within `bounds`.
///
/// # Errors
/// [`TruthError::ProcessNoise`] if that cannot be proven, [`ScenarioError::Bound`] if sizes do not fit.
pub fn advanced(
    dynamics: &dyn DynFunction,
    state: &[Interval],
    input: &[f64],
    noise: &[f64],
    bounds: &[f64],
    step: usize,
) -> Result<Vec<f64>, ScenarioError> {
    let image = without_noise(dynamics, state, noise.len(), input)?;
    let next = |(component, image): (usize, &Interval)| {
        let bound = bounds[component];
        output_within(image, noise[component], bound).ok_or_else(|| {
            let found = image.rad() + bound;
            TruthError::ProcessNoise { step, component, bound, found }.into()
        })
    };
    image.iter().enumerate().map(next).collect()
}
