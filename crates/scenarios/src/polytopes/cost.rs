//! What a step costs, in interval hulls of the same predicted set.

use std::hint::black_box;
use std::time::{Duration, Instant};

use estimators::{Estimator, Vh};
use setrep::{ConstrainedZonotope, Workspace};

use crate::set_study::Trajectory;
use crate::{Mode, Row, ScenarioError};

/// Repetitions, of which the fastest counts.
const REPETITIONS: usize = 30;

/// A step of V-H beside the interval hull of the predicted set as a constrained zonotope (its half-space form, a ranged constraint for each pair of
/// facets), in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// The step from `x_(k-1)` to `x_k`.
    pub step: usize,
    /// Prediction and update.
    pub filter: f64,
    /// One interval hull.
    pub hull: f64,
    /// Vertices of the predicted set.
    pub vertices: usize,
}

impl Cost {
    /// Their ratio.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.filter / self.hull
    }
}

/// Times every step of a run, each on the filter's state there.
///
/// # Errors
/// Those of the filter and of the sets.
pub fn costs(trajectory: &Trajectory, mut filter: Vh) -> Result<Vec<Cost>, ScenarioError> {
    let mut costs = Vec::new();
    filter.update(&trajectory.outputs[0])?;
    for step in 1..trajectory.outputs.len() {
        let (input, output) = (&trajectory.inputs[step - 1], &trajectory.outputs[step]);
        let mut predicted = filter.clone();
        predicted.predict(input)?;
        let set = predicted.enclosure();
        let mut workspace = Workspace::new();
        let constrained = ConstrainedZonotope::from_h_polytope(&set.to_h_polytope()?, &mut workspace)?;
        let (mut fastest, mut hull) = (Duration::MAX, Duration::MAX);
        for _ in 0..REPETITIONS {
            let mut next = filter.clone();
            let start = Instant::now();
            next.predict(black_box(input))?;
            next.update(black_box(output))?;
            fastest = fastest.min(start.elapsed());
            let start = Instant::now();
            black_box(constrained.interval_hull(&mut workspace)?);
            hull = hull.min(start.elapsed());
        }
        let vertices = set.num_vertices();
        costs.push(Cost { step, filter: fastest.as_secs_f64(), hull: hull.as_secs_f64(), vertices });
        filter.predict(input)?;
        filter.update(output)?;
    }
    Ok(costs)
}

/// A line a step.
#[must_use]
pub fn cost_list(costs: &[Cost]) -> Vec<String> {
    let line = |cost: &Cost| {
        format!(
            "`k = {}`: {:.1} us, {:.0} hulls of {:.2} us, predicted set with {} vertices",
            cost.step,
            1e6 * cost.filter,
            cost.ratio(),
            1e6 * cost.hull,
            cost.vertices
        )
    };
    costs.iter().map(line).collect()
}

/// Rows of `timings.json`: the ratio of every step.
#[must_use]
pub fn cost_rows(table: &str, row: &str, costs: &[Cost]) -> Vec<Row> {
    let of = |cost: &Cost| {
        Row::new(table, row, "vh")
            .mode(Mode::Rigorous)
            .metric(format!("step/hull@{}", cost.step), "")
            .value(cost.ratio())
    };
    costs.iter().map(of).collect()
}
