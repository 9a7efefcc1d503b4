//! Simulation of the attitude under the truth contract.
//!
//! A float quaternion `q` stands for the state `q / |q|`, which lies on the unit sphere exactly and is known to a few ulp. Any two such
//! states are led into each other by a rate that (19) can be solved for, so every step is proven by the enclosure of its noise.

use rand::Rng;
use scalars::Interval;

use super::plant::{AttitudeOutput, RATE_NOISE, TRUE_START, next, true_rates};
use crate::ScenarioError;
use crate::noise::{BoxNoise, NoiseKind};
use crate::set_study::Trajectory;
use crate::set_study::trajectory::measure;
use crate::truth::{TruthError, proven_within};

/// A run of `steps` steps with measurement noises up to `noise`.
///
/// # Errors
/// [`ScenarioError::Truth`] if a step cannot be proven.
pub fn simulate<R: Rng>(noise: f64, kind: NoiseKind, steps: usize, rng: &mut R) -> Result<Trajectory, ScenarioError> {
    let bounds = [noise; 6];
    let (mut rates, mut output) = (BoxNoise::new(kind, &[RATE_NOISE; 3]), BoxNoise::new(kind, &bounds));
    let mut run = Trajectory::default();
    let mut quaternion = TRUE_START;
    let mut state = on_sphere(&quaternion);
    for k in 0..=steps {
        run.outputs.push(measure(&AttitudeOutput, &state, &output.draw(rng), &bounds, k)?);
        if k == steps {
            run.states.push(state);
            break;
        }
        let w = rates.draw(rng);
        let truth = true_rates(k + 1);
        let u = [truth[0] + w[0], truth[1] + w[1], truth[2] + w[2]];
        quaternion = next(&quaternion, &w, &u)?;
        let following = on_sphere(&quaternion);
        prove(&noise_between(&state, &following, &u), k)?;
        run.inputs.push(u.to_vec());
        run.states.push(std::mem::replace(&mut state, following.clone()));
    }
    Ok(run)
}

/// `q / |q|`.
fn on_sphere(q: &[f64; 4]) -> Vec<Interval> {
    let q = q.map(Interval::point);
    let length = q.iter().fold(Interval::ZERO, |sum, x| sum + x.sqr()).sqrt();
    q.iter().map(|&x| x / length).collect()
}

/// The errors of the measured rates `u` that lead from one unit quaternion to the next by less than a quarter turn.
///
/// `Omega(h) x` is linear in `h`; its columns `A_j(x)` are orthonormal and orthogonal to `x`. With (19) therefore
/// `m_j = -A_j(x)' x' = sinc(p) h_j`, `|m| = sin p`, and `h = (p / sin p) m` is half the turn, `u - w = (2 / T_s) h`.
///
/// **Guarantee:** contains the exact errors.
#[must_use]
pub fn noise_between(from: &[Interval], to: &[Interval], u: &[f64; 3]) -> [Interval; 3] {
    let [x0, x1, x2, x3] = [from[0], from[1], from[2], from[3]];
    let columns = [[x3, x2, -x1, -x0], [-x2, x3, x0, -x1], [x1, -x0, x3, -x2]];
    let m = columns.map(|column| -column.iter().zip(to).fold(Interval::ZERO, |sum, (a, x)| sum + *a * *x));
    let sine = (m[0].sqr() + m[1].sqr() + m[2].sqr()).sqrt();
    let stretch = sine.asin() / sine;
    let rate = |j: usize| m[j] * stretch * Interval::point(10.0);
    [0, 1, 2].map(|j| Interval::point(u[j]) - rate(j))
}

fn prove(noise: &[Interval; 3], step: usize) -> Result<(), TruthError> {
    match noise.iter().position(|w| !proven_within(w, RATE_NOISE)) {
        None => Ok(()),
        Some(component) => {
            Err(TruthError::ProcessNoise { step, component, bound: RATE_NOISE, found: noise[component].mag() })
        }
    }
}
