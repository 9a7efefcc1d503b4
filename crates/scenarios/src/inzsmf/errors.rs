//! The errors that stand for the truth in the coordinates of a filter, enclosed.
//!
//! A heading is known modulo full turns, so a pose has one error a turn: `(e_theta + 2 pi j, e_x)` in the world, and in the body
//! the logarithms of all branches, `(theta + 2 pi j, V(theta + 2 pi j)^-1 x)`. A set of errors contains the pose if it contains any of them.

use lie_groups::{LieGroup, SE2};
use scalars::Interval;

use crate::ScenarioError;
use crate::vehicle::{Pose, TruePose};

/// Enclosure of a tangent or difference vector.
pub type Error = [Interval; 3];

/// `x - xhat` in the world frame, for every turn whose heading error may lie within `reach_rad`; the smallest first.
#[must_use]
pub fn euclidean_errors(truth: &TruePose, center: &Pose, reach_rad: f64) -> Vec<Error> {
    let [theta, x1, x2] = truth.coordinates();
    let heading = theta - Interval::point(center.heading_rad);
    let position = [x1 - Interval::point(center.position[0]), x2 - Interval::point(center.position[1])];
    let turns = (heading.mid() / std::f64::consts::TAU).round();
    let principal = heading - full_turns(turns);
    branches(principal, reach_rad).map(|heading| [heading, position[0], position[1]]).collect()
}

/// `log(Xhat^-1 X)` in the body frame, for every turn whose heading error may lie within `reach_rad`; the principal one first.
///
/// # Errors
/// [`ScenarioError::Group`] if the heading error can be half a turn, where the principal logarithm jumps.
pub fn invariant_errors(truth: &TruePose, center: &SE2<Interval>, reach_rad: f64) -> Result<Vec<Error>, ScenarioError> {
    let error = center.inverse().compose(&truth.enclosure());
    let principal = error.log()?;
    let translation = error.translation();
    let of_branch = |heading: Interval| {
        // V(theta)^-1 = (theta / 2) [cot 1; -1 cot], cot of half the angle.
        let half = heading.scale(0.5);
        let (sin, cos) = half.sin_cos();
        let cot = cos / sin;
        [heading, half * (cot * translation[0] + translation[1]), half * (cot * translation[1] - translation[0])]
    };
    let mut errors = vec![[principal[0], principal[1], principal[2]]];
    errors.extend(branches(principal[0], reach_rad).skip(1).map(of_branch));
    Ok(errors)
}

/// `2 pi turns`, enclosed.
fn full_turns(turns: f64) -> Interval {
    Interval::PI.scale(2.0).scale(turns)
}

/// Turns looked at to either side: a set that reaches farther says nothing about the heading, and the turns near zero decide.
const MOST_TURNS: i32 = 64;

/// The heading and its shifts by full turns that may lie in `[-reach, reach]`; the heading itself first.
fn branches(heading: Interval, reach_rad: f64) -> impl Iterator<Item = Interval> {
    let most = ((reach_rad / std::f64::consts::TAU + 0.5).ceil() as i32).min(MOST_TURNS);
    let shifts = (1..=most).flat_map(|turns| [turns, -turns]).map(f64::from);
    let shifted = shifts.map(move |turns| heading + full_turns(turns)).filter(move |h| h.mig() <= reach_rad);
    std::iter::once(heading).chain(shifted)
}
