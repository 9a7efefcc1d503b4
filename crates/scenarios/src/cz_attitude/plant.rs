//! The plant of paper 003, Section 5.2: a quaternion driven by measured rates, seen through two directions.

use estimators::{Relation, System};
use nonlin_bounds::{DynFunction, Function};
use scalars::{Interval, Scalar};
use setrep::{Matrix, Zonotope};

use crate::ScenarioError;

/// Bound on the error of each measured rate, rad/s.
pub const RATE_NOISE: f64 = 3e-3;
/// Half the sides of `X_0`.
pub const START_RADIUS: f64 = 0.18;
/// The true first state, and the middle of `X_0`.
pub const TRUE_START: [f64; 4] = [0.0, 1.0, 0.0, 0.0];

/// (19): the quaternion turns with the rates `u - w` for `T_s = 0.2 s`; variables `(x, w)`, parameters `u`.
///
/// `cos p` and `sin(p) / p` are the functions `C_0` and `C_1` of Stumpff of the square of the half angle `p`, which hold it once.
#[derive(Debug, Clone, Copy, Default)]
pub struct AttitudeStep;

impl Function for AttitudeStep {
    const VARIABLES: Option<usize> = Some(7);

    fn parameters(&self) -> usize {
        3
    }

    fn outputs(&self) -> usize {
        4
    }

    fn eval<S: Scalar>(&self, x: &[S], u: &[S], y: &mut [S]) {
        let half = half_turn(&x[4..], u);
        let square = half[0].sqr() + half[1].sqr() + half[2].sqr();
        turn(&x[..4], half, square.stumpff(0), square.stumpff(1), y);
    }
}

/// `(T_s / 2) (u - w)`.
pub(super) fn half_turn<S: Scalar>(w: &[S], u: &[S]) -> [S; 3] {
    [0, 1, 2].map(|i| (u[i] - w[i]) * S::ratio(1, 10))
}

/// `cos(p) x - sinc(p) Omega(half) x`.
pub(super) fn turn<S: Scalar>(x: &[S], [a, b, c]: [S; 3], cos: S, sinc: S, y: &mut [S]) {
    y[0] = cos * x[0] - sinc * (c * x[1] - b * x[2] + a * x[3]);
    y[1] = cos * x[1] - sinc * (a * x[2] - c * x[0] + b * x[3]);
    y[2] = cos * x[2] - sinc * (b * x[0] - a * x[1] + c * x[3]);
    y[3] = cos * x[3] + sinc * (a * x[0] + b * x[1] + c * x[2]);
}

/// `(C(x) r_1, C(x) r_2) + v`, the first two columns of the rotation: variables `(x, v)`.
#[derive(Debug, Clone, Copy, Default)]
pub struct AttitudeOutput;

impl Function for AttitudeOutput {
    const VARIABLES: Option<usize> = Some(10);

    fn outputs(&self) -> usize {
        6
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| x[i].sqr());
        y[0] = a - b - c + d;
        y[1] = (x[0] * x[1] - x[2] * x[3]).scale(2.0);
        y[2] = (x[0] * x[2] + x[1] * x[3]).scale(2.0);
        y[3] = (x[0] * x[1] + x[2] * x[3]).scale(2.0);
        y[4] = b - a - c + d;
        y[5] = (x[1] * x[2] - x[0] * x[3]).scale(2.0);
        for i in 0..6 {
            y[i] += x[4 + i];
        }
    }
}

/// `|x|^2`, which is 1.
#[derive(Debug, Clone, Copy, Default)]
pub struct SquaredNorm;

impl Function for SquaredNorm {
    const VARIABLES: Option<usize> = Some(4);

    fn outputs(&self) -> usize {
        1
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0].sqr() + x[1].sqr() + x[2].sqr() + x[3].sqr();
    }
}

/// The system with its invariant, for a bound on the measurement noise and one of the forms of (19).
///
/// # Errors
/// None for a bound that is finite.
pub fn system(step: Relation, noise: f64) -> Result<System, ScenarioError> {
    let rates = Zonotope::from_box(&[0.0; 3], &[RATE_NOISE; 3])?;
    let directions = Zonotope::from_box(&[0.0; 6], &[noise; 6])?;
    let system = System::new(step, rates, Relation::new(AttitudeOutput), directions)?;
    Ok(system.with_invariant(Relation::new(SquaredNorm), vec![Interval::ONE])?)
}

/// `X_0`.
///
/// # Errors
/// None: its numbers are finite.
pub fn start() -> Result<Zonotope, ScenarioError> {
    Ok(Zonotope::new(&TRUE_START, &Matrix::from_diagonal(&[START_RADIUS; 4]))?)
}

/// The true rates that lead to state `k` (20), rad/s.
#[must_use]
pub fn true_rates(k: usize) -> [f64; 3] {
    let phase = core::f64::consts::TAU / 12.0 * 0.2 * k as f64;
    [0.0, 6.0, 12.0].map(|shift| 0.3 * (phase - shift).sin())
}

/// The next quaternion in floating point.
pub(super) fn next(x: &[f64], w: &[f64], u: &[f64]) -> Result<[f64; 4], ScenarioError> {
    let mut y = [0.0; 4];
    AttitudeStep.value(&[x, w].concat(), u, &mut y)?;
    Ok(y)
}
