//! The plant of paper 003, Section 5.1: (15) with additive noise, measured by (17).

use estimators::{Relation, System};
use nonlin_bounds::Function;
use rand::Rng;
use scalars::Scalar;
use setrep::{Matrix, Zonotope};

use crate::ScenarioError;
use crate::images::models::Planar;
use crate::noise::NoiseKind;
use crate::set_study::{Additive, Trajectory};

/// Bound on every noise, of the process and of the measurement.
pub const NOISE: f64 = 0.4;
/// The true first state; the paper does not say, this is that of its authors' later demonstration.
pub const TRUE_START: [f64; 2] = [5.2, 0.65];
/// Radius of `X_0`: half the longest side of its hull.
pub const START_RADIUS: f64 = 2.0;

/// `f(x) + w` with (15): variables `(x, w)`.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlanarStep;

impl Function for PlanarStep {
    const VARIABLES: Option<usize> = Some(4);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        Planar.eval(&x[..2], &[], y);
        y[0] += x[2];
        y[1] += x[3];
    }
}

/// (17): `y_1 = x_1 - sin(x_2 / 2) + v_1`, `y_2 = -x_1 x_2 + x_2 + v_2`; variables `(x, v)`.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlanarOutput;

impl Function for PlanarOutput {
    const VARIABLES: Option<usize> = Some(4);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] - x[1].scale(0.5).sin() + x[2];
        y[1] = x[1] - x[0] * x[1] + x[3];
    }
}

/// The system, without invariant.
///
/// # Errors
/// None: its sizes fit.
pub fn system() -> Result<System, ScenarioError> {
    let noise = Zonotope::from_box(&[0.0; 2], &[NOISE; 2])?;
    Ok(System::new(Relation::new(PlanarStep), noise.clone(), Relation::new(PlanarOutput), noise)?)
}

/// `X_0` (18).
///
/// # Errors
/// None: its numbers are finite.
pub fn start() -> Result<Zonotope, ScenarioError> {
    Ok(Zonotope::new(&[5.0, 0.5], &Matrix::from_rows(&[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]])?)?)
}

/// A run of `steps` steps from [`TRUE_START`].
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn simulate<R: Rng>(kind: NoiseKind, steps: usize, rng: &mut R) -> Result<Trajectory, ScenarioError> {
    let plant =
        Additive { dynamics: &PlanarStep, process: &[NOISE; 2], measurement: &PlanarOutput, output: &[NOISE; 2] };
    plant.simulate(&TRUE_START, vec![Vec::new(); steps], kind, rng)
}
