//! One run in full, for the main figure: the filter of strips from an unknown heading, the paper's filters from an initial estimate.

use estimators::InvariantStrips;

use crate::guaranteed_invariant::follow::{Start, StripRun, StripStep};
use crate::guaranteed_invariant::noise::{Drive, truth_of};
use crate::guaranteed_invariant::planar::first_order_contenders;
use crate::inzsmf::cases::{STEPS, TABLE_I};
use crate::inzsmf::tracking::{TrackedStep, track};
use crate::vehicle::TruePose;
use crate::{Context, ScenarioError};

/// Steps whose polygons are kept.
pub const POLYGON_STEPS: [usize; 5] = [5, 20, 50, 200, 1000];
/// Directions of a polygon.
const DIRECTIONS: usize = 48;
/// Index in [`TABLE_I`] of the initial estimate of the paper's filters: its worst.
const CASE: usize = 5;

/// The filter of strips along one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Steps `0..=N`.
    pub steps: Vec<StripStep>,
    /// Vertices of the polygons at [`POLYGON_STEPS`], relative to the true position.
    pub polygons: Vec<Vec<[f64; 2]>>,
}

/// One of the paper's filters along the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Method and mode.
    pub name: String,
    /// Steps `1..=N`.
    pub steps: Vec<TrackedStep>,
}

/// All filters along one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Courses {
    /// The filter of strips.
    pub strips: Track,
    /// The paper's filters.
    pub references: Vec<Reference>,
}

/// Records the first run of a noise.
///
/// # Errors
/// Those of the filters.
pub fn record(context: &Context<'_>, drive: Drive) -> Result<Courses, ScenarioError> {
    let truth = truth_of(context, drive, 1.0, STEPS + 1, 0)?;
    let mut polygons = Vec::new();
    let run = StripRun::new(&truth, Start::UnknownHeading, |k, filter| {
        if POLYGON_STEPS.contains(&k) {
            polygons.push(polygon(filter, &truth.states[k])?);
        }
        Ok(())
    })?;
    let truth = truth_of(context, drive, 1.0, STEPS, 0)?;
    let mut references = Vec::new();
    for contender in first_order_contenders()? {
        let mut steps = Vec::with_capacity(STEPS);
        track(&truth, &mut *contender.start(TABLE_I[CASE].pose)?, |_, step| steps.push(*step))?;
        references.push(Reference { name: format!("{} {}", contender.method, contender.mode.name()), steps });
    }
    Ok(Courses { strips: Track { steps: run.steps, polygons }, references })
}

/// Vertices around the true position.
fn polygon(filter: &mut InvariantStrips, truth: &TruePose) -> Result<Vec<[f64; 2]>, ScenarioError> {
    let outline = filter.polygon(0, DIRECTIONS)?.to_v_polytope()?.outline_2d()?;
    let position = truth.rounded().position;
    let vertex = |j: usize| [outline.col(j)[0] - position[0], outline.col(j)[1] - position[1]];
    Ok((0..outline.cols()).map(vertex).collect())
}
