//! The planar vehicle of paper 000, section IV, and its simulator under the truth contract.
//!
//! `X_{k+1} = X_k exp(delta u) exp(delta w_k)` on SE(2), (18); output `y_k = x_k + v_k`, (15).
//! Constant input `u = (omega, nu, 0)`: a circle of 20 m radius.

use std::f64::consts::FRAC_PI_2;

use lie_groups::{LieGroup, SE2};
use nalgebra::{Vector2, Vector3};
use rand::Rng;
use scalars::Interval;

use crate::noise::{BoundedNoise, NoiseKind};
use crate::truth::{Exact, TruthError, output_within, proven_within};

/// Forward speed, m/s.
pub const SPEED: f64 = 8.0;
/// Turn rate, rad/s; the exact one is the decimal 0.4.
pub const TURN_RATE: f64 = 0.4;
/// Sampling period, s; the exact one is the decimal 0.01.
pub const PERIOD_S: f64 = 0.01;
/// Bounds on the process noise `(w_theta, w_long, w_trans)`: rad/s, m/s, m/s.
pub const PROCESS_BOUNDS: [f64; 3] = [0.1, 0.1, 0.1];
/// Bounds on the measurement noise, m.
pub const OUTPUT_BOUNDS: [f64; 2] = [1.0, 1.0];
/// True initial pose: heading pi/2 (the float below it) at the origin.
pub const INITIAL_POSE: Pose = Pose { heading_rad: FRAC_PI_2, position: [0.0, 0.0] };

/// A heading and a position in the world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Heading, rad; not wrapped.
    pub heading_rad: f64,
    /// Position, m.
    pub position: [f64; 2],
}

/// One state of an exact trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TruePose {
    /// Heading, rad; not wrapped.
    pub heading: Exact,
    /// Position, m.
    pub position: [Exact; 2],
}

impl TruePose {
    /// The pose with these coordinates.
    #[must_use]
    pub fn new(pose: Pose) -> Self {
        Self { heading: Exact::new(pose.heading_rad), position: pose.position.map(Exact::new) }
    }

    /// The nearest pose in floats.
    #[must_use]
    pub fn rounded(&self) -> Pose {
        Pose { heading_rad: self.heading.value(), position: self.position.map(Exact::value) }
    }

    /// Heading and position as intervals of a few ulp. **Guarantee:** contains the state.
    #[must_use]
    pub fn coordinates(&self) -> [Interval; 3] {
        [self.heading.enclosure(), self.position[0].enclosure(), self.position[1].enclosure()]
    }

    /// The state on the group. **Guarantee:** contains the state.
    #[must_use]
    pub fn enclosure(&self) -> SE2<Interval> {
        let [theta, x1, x2] = self.coordinates();
        SE2::from_pose(theta, x1, x2)
    }
}

/// One run of the vehicle: states `X_0..X_N` and outputs `y_0..y_{N-1}`.
///
/// **Guarantee:** the states are one exact trajectory of the model with process noises in [`PROCESS_BOUNDS`], and every output is a
/// measurement with noise in [`OUTPUT_BOUNDS`].
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// States, one more than outputs.
    pub states: Vec<TruePose>,
    /// Outputs, m.
    pub outputs: Vec<[f64; 2]>,
}

impl Truth {
    /// Largest width of the enclosure of a state, rad or m: how well the truth is known.
    #[must_use]
    pub fn widest(&self) -> f64 {
        let widths = self.states.iter().flat_map(TruePose::coordinates).map(|coordinate| coordinate.width());
        widths.fold(0.0, f64::max)
    }
}

/// The vehicle's motion of one period at constant input, as floats and as a rigorous enclosure.
#[derive(Clone, Copy, Debug)]
pub struct Vehicle {
    advance: SE2<f64>,
    advance_back: SE2<Interval>,
    omega: Interval,
}

impl Default for Vehicle {
    fn default() -> Self {
        Self::new()
    }
}

impl Vehicle {
    /// The vehicle of the paper.
    #[must_use]
    pub fn new() -> Self {
        let omega = Interval::decimal("0.4");
        let period = Interval::ratio(1, 100);
        let advance = Vector3::new(TURN_RATE * PERIOD_S, SPEED * PERIOD_S, 0.0);
        let back = Vector3::new(-period * omega, -period.scale(SPEED), Interval::ZERO);
        Self { advance: SE2::exp(&advance), advance_back: SE2::exp(&back), omega }
    }

