//! Problem 3 of paper 002 under the truth contract: a vehicle with an unknown wheel scale `s` and an unknown antenna arm `X`.
//!
//! `theta+ = theta + dtheta + n_theta`, `x+ = x + s R(theta) (U + n_U)`, fixes `y = x + R(theta) X + v`; the increments `dtheta`, `U`
//! are measured, the noises bounded. As in [`crate::truth`], the states are numbers chosen near the model's, and every step is proven to need
//! noises within the bounds.

use rand::Rng;
use scalars::Interval;

use crate::noise::{BoundedNoise, NoiseKind};
use crate::truth::{TruthError, output_within, proven_within};
use crate::vehicle::{Pose, TruePose};

/// An increment measured by gyro and wheels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Increment {
    /// Turn, rad.
    pub turn_rad: f64,
    /// Displacement in the body frame of the start, before scaling, m.
    pub shift_m: [f64; 2],
}

/// Bounds on the noises of an increment and of a fix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// On the turn, rad.
    pub turn_rad: f64,
    /// On each component of the displacement before scaling, m.
    pub shift_m: [f64; 2],
    /// On each coordinate of a fix, m.
    pub fix_m: f64,
}

/// The constants that nobody knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Scale of the wheels.
    pub scale: f64,
    /// Antenna in the body frame, m.
    pub arm_m: [f64; 2],
}

/// One run: states `0..=N`, the increments between them, and fixes at some of the states.
///
/// **Guarantee:** the states are one exact trajectory of the model with noises in the bounds, and every fix is one of its outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct LeverTruth {
    /// The constants.
    pub constants: Constants,
    /// States, one more than increments.
    pub states: Vec<TruePose>,
    /// Measured increments.
    pub increments: Vec<Increment>,
    /// Index of the state and the fix there, m.
    pub fixes: Vec<(usize, [f64; 2])>,
}

/// Simulates a vehicle that follows `increments` from the pose zero, with a fix after every `fix_every` of them.
///
/// # Errors
/// [`TruthError`] if a step or a fix cannot be proven to be one of the model.
pub fn simulate(
    constants: Constants,
    increments: Vec<Increment>,
    fix_every: usize,
    (kind, bounds): (NoiseKind, &Bounds),
    rng: &mut impl Rng,
) -> Result<LeverTruth, TruthError> {
    let [b1, b2] = bounds.shift_m;
    let mut process = BoundedNoise::new(kind, [bounds.turn_rad, b1, b2]);
    let mut output = BoundedNoise::new(kind, [bounds.fix_m; 2]);
    let mut states = vec![TruePose::new(Pose { heading_rad: 0.0, position: [0.0; 2] })];
    let mut fixes = Vec::new();
    for (step, increment) in increments.iter().enumerate() {
        let from = states[step];
        let next = advance(&from, increment, constants.scale, process.draw(rng));
        prove(&from, &next, increment, constants.scale, bounds, step)?;
        states.push(next);
        if (step + 1) % fix_every == 0 {
            fixes.push((step + 1, fix(&next, &constants, output.draw(rng), bounds.fix_m, step + 1)?));
        }
    }
    Ok(LeverTruth { constants, states, increments, fixes })
}

/// A state near the model's.
fn advance(from: &TruePose, increment: &Increment, scale: f64, noise: [f64; 3]) -> TruePose {
    let (sin, cos) = from.heading.value().sin_cos();
    let body = [scale * (increment.shift_m[0] + noise[1]), scale * (increment.shift_m[1] + noise[2])];
    TruePose {
        heading: from.heading.moved_by(increment.turn_rad).moved_by(noise[0]),
        position: [
            from.position[0].moved_by(cos * body[0] - sin * body[1]),
            from.position[1].moved_by(sin * body[0] + cos * body[1]),
        ],
    }
}

/// The noise `(n_theta, n_U)` that leads from one state to the next. **Guarantee:** contains the exact noise.
#[must_use]
pub fn noise_between(from: &TruePose, to: &TruePose, increment: &Increment, scale: f64) -> [Interval; 3] {
    let turn = to.heading.difference(from.heading) - Interval::point(increment.turn_rad);
    let moved = [to.position[0].difference(from.position[0]), to.position[1].difference(from.position[1])];
    let (sin, cos) = from.heading.enclosure().sin_cos();
    let scale = Interval::point(scale);
    let along = (cos * moved[0] + sin * moved[1]) / scale;
    let across = (cos * moved[1] - sin * moved[0]) / scale;
    [turn, along - Interval::point(increment.shift_m[0]), across - Interval::point(increment.shift_m[1])]
}

