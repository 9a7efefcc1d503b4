//! A filter that follows the vehicle, and what is kept of a run.

use crate::ScenarioError;
use crate::metrics::{RunMetrics, RunSums, wrap_angle};
use crate::vehicle::{Pose, Truth};

/// A filter of the vehicle, of any mode.
pub trait Tracker {
    /// From the output of step `k` to the estimate of step `k + 1`.
    ///
    /// # Errors
    /// Those of the filter.
    fn step(&mut self, output: [f64; 2]) -> Result<(), ScenarioError>;

    /// Centre of the set.
    fn center(&self) -> Pose;

    /// Widths of the set's box `(theta, x1, x2)`: rad, m, m.
    fn widths(&self) -> [f64; 3];
}

/// The state of a filter after one step, beside the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackedStep {
    /// Centre of the set.
    pub center: Pose,
    /// Heading error of the centre, rad in `(-pi, pi]`.
    pub heading_error_rad: f64,
    /// Position error of the centre, m.
    pub position_error: [f64; 2],
    /// Widths of the box `(theta, x1, x2)`.
    pub widths: [f64; 3],
}

/// Runs a filter along the outputs of a truth and hands every state `k = 1..N` to `visit`.
///
/// # Errors
/// Those of the filter.
pub fn track(
    truth: &Truth,
    tracker: &mut dyn Tracker,
    mut visit: impl FnMut(usize, &TrackedStep),
) -> Result<RunMetrics, ScenarioError> {
    let mut sums = RunSums::default();
    for (k, output) in truth.outputs.iter().enumerate() {
        tracker.step(*output)?;
        let (state, center, widths) = (truth.states[k + 1].rounded(), tracker.center(), tracker.widths());
        let heading_error_rad = wrap_angle(state.heading_rad - center.heading_rad);
        let position_error = [state.position[0] - center.position[0], state.position[1] - center.position[1]];
        sums.add_step(heading_error_rad, position_error, widths);
        visit(k + 1, &TrackedStep { center, heading_error_rad, position_error, widths });
    }
    Ok(sums.metrics())
}

/// Runs a filter along a truth for its metrics alone.
///
/// # Errors
/// Those of the filter.
pub fn metrics_of(truth: &Truth, tracker: &mut dyn Tracker) -> Result<RunMetrics, ScenarioError> {
    track(truth, tracker, |_, _| {})
}
