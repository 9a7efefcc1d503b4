//! [`Trajectory`]: the truth of one run, and what a filter gets of it.

use nonlin_bounds::{DynFunction, Jet, Order};
use scalars::Interval;

use crate::ScenarioError;
use crate::truth::{TruthError, output_within};

/// One run of a plant: states `x_0 ..= x_N`, the inputs between them, outputs `y_0 ..= y_N`.
///
/// **Guarantee:** the enclosures hold one exact trajectory of the model whose noises keep their bounds, as [`crate::truth`] says; whoever
/// makes one has proven it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trajectory {
    /// Enclosures of the states.
    pub states: Vec<Vec<Interval>>,
    /// `inputs[k]` leads from `x_k` to `x_{k+1}`.
    pub inputs: Vec<Vec<f64>>,
    /// What is measured of every state.
    pub outputs: Vec<Vec<f64>>,
}

impl Trajectory {
    /// Number `N` of steps after the first state.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.outputs.len().saturating_sub(1)
    }

    /// Largest width of the enclosure of a state: how well the truth is known.
    #[must_use]
    pub fn widest(&self) -> f64 {
        self.states.iter().flatten().map(Interval::width).fold(0.0, f64::max)
    }
}

/// The outputs of a state near `g((x, 0)) + noise`, for a `g` to which the noises are added, one to each output; they are its last variables.
///
/// **Guarantee:** every output is a measurement of the state with a noise within its bound.
///
/// # Errors
/// [`TruthError::Output`] if that cannot be proven, [`ScenarioError::Bound`] if sizes do not fit.
pub fn measure(
    g: &dyn DynFunction,
    state: &[Interval],
    noise: &[f64],
    bounds: &[f64],
    step: usize,
) -> Result<Vec<f64>, ScenarioError> {
    let values = without_noise(g, state, noise.len(), &[])?;
    let output = |(component, value): (usize, &Interval)| {
        let bound = bounds[component];
        output_within(value, noise[component], bound).ok_or(TruthError::Output { step, component, bound }.into())
    };
    values.iter().enumerate().map(output).collect()
}

/// `f((x, 0), p)` with as many zeros as `noises`.
///
/// # Errors
/// [`ScenarioError::Bound`] if sizes do not fit.
pub(super) fn without_noise(
    f: &dyn DynFunction,
    state: &[Interval],
    noises: usize,
    parameters: &[f64],
) -> Result<Vec<Interval>, ScenarioError> {
    let parameters: Vec<Interval> = parameters.iter().map(|&p| Interval::point(p)).collect();
    let variables: Vec<Interval> = state.iter().copied().chain(std::iter::repeat_n(Interval::ZERO, noises)).collect();
    let mut jet = Jet::new();
    f.enclose(Order::Value, &variables, &parameters, &mut jet)?;
    Ok(jet.values().to_vec())
}