/// Proves a step to be one of the model.
///
/// # Errors
/// [`TruthError::ProcessNoise`] naming the component that is not proven to keep its bound.
pub fn prove(
    from: &TruePose,
    to: &TruePose,
    increment: &Increment,
    scale: f64,
    bounds: &Bounds,
    step: usize,
) -> Result<(), TruthError> {
    let noise = noise_between(from, to, increment, scale);
    let bounds = [bounds.turn_rad, bounds.shift_m[0], bounds.shift_m[1]];
    match (0..3).find(|&component| !proven_within(&noise[component], bounds[component])) {
        None => Ok(()),
        Some(component) => {
            let (bound, found) = (bounds[component], noise[component].mag());
            Err(TruthError::ProcessNoise { step, component, bound, found })
        }
    }
}

/// Position of the antenna. **Guarantee:** contains it.
#[must_use]
pub fn antenna(state: &TruePose, constants: &Constants) -> [Interval; 2] {
    let [theta, x1, x2] = state.coordinates();
    let (sin, cos) = theta.sin_cos();
    let [a, b] = constants.arm_m.map(Interval::point);
    [x1 + cos * a - sin * b, x2 + sin * a + cos * b]
}

/// The fix near the antenna plus noise.
///
/// # Errors
/// [`TruthError::Output`] if no float is proven to be within the bound.
pub fn fix(
    state: &TruePose,
    constants: &Constants,
    noise: [f64; 2],
    bound: f64,
    step: usize,
) -> Result<[f64; 2], TruthError> {
    let at = antenna(state, constants);
    let component = |component: usize| {
        let error = TruthError::Output { step, component, bound };
        output_within(&at[component], noise[component], bound).ok_or(error)
    };
    Ok([component(0)?, component(1)?])
}

#[cfg(test)]
mod tests {
    use crate::monte_carlo::stream;

    use super::*;

    const BOUNDS: Bounds = Bounds { turn_rad: 1e-4, shift_m: [2e-3; 2], fix_m: 0.1 };

    fn run(kind: NoiseKind) -> LeverTruth {
        let increments = vec![Increment { turn_rad: 0.06, shift_m: [0.4, 0.0] }; 300];
        let constants = Constants { scale: 1.2, arm_m: [-2.0, 1.0] };
        simulate(constants, increments, 10, (kind, &BOUNDS), &mut stream(1, "lever", 0)).unwrap()
    }

    /// Noises at the bounds are proven inside, and the states stay known to a few ulp.
    #[test]
    fn runs_are_proven_and_known() {
        for kind in [NoiseKind::Uniform, NoiseKind::ConstantVertex] {
            let truth = run(kind);
            assert_eq!((truth.states.len(), truth.fixes.len()), (301, 30));
            let widest = truth.states.iter().flat_map(TruePose::coordinates).map(|c| c.width()).fold(0.0, f64::max);
            assert!(widest < 1e-12, "{widest}");
        }
    }

    /// The scale multiplies the displacement: a circle of 1.2 * 0.4 / 0.06 m.
    #[test]
    fn the_scale_multiplies_the_circle() {
        let truth = run(NoiseKind::Uniform);
        let farthest = truth.states.iter().map(|state| state.rounded().position[1]).fold(0.0, f64::max);
        assert!((farthest - 16.0).abs() < 0.5, "{farthest}");
    }

    /// A step that needs more noise than allowed is refused.
    #[test]
    fn steps_beyond_the_bounds_are_refused() {
        let truth = run(NoiseKind::ConstantVertex);
        let tighter = Bounds { turn_rad: 0.99 * BOUNDS.turn_rad, ..BOUNDS };
        let (from, to) = (&truth.states[7], &truth.states[8]);
        let refused = prove(from, to, &truth.increments[7], 1.2, &tighter, 7);
        assert!(matches!(refused, Err(TruthError::ProcessNoise { step: 7, component: 0, .. })));
    }
}
