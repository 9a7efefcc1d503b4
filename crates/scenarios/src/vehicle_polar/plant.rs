//! The vehicle of paper 001, section 5.2, and its simulator.
//!
//! Position and velocity in the plane at constant speed, (48)-(50); range and bearing are measured, (51). The paper prints `tan` for the
//! bearing, which has poles that a straight course meets; `atan` is meant.

use nonlin_bounds::Function;
use rand::Rng;
use scalars::{Interval, Scalar};

use crate::ScenarioError;
use crate::contest::{Noise, Truth, measured};
use crate::truth::{TruthError, exact_sum, proven_within};

/// Initial state: m, m, m/s, m/s.
pub const INITIAL: [f64; 4] = [5.0, 5.0, 1.0, 1.0];
/// Standard deviations of the process noise.
pub const PROCESS_SIGMA: [f64; 4] = [0.0, 0.0, 0.1, 0.1];
/// Standard deviations of the measurement noise: m, rad.
pub const NOISE_SIGMA: [f64; 2] = [0.05, 2.618e-3 / 3.0];

/// `x+ = (x1 + T x3, x2 + T x4, s x3 / |v|, s x4 / |v|) + w`, `T = 0.5 s`, `s = 15 m/s`; variables `(x1..x4, w1..w4)`.
#[derive(Debug, Clone, Copy)]
pub struct Drive;

impl Function for Drive {
    const VARIABLES: Option<usize> = Some(8);
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let scale = (x[2].sqr() + x[3].sqr()).sqrt().recip().scale(15.0);
        y[0] = x[0] + x[2].scale(0.5) + x[4];
        y[1] = x[1] + x[3].scale(0.5) + x[5];
        y[2] = x[2] * scale + x[6];
        y[3] = x[3] * scale + x[7];
    }
}

/// What stands for the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bearing {
    /// `atan(x2 / x1)`, what is meant.
    Atan,
    /// `tan(x2 / x1)`, as printed.
    Tan,
}

/// `y = (|x|, bearing) + v`; variables `(x1..x4, v1, v2)`.
#[derive(Debug, Clone, Copy)]
pub struct Polar(pub Bearing);

impl Function for Polar {
    const VARIABLES: Option<usize> = Some(6);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = (x[0].sqr() + x[1].sqr()).sqrt() + x[4];
        let ratio = x[1] / x[0];
        y[1] = match self.0 {
            Bearing::Atan => ratio.atan(),
            Bearing::Tan => ratio.tan(),
        } + x[5];
    }
}

/// Speeds of the truth are multiples of this, m/s, so that positions below 32 km are floats exactly: no noise acts on them.
const GRID: f64 = 1.0 / (1_u64 << 37) as f64;

/// Simulates `steps` periods of 0.5 s.
///
/// **Guarantee:** the states are one exact trajectory of the model, without noise on the positions; with truncated noises those on the
/// speeds and on the outputs are proven to be within three standard deviations.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step or an output cannot be proven.
pub fn simulate<R: Rng>(
    bearing: Bearing,
    noise: Noise,
    steps: usize,
    rng: &mut R,
) -> Result<Truth<4, 2>, ScenarioError> {
    let mut process = noise.source(PROCESS_SIGMA.map(|sigma| 3.0 * sigma));
    let mut output = noise.source(NOISE_SIGMA.map(|sigma| 3.0 * sigma));
    let sensor = Polar(bearing);
    let advance = |step, x: &[f64; 4], rng: &mut R| advance(x, &process.draw(rng), &process.bounds(), step);
    Truth::run(INITIAL, steps, rng, advance, |step, x, rng| measured(&sensor, x, &mut output, step, rng))
}

/// The state after `x` with speeds near those that the noise leads to.
fn advance(x: &[f64; 4], w: &[f64; 4], bounds: &[f64; 4], step: usize) -> Result<[f64; 4], ScenarioError> {
    let refused = |component, found| TruthError::ProcessNoise { step, component, bound: bounds[component], found };
    let [x1, x2, x3, x4] = x.map(Interval::point);
    let mut image = [Interval::ZERO; 4];
    Drive.eval(&[x1, x2, x3, x4, Interval::ZERO, Interval::ZERO, Interval::ZERO, Interval::ZERO], &[], &mut image);
    let mut next = [0.0; 4];
    for i in [0, 1] {
        next[i] = exact_sum(x[i], 0.5 * x[i + 2]).ok_or_else(|| refused(i, image[i].rad()))?;
    }
    for i in [2, 3] {
        next[i] = ((image[i].mid() + w[i]) / GRID).round() * GRID;
        let noise = Interval::point(next[i]) - image[i];
        if !proven_within(&noise, bounds[i]) {
            return Err(refused(i, noise.mag()).into());
        }
    }
    Ok(next)
}
