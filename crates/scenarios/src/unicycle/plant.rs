//! Example II of paper 004, equation (14): a robot that sees two landmarks.

use estimators::{Relation, System};
use nonlin_bounds::{DynFunction, Function, Jet, Order};
use rand::Rng;
use scalars::{Interval, Scalar};
use setrep::Zonotope;

use crate::noise::NoiseKind;
use crate::polytopes::PolytopeCase;
use crate::set_study::trajectory::measure;
use crate::set_study::{Additive, Trajectory};
use crate::{ScenarioError, noise::BoxNoise};

/// Half-widths of the process noise, whose center is part of the model.
const PROCESS: [f64; 3] = [0.05, 0.03, 0.06];
/// Half-widths of the measurement noise, whose center is part of the model.
const OUTPUT: [f64; 4] = [0.01, 0.015, 0.015, 0.025];
/// The first state: position in m, heading in rad.
pub const STATE: [f64; 3] = [0.1, 0.2, 1.0];
/// Half-widths of `X_0`: 10 %, 10 % and 20 % of the state.
const START: [f64; 3] = [0.01, 0.02, 0.2];

/// The robot over a step of one second, variables `(s_x, s_y, theta, w)`.
///
/// Process noises are `0.2 (0.5 rho - 0.3)`, `0.2 (0.3 rho - 0.2)`, `0.2 (0.6 rho - 0.4)` with `rho` in `[0, 1]`: centers `-0.01, -0.01, -0.02`.
#[derive(Debug, Clone, Copy)]
pub struct Robot {
    /// Whether there is process noise, so that its center counts.
    pub is_noisy: bool,
}

impl Function for Robot {
    const VARIABLES: Option<usize> = Some(6);

    fn outputs(&self) -> usize {
        3
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let (sin, cos) = x[2].sin_cos();
        let speed = S::decimal("0.3");
        y[0] = x[0] + speed * cos + x[3];
        y[1] = x[1] + speed * sin + x[4];
        y[2] = x[2] + S::decimal("0.15") + x[5];
        if self.is_noisy {
            y[0] += S::decimal("-0.01");
            y[1] += S::decimal("-0.01");
            y[2] += S::decimal("-0.02");
        }
    }
}

/// Distance and bearing of the landmarks (5, 15) and (15, 15), variables `(s_x, s_y, theta, v)`.
///
/// Measurement noises lie in `[-0.01, 0.01]`, `[-0.01, 0.02]`, `[-0.02, 0.01]`, `[-0.03, 0.02]`: centers `0, 0.005, -0.005, -0.005`.
#[derive(Debug, Clone, Copy, Default)]
pub struct Landmarks;

impl Function for Landmarks {
    const VARIABLES: Option<usize> = Some(7);

    fn outputs(&self) -> usize {
        4
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (i, (east, centers)) in [(5.0, ["0", "0.005"]), (15.0, ["-0.005", "-0.005"])].into_iter().enumerate() {
            let (dx, dy) = (S::from_f64(east) - x[0], S::from_f64(15.0) - x[1]);
            y[2 * i] = (dx.sqr() + dy.sqr()).sqrt() + S::decimal(centers[0]) + x[3 + 2 * i];
            y[2 * i + 1] = x[2] - (dy / dx).atan() + S::decimal(centers[1]) + x[4 + 2 * i];
        }
    }
}

/// The system with or without process noise; the half-widths of `X_0` are scaled.
///
/// # Errors
/// None: the sizes fit.
pub fn case(is_noisy: bool, scale: f64) -> Result<PolytopeCase, ScenarioError> {
    let noise = |bounds: &[f64]| Zonotope::from_box(&vec![0.0; bounds.len()], bounds);
    let process = if is_noisy { PROCESS } else { [0.0; 3] };
    let (dynamics, measurement) = (Relation::new(Robot { is_noisy }), Relation::new(Landmarks));
    Ok(PolytopeCase {
        system: System::new(dynamics, noise(&process)?, measurement, noise(&OUTPUT)?)?,
        start: Zonotope::from_box(&STATE, &START.map(|radius| radius * scale))?,
        variant: "",
    })
}

/// A run of `k = 0 ..= steps`.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step or an output cannot be proven.
pub fn simulate<R: Rng>(
    is_noisy: bool,
    kind: NoiseKind,
    steps: usize,
    rng: &mut R,
) -> Result<Trajectory, ScenarioError> {
    let (dynamics, inputs) = (Robot { is_noisy }, vec![Vec::new(); steps]);
    if is_noisy {
        let plant = Additive { dynamics: &dynamics, process: &PROCESS, measurement: &Landmarks, output: &OUTPUT };
        return plant.simulate(&STATE, inputs, kind, rng);
    }
    // Without noise the states are no floats: the trajectory is enclosed.
    let mut output = BoxNoise::new(kind, &OUTPUT);
    let mut run = Trajectory { inputs, ..Trajectory::default() };
    let mut state: Vec<Interval> = STATE.map(Interval::point).into();
    let mut jet = Jet::new();
    for step in 0..=steps {
        run.outputs.push(measure(&Landmarks, &state, &output.draw(rng), &OUTPUT, step)?);
        let variables: Vec<Interval> = state.iter().copied().chain([Interval::ZERO; 3]).collect();
        dynamics.enclose(Order::Value, &variables, &[], &mut jet)?;
        run.states.push(core::mem::replace(&mut state, jet.values().to_vec()));
    }
    Ok(run)
}

/// Points spread over `X_0`.
#[must_use]
pub fn points(scale: f64) -> Vec<Vec<f64>> {
    let ends: Vec<f64> = (0..5).map(|i| scale * (f64::from(i) / 2.0 - 1.0)).collect();
    let mut points = Vec::new();
    for &a in &ends {
        for &b in &ends {
            for &c in &ends {
                points.push(vec![STATE[0] + START[0] * a, STATE[1] + START[1] * b, STATE[2] + START[2] * c]);
            }
        }
    }
    points
}
