//! [`Truth`]: one run of a plant; [`Noise`] and [`Source`]: how its noises are drawn.

use nonlin_bounds::DynFunction;
use rand::Rng;
use scalars::Interval;

use crate::ScenarioError;
use crate::noise::{BoundedNoise, NoiseKind, standard_normal};
use crate::set_study::trajectory::measure;

/// How noises are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Noise {
    /// As in the paper: without bounds.
    Gaussian,
    /// Drawn again while beyond three standard deviations.
    Truncated,
}

impl Noise {
    /// The name used in rows and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gaussian => "gaussian",
            Self::Truncated => "truncated at 3 sigma",
        }
    }

    /// Whether the noises have bounds.
    #[must_use]
    pub fn is_bounded(self) -> bool {
        self == Self::Truncated
    }

    /// Noises of which `bounds` are three standard deviations.
    #[must_use]
    pub fn source<const N: usize>(self, bounds: [f64; N]) -> Source<N> {
        let (bounded, sigmas) = (BoundedNoise::new(NoiseKind::TruncatedGaussian, bounds), bounds.map(|b| b / 3.0));
        let kept = if self.is_bounded() { bounds } else { [f64::INFINITY; N] };
        Source { bounds: kept, sigmas, bounded: self.is_bounded().then_some(bounded) }
    }
}

/// A source of noise vectors of `N` entries.
#[derive(Debug, Clone)]
pub struct Source<const N: usize> {
    bounds: [f64; N],
    sigmas: [f64; N],
    bounded: Option<BoundedNoise<N>>,
}

impl<const N: usize> Source<N> {
    /// What no absolute value exceeds; infinite for Gaussian noises.
    #[must_use]
    pub fn bounds(&self) -> [f64; N] {
        self.bounds
    }

    /// The next vector.
    pub fn draw<R: Rng>(&mut self, rng: &mut R) -> [f64; N] {
        match &mut self.bounded {
            Some(bounded) => bounded.draw(rng),
            None => self.sigmas.map(|sigma| sigma * standard_normal(rng)),
        }
    }
}

/// One run: states `x_1..x_N` after the first, outputs `y_1..y_N`.
///
/// **Guarantee:** the floats are one exact trajectory of the model by the contract of [`crate::truth`]: every process noise is enclosed, and
/// where noises have bounds it is proven to keep them, as every output is.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth<const N: usize, const M: usize> {
    /// States.
    pub states: Vec<[f64; N]>,
    /// Outputs.
    pub outputs: Vec<[f64; M]>,
}

impl<const N: usize, const M: usize> Truth<N, M> {
    /// A run of `steps` steps from `start`; `advance` and `observe` get the number of the step and the state.
    ///
    /// # Errors
    /// Theirs.
    pub fn run<R: Rng>(
        start: [f64; N],
        steps: usize,
        rng: &mut R,
        mut advance: impl FnMut(usize, &[f64; N], &mut R) -> Result<[f64; N], ScenarioError>,
        mut observe: impl FnMut(usize, &[f64; N], &mut R) -> Result<[f64; M], ScenarioError>,
    ) -> Result<Self, ScenarioError> {
        let mut truth = Self { states: Vec::with_capacity(steps), outputs: Vec::with_capacity(steps) };
        let mut x = start;
        for step in 0..steps {
            x = advance(step, &x, rng)?;
            truth.outputs.push(observe(step, &x, rng)?);
            truth.states.push(x);
        }
        Ok(truth)
    }
}

/// The outputs of a state by a `g` to which the noises are added, one to each output; they are its last variables.
///
/// **Guarantee:** every output is a measurement of the state with a noise within the bounds of the source.
///
/// # Errors
/// [`TruthError::Output`](crate::truth::TruthError::Output) if that cannot be proven.
pub fn measured<R: Rng, const N: usize, const M: usize>(
    g: &dyn DynFunction,
    x: &[f64; N],
    source: &mut Source<M>,
    step: usize,
    rng: &mut R,
) -> Result<[f64; M], ScenarioError> {
    let outputs = measure(g, &x.map(Interval::point), &source.draw(rng), &source.bounds(), step)?;
    Ok(std::array::from_fn(|i| outputs[i]))
}
