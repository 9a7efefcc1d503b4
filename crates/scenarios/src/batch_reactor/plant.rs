//! The reactor of paper 001, section 5.1, and its simulator.
//!
//! `2 A <-> B` at constant volume and temperature: partial pressures `x1, x2` in atm, (45); the total pressure is measured, (46). One
//! Runge-Kutta step of 1 s is the model itself. The rates are per minute although the step is in seconds: with rates per second the
//! set-valued filter diverges in every run and no table of the paper comes out.

use nonlin_bounds::{Function, Rk4, function};
use rand::Rng;
use scalars::{Interval, Scalar};

use crate::ScenarioError;
use crate::contest::{Noise, Truth, measured};
use crate::set_study::additive::advanced;

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

/// Simulates `steps` seconds.
///
/// **Guarantee:** the states are one exact trajectory of the model with process noises within [`PROCESS_BOUND`] (they are rounding alone);
/// with truncated noise every output is within [`NOISE_BOUND`] of the exact one.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step or an output cannot be proven.
pub fn simulate<R: Rng>(rates: Rates, noise: Noise, steps: usize, rng: &mut R) -> Result<Truth<2, 1>, ScenarioError> {
    let model = Reaction(rates);
    let mut source = noise.source([NOISE_BOUND]);
    let advance = |step, x: &[f64; 2], _: &mut R| {
        let next = advanced(&model, &x.map(Interval::point), &[], &[0.0; 2], &[PROCESS_BOUND; 2], step)?;
        Ok([next[0], next[1]])
    };
    Truth::run(INITIAL, steps, rng, advance, |step, x, rng| measured(&Pressure, x, &mut source, step, rng))
}
