//! Propositions 1 to 4: is the error a function of itself?
//!
//! One error is put on [`ESTIMATES`] random estimates. After the same step, in the innovation of the same measurement, and after an update by the same gain
//! it must come out the same on all of them; the table has the largest difference.

use estimators::Left;
use estimators::kalman::wheels::{
    Drivable, ImperfectError, InvariantWheels, PlainError, TwoFrameError, WheelError, WheelState, WheelStep,
};
use estimators::kalman::{Chart, Motion, OnGroup};
use lie_groups::{RPlus, SE2, ScaledSO2, TfgLever2, TfgScaleLever2};
use nalgebra::{SMatrix, SVector, Vector2, Vector3};
use rand::{Rng, RngExt};

use crate::{Row, ScenarioError, monte_carlo};

/// Name of the table.
pub const AUTONOMY: &str = "Propositions 1 to 4";
/// Estimates that share an error.
pub const ESTIMATES: usize = 20;
/// The parts of a step.
const PARTS: [&str; 3] = ["propagation", "innovation", "update"];

/// A random number in `[-1, 1)`.
fn unit<R: Rng>(rng: &mut R) -> f64 {
    2.0 * rng.random::<f64>() - 1.0
}

pub(crate) fn vector<const N: usize, R: Rng>(rng: &mut R) -> SVector<f64, N> {
    SVector::from_fn(|_, _| unit(rng))
}

/// What is drawn: estimates, an error, a step and a gain.
struct Draw<P, const N: usize> {
    estimates: Vec<P>,
    error: SVector<f64, N>,
    step: WheelStep,
    gain: SMatrix<f64, N, 2>,
}

/// Draws in one order for all errors, so that errors of the same states see the same.
fn draw<P, const N: usize>(
    state: impl Fn(WheelState) -> Result<P, ScenarioError>,
) -> Result<Draw<P, N>, ScenarioError> {
    let rng = &mut monte_carlo::stream(8, "autonomy", 0);
    let step = WheelStep::new(unit(rng), 2.0 * vector(rng));
    let estimates = (0..ESTIMATES).map(|_| {
        let (heading, scale) = (3.0 * unit(rng), 1.1 + 0.8 * unit(rng));
        state(WheelState::new(heading, scale, 3.0 * vector(rng), 2.0 * vector(rng)))
    });
    let estimates = estimates.collect::<Result<_, _>>()?;
    Ok(Draw { estimates, error: 0.8 * vector(rng), step, gain: 0.3 * SMatrix::from_fn(|_, _| unit(rng)) })
}

/// Largest difference between two vectors of a list.
pub(crate) fn spread<const N: usize>(vectors: &[SVector<f64, N>]) -> f64 {
    vectors.iter().flat_map(|a| vectors.iter().map(move |b| (a - b).amax())).fold(0.0, f64::max)
}

/// The spreads of the three parts on a chart; `moved` is a step, `innovation` what an estimate makes of the true state's output.
fn spreads<C: Chart<N>, const N: usize>(
    draw: &Draw<C::Point, N>,
    moved: impl Fn(&C::Point, &WheelStep) -> C::Point,
    innovation: impl Fn(&C::Point, &C::Point) -> Vector2<f64>,
) -> Result<[f64; 3], ScenarioError> {
    let (mut after, mut innovations, mut updated) = (Vec::new(), Vec::new(), Vec::new());
    for estimate in &draw.estimates {
        let truth = C::shift(estimate, &draw.error);
        after.push(C::difference(&moved(&truth, &draw.step), &moved(estimate, &draw.step))?);
        let z = innovation(estimate, &truth);
        innovations.push(z);
        updated.push(C::difference(&truth, &C::shift(estimate, &(draw.gain * z)))?);
    }
    Ok([spread(&after), spread(&innovations), spread(&updated)])
}

/// The spreads of an error of Problem 3.
///
/// # Errors
/// Those of the logarithm.
pub fn of_error<C: WheelError>() -> Result<[f64; 3], ScenarioError> {
    spreads::<C, 6>(&draw(Ok)?, WheelState::moved, |estimate, truth| C::innovation(estimate, &truth.antenna()))
}

/// The spreads of the left-invariant error on a group; `Z = ghat^-1 * (y - yhat)`.
fn of_group<G: Drivable<N>, const N: usize>(
    state: impl Fn(WheelState) -> Result<G, ScenarioError>,
) -> Result<[f64; 3], ScenarioError> {
    let moved = |x: &G, step: &WheelStep| {
        Motion::<OnGroup<G, Left, 2>, N, 3>::transition(&InvariantWheels, x, step, &Vector3::zeros())
    };
    spreads::<OnGroup<G, Left, 2>, N>(&draw(state)?, moved, |estimate, truth| {
        estimate.inverse().act_linear() * (truth.antenna() - estimate.antenna())
    })
}

/// The rows.
///
/// # Errors
/// Those of the logarithms.
pub fn rows() -> Result<Vec<Row>, ScenarioError> {
    let pose = |state: WheelState| Ok(SE2::new(state.heading, &state.position));
    let lever = |state: WheelState| Ok(TfgLever2::new(state.heading, [state.position], [state.lever]));
    let scaled = |state: WheelState| {
        let frame = ScaledSO2::new(state.heading, RPlus::from_scale(state.scale)?);
        Ok(TfgScaleLever2::new(frame, [state.position], [state.lever / state.scale]))
    };
    let found: [(&str, &str, [f64; 3]); 6] = [
        ("Problem 1 on SE(2) (Proposition 1)", "iekf", of_group::<SE2<f64>, 3>(pose)?),
        ("Problem 2 on the TFG with lever arm (Proposition 2)", "iekf", of_group::<TfgLever2<f64>, 5>(lever)?),
        ("Problem 3 in X' = X / s (section V-C)", "iekf", of_group::<TfgScaleLever2<f64>, 6>(scaled)?),
        ("Problem 3 in its own variables (Propositions 3 and 4)", "tfg-iekf", of_error::<TwoFrameError>()?),
        ("Problem 3", "iekf-imperfect", of_error::<ImperfectError>()?),
        ("Problem 3", "ekf", of_error::<PlainError>()?),
    ];
    let rows = found.iter().flat_map(|(row, method, spreads)| {
        let spreads = PARTS.iter().zip(spreads);
        spreads.map(move |(part, spread)| Row::new(AUTONOMY, *row, *method).metric(*part, "").value(*spread))
    });
    Ok(rows.collect())
}
