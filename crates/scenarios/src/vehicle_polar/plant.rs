//! The vehicle of paper 001, section 5.2, and its simulator.
//!
//! Position and velocity in the plane at constant speed, (48)-(50); range and bearing are measured, (51). The paper prints `tan` for the
//! bearing, which has poles that a straight course meets; `atan` is meant.

use nonlin_bounds::Function;
use rand::Rng;
use scalars::Scalar;

use crate::contest::Noise;
use crate::noise::{BoundedNoise, NoiseKind, standard_normal};

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

/// One run: states `x_1..x_N` after [`INITIAL`], outputs `y_1..y_N`, in plain floating point.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// States: m, m, m/s, m/s.
    pub states: Vec<[f64; 4]>,
    /// Outputs: m, rad.
    pub outputs: Vec<[f64; 2]>,
}

/// Simulates `steps` periods of 0.5 s.
pub fn simulate(bearing: Bearing, noise: Noise, steps: usize, rng: &mut impl Rng) -> Truth {
    let (motion, sensor) = (Drive, Polar(bearing));
    let mut process = BoundedNoise::new(NoiseKind::TruncatedGaussian, PROCESS_SIGMA.map(|sigma| 3.0 * sigma));
    let mut output = BoundedNoise::new(NoiseKind::TruncatedGaussian, NOISE_SIGMA.map(|sigma| 3.0 * sigma));
    let mut truth = Truth { states: Vec::with_capacity(steps), outputs: Vec::with_capacity(steps) };
    let mut x = INITIAL;
    for _ in 0..steps {
        let (w, v) = match noise {
            Noise::Gaussian => {
                let w = PROCESS_SIGMA.map(|sigma| sigma * standard_normal(rng));
                (w, NOISE_SIGMA.map(|sigma| sigma * standard_normal(rng)))
            }
            Noise::Truncated => (process.draw(rng), output.draw(rng)),
        };
        let (mut next, mut y) = ([0.0; 4], [0.0; 2]);
        motion.eval(&[x[0], x[1], x[2], x[3], w[0], w[1], w[2], w[3]], &[], &mut next);
        x = next;
        sensor.eval(&[x[0], x[1], x[2], x[3], v[0], v[1]], &[], &mut y);
        truth.states.push(x);
        truth.outputs.push(y);
    }
    truth
}