    /// Simulates `steps` periods from [`INITIAL_POSE`] with noises of the given kind.
    ///
    /// # Errors
    /// [`TruthError`] if a step or an output cannot be proven to be one of the model.
    pub fn simulate<R: Rng>(&self, kind: NoiseKind, steps: usize, rng: &mut R) -> Result<Truth, TruthError> {
        let mut process = BoundedNoise::new(kind, PROCESS_BOUNDS);
        let mut measurement = BoundedNoise::new(kind, OUTPUT_BOUNDS);
        self.simulate_with(steps, 1.0, || {
            let output = measurement.draw(rng);
            (process.draw(rng), output)
        })
    }

    /// Simulates `steps` periods from [`INITIAL_POSE`] with noises `(w, v)` from `draw`, in boxes `excess` times those of the paper.
    ///
    /// # Errors
    /// [`TruthError`] if a step or an output cannot be proven to be one of the model with these bounds.
    pub fn simulate_with(
        &self,
        steps: usize,
        excess: f64,
        mut draw: impl FnMut() -> ([f64; 3], [f64; 2]),
    ) -> Result<Truth, TruthError> {
        let (process_bounds, output_bounds) = (PROCESS_BOUNDS.map(|b| excess * b), OUTPUT_BOUNDS.map(|b| excess * b));
        let mut states = vec![TruePose::new(INITIAL_POSE)];
        let mut outputs = Vec::with_capacity(steps);
        let mut state = TruePose::new(INITIAL_POSE);
        for step in 0..steps {
            let (process, output) = draw();
            outputs.push(measure(&state, output, output_bounds, step)?);
            let next = self.advance(&state, process);
            self.prove_step(&state, &next, process_bounds, step)?;
            states.push(next);
            state = next;
        }
        Ok(Truth { states, outputs })
    }

    /// A state near `X exp(delta u) exp(delta w)`.
    fn advance(&self, from: &TruePose, noise: [f64; 3]) -> TruePose {
        let heading = SE2::from_pose(from.heading.value(), 0.0, 0.0);
        let motion = self.advance.compose(&SE2::exp(&(PERIOD_S * Vector3::from(noise))));
        let step = heading.compose(&motion).translation();
        TruePose {
            heading: from.heading.moved_by(PERIOD_S * (TURN_RATE + noise[0])),
            position: [from.position[0].moved_by(step[0]), from.position[1].moved_by(step[1])],
        }
    }

    /// The process noise that leads from one state to the next: `w = log(exp(-delta u) X_k^-1 X_{k+1}) / delta`.
    ///
    /// **Guarantee:** contains the exact noise; none if the turn of the step can reach a half turn.
    #[must_use]
    pub fn noise_between(&self, from: &TruePose, to: &TruePose) -> Option<[Interval; 3]> {
        let turn = to.heading.difference(from.heading);
        let world =
            Vector2::new(to.position[0].difference(from.position[0]), to.position[1].difference(from.position[1]));
        // X_k^-1 X_{k+1}, from differences: its rounding does not grow with the distance from the origin.
        let body = SE2::from_pose(-from.heading.enclosure(), Interval::ZERO, Interval::ZERO).act(&world);
        let motion = SE2::from_pose(turn, body[0], body[1]);
        let noise = self.advance_back.compose(&motion).log().ok()?;
        // The heading part in closed form is tighter than through sine and cosine.
        let rate = Interval::point(100.0);
        Some([turn * rate - self.omega, noise[1] * rate, noise[2] * rate])
    }

    fn prove_step(&self, from: &TruePose, to: &TruePose, bounds: [f64; 3], step: usize) -> Result<(), TruthError> {
        let noise = self.noise_between(from, to).unwrap_or([Interval::ENTIRE; 3]);
        match (0..3).find(|&component| !proven_within(&noise[component], bounds[component])) {
            None => Ok(()),
            Some(component) => {
                let (bound, found) = (bounds[component], noise[component].mag());
                Err(TruthError::ProcessNoise { step, component, bound, found })
            }
        }
    }
}

/// The output of a state: the position plus noise within the bounds.
fn measure(state: &TruePose, noise: [f64; 2], bounds: [f64; 2], step: usize) -> Result<[f64; 2], TruthError> {
    let component = |component: usize| {
        let bound = bounds[component];
        output_within(&state.position[component].enclosure(), noise[component], bound).ok_or(TruthError::Output {
            step,
            component,
            bound,
        })
    };
    Ok([component(0)?, component(1)?])
}
