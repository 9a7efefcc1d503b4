//! Example I of paper 004, equation (13).

use estimators::{Relation, System};
use nonlin_bounds::{BoundError, DynFunction, Function, Jet, Operand, Order};
use rand::Rng;
use scalars::{Interval, Scalar};
use setrep::{Matrix, Zonotope};

use crate::ScenarioError;
use crate::images::models::Planar;
use crate::noise::NoiseKind;
use crate::polytopes::PolytopeCase;
use crate::published::cas_jacobian::CasPlanar;
use crate::set_study::{Additive, Trajectory};

/// Bounds of the process noise.
const PROCESS: [f64; 2] = [0.1; 2];
/// Bounds of the measurement noise.
const OUTPUT: [f64; 2] = [0.4; 2];
/// The first state, of the authors' code; it lies in `X_0`.
const STATE: [f64; 2] = [0.8, 0.65];

/// How the Jacobian is written; the function is the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// As a computer algebra system prints it, in natural interval arithmetic: the paper's volumes fit this form.
    Cas,
    /// With each variable nearly once, by automatic differentiation of `x_2 / (4 + x_1)`.
    Tight,
}

/// `f(x) + w` with [`Planar`]'s tight derivatives: variables `(x, w)`.
#[derive(Debug, Clone, Copy, Default)]
pub struct Step;

impl Function for Step {
    const VARIABLES: Option<usize> = Some(4);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        Planar.eval(&x[..2], p, y);
        y[0] += x[2];
        y[1] += x[3];
    }
}

/// `y_1 = x_1 + v_1`, `y_2 = -x_1 + x_2 + v_2`: variables `(x, v)`.
#[derive(Debug, Clone, Copy, Default)]
pub struct Outputs;

impl Function for Outputs {
    const VARIABLES: Option<usize> = Some(4);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = x[0] + x[2];
        y[1] = x[1] - x[0] + x[3];
    }
}

/// `f(x) + w` with the Jacobian of [`CasPlanar`]: variables `(x, w)`.
#[derive(Debug, Clone, Copy, Default)]
pub struct CasStep;

impl DynFunction for CasStep {
    fn variables(&self) -> usize {
        4
    }

    fn parameters(&self) -> usize {
        0
    }

    fn outputs(&self) -> usize {
        2
    }

    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        check_variables(x.len())?;
        CasPlanar.value(&x[..2], p, y)?;
        y[0] += x[2];
        y[1] += x[3];
        Ok(())
    }

    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        check_variables(x.len())?;
        let mut without = Jet::new();
        CasPlanar.enclose(order, &x[..2], p, &mut without)?;
        jet.reset(order, 4, 2);
        let (values, jacobian, _, smoothness) = jet.parts_mut();
        for i in 0..2 {
            values[i] = without.values()[i] + x[2 + i];
            smoothness[i] = without.smoothness()[i];
            if order == Order::Jacobian {
                jacobian[4 * i..4 * i + 2].copy_from_slice(&without.jacobian()[2 * i..2 * i + 2]);
                jacobian[4 * i + 2..4 * i + 4].copy_from_slice(&[Interval::ZERO; 2]);
                jacobian[4 * i + 2 + i] = Interval::ONE;
            }
        }
        Ok(())
    }
}

fn check_variables(found: usize) -> Result<(), BoundError> {
    let operand = Operand::Variables;
    if found == 4 { Ok(()) } else { Err(BoundError::Dimension { operand, expected: 4, found }) }
}

/// The system with `X_0` whose generators are scaled, in one form.
///
/// # Errors
/// None: the sizes fit.
pub fn case(form: Form, scale: f64) -> Result<PolytopeCase, ScenarioError> {
    let noise = |bounds: &[f64]| Zonotope::from_box(&vec![0.0; bounds.len()], bounds);
    let dynamics = match form {
        Form::Cas => Relation::from_bounds(CasStep),
        Form::Tight => Relation::new(Step),
    };
    let generators = Matrix::from_rows(&[&[0.1 * scale, 0.2 * scale, -0.1 * scale], &[0.1 * scale, 0.1 * scale, 0.0]])?;
    Ok(PolytopeCase {
        system: System::new(dynamics, noise(&PROCESS)?, Relation::new(Outputs), noise(&OUTPUT)?)?,
        start: Zonotope::new(&[0.5, 0.5], &generators)?,
        variant: if form == Form::Cas { "" } else { "/tight-jacobian" },
    })
}

/// A run of `k = 0 ..= steps`.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn simulate<R: Rng>(kind: NoiseKind, steps: usize, rng: &mut R) -> Result<Trajectory, ScenarioError> {
    let plant = Additive { dynamics: &Step, process: &PROCESS, measurement: &Outputs, output: &OUTPUT };
    plant.simulate(&STATE, vec![Vec::new(); steps], kind, rng)
}

/// Points spread over `X_0`, `G xi` for `xi` on a grid.
#[must_use]
pub fn points(scale: f64) -> Vec<Vec<f64>> {
    let ends: Vec<f64> = (0..5).map(|i| f64::from(i) / 2.0 - 1.0).collect();
    let mut points = Vec::new();
    for &a in &ends {
        for &b in &ends {
            for &c in &ends {
                points.push(vec![0.5 + scale * (0.1 * a + 0.2 * b - 0.1 * c), 0.5 + scale * 0.1 * (a + b)]);
            }
        }
    }
    points
}
