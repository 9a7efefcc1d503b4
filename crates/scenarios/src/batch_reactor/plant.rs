//! The reactor of paper 001, section 5.1, and its simulator.
//!
//! `2 A <-> B` at constant volume and temperature: partial pressures `x1, x2` in atm, (45); the total pressure is measured, (46). One
//! Runge-Kutta step of 1 s is the model itself. The rates are per minute although the step is in seconds: with rates per second the
//! set-valued filter diverges in every run and no table of the paper comes out.

use nonlin_bounds::{Function, Rk4, function};
use rand::Rng;
use scalars::{Interval, Scalar};

use crate::contest::Noise;
use crate::noise::{BoundedNoise, NoiseKind, standard_normal};
use crate::truth::{TruthError, output_within, proven_within};

/// Initial state, atm.
pub const INITIAL: [f64; 2] = [3.0, 1.0];
/// Standard deviation of the measurement noise, atm.
pub const NOISE_SIGMA: f64 = 0.1;
/// Bound on the measurement noise that the set-valued filter supposes, atm: three standard deviations.
pub const NOISE_BOUND: f64 = 0.3;
/// Bound on the process noise that it supposes, atm a step.
pub const PROCESS_BOUND: f64 = 3e-5;

/// The time unit of the rates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rates {
    /// As the paper writes them.
    PerMinute,
    /// As the paper's differential equation reads if its time is in seconds.
    PerSecond,
}

/// `x+ = RK4(x) + w` over a second; variables `(x1, x2, w1, w2)`.
#[derive(Debug, Clone, Copy)]
pub struct Reaction(pub Rates);

impl Function for Reaction {
    const VARIABLES: Option<usize> = Some(4);
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let field = function!(|[x1, x2]: 2| -> 2 {
            // 0.16 / (min atm) and 0.0064 / min.
            let net = S::ratio(4, 25) * x1.sqr() - S::ratio(4, 625) * x2;
            [net.scale(-2.0), net]
        });
        let step = match self.0 {
            Rates::PerMinute => S::ratio(1, 60),
            Rates::PerSecond => S::one(),
        };
        // The field has no more outputs than variables.
        if let Ok(map) = Rk4::new(field) {
            map.eval(&x[..2], &[step], y);
        }
        y[0] += x[2];
        y[1] += x[3];
    }
}

/// `y = x1 + x2 + v`; variables `(x1, x2, v)`.
#[derive(Debug, Clone, Copy)]
pub struct Pressure;

impl Function for Pressure {
    const VARIABLES: Option<usize> = Some(3);
    fn outputs(&self) -> usize {
        1
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] + x[1] + x[2];
    }
}

/// One run: states `x_1..x_N` after [`INITIAL`], outputs `y_1..y_N`.
///
/// **Guarantee:** the states are one exact trajectory of the model with process noises within [`PROCESS_BOUND`] (they are rounding alone);
/// with truncated noise every output is within [`NOISE_BOUND`] of the exact one.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// States, atm.
    pub states: Vec<[f64; 2]>,
    /// Outputs, atm.
    pub outputs: Vec<[f64; 1]>,
}

/// Simulates `steps` seconds.
///
/// # Errors
/// [`TruthError`] if a step or an output cannot be proven.
pub fn simulate(rates: Rates, noise: Noise, steps: usize, rng: &mut impl Rng) -> Result<Truth, TruthError> {
    let model = Reaction(rates);
    let mut bounded = BoundedNoise::new(NoiseKind::TruncatedGaussian, [NOISE_BOUND]);
    let mut truth = Truth { states: Vec::with_capacity(steps), outputs: Vec::with_capacity(steps) };
    let mut x = INITIAL;
    for step in 0..steps {
        let mut next = [0.0; 2];
        model.eval(&[x[0], x[1], 0.0, 0.0], &[], &mut next);
        let exact = [Interval::point(x[0]), Interval::point(x[1]), Interval::ZERO, Interval::ZERO];
        let mut image = [Interval::ZERO; 2];
        model.eval(&exact, &[], &mut image);
        for component in 0..2 {
            let noise = Interval::point(next[component]) - image[component];
            if !proven_within(&noise, PROCESS_BOUND) {
                return Err(TruthError::ProcessNoise { step, component, bound: PROCESS_BOUND, found: noise.mag() });
            }
        }
        x = next;
        let sum = Interval::point(x[0]) + Interval::point(x[1]);
        let output = match noise {
            Noise::Gaussian => sum.mid() + NOISE_SIGMA * standard_normal(rng),
            Noise::Truncated => {
                let [v] = bounded.draw(rng);
                let refused = TruthError::Output { step, component: 0, bound: NOISE_BOUND };
                output_within(&sum, v, NOISE_BOUND).ok_or(refused)?
            }
        };
        truth.states.push(x);
        truth.outputs.push([output]);
    }
    Ok(truth)
}
