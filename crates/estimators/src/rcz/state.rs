//! What an [`Rcz`](crate::Rcz) filter knows between calls.

use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Directions, Reduction, Reencoding, SetError, Workspace};

use super::options::{RczOptions, Tier};
use crate::{EstimatorError, FilterState};

/// Share of a candidate direction's width that ends the choice of constraints.
const STOP_RATIO: f64 = 0.98;

/// The set of states, its hull and what the next reduction starts from.
pub type RczState = FilterState<ConstrainedZonotope, RczMemory>;

/// What the next reduction of an [`Rcz`](crate::Rcz) filter starts from.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RczMemory {
    /// Directions in which the set is kept tight.
    pub directions: Directions,
    /// Number of predictions since the last reduction.
    pub unreduced: usize,
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for RczMemory {
    fn clone(&self) -> Self {
        Self { directions: self.directions.clone(), unreduced: self.unreduced }
    }

    fn clone_from(&mut self, source: &Self) {
        self.directions.clone_from(&source.directions);
        self.unreduced = source.unreduced;
    }
}

/// The first state: a set and its hull.
pub(super) fn start(set: ConstrainedZonotope, workspace: &mut Workspace) -> Result<RczState, EstimatorError> {
    let hull = set.interval_hull(workspace)?.to_vec();
    if hull.iter().any(Interval::is_empty) {
        return Err(SetError::EmptySet.into());
    }
    let memory = RczMemory { directions: Directions::new(set.dim()), unreduced: 0 };
    Ok(RczState { set, hull, step: 0, memory })
}

/// Whether the set is to be reduced before it moves on; `noises` columns come with a step.
pub(super) fn is_due(state: &RczState, options: &RczOptions, noises: usize) -> bool {
    let columns = (options.reduce_every + 2) * (state.set.dim() + noises);
    state.memory.unreduced >= options.reduce_every.max(1) || state.set.num_generators() > columns
}

/// Whether the set has more constraints than `rows` an update can have left since the last reduction that was due: several updates
/// have come without a prediction between them.
pub(super) fn is_crowded(state: &RczState, options: &RczOptions, rows: usize) -> bool {
    state.set.num_constraints() > options.constraints + (options.reduce_every + 2) * rows
}

/// Encloses the set in a small one; the hull stays.
pub(super) fn reduce(
    state: &mut RczState,
    options: &RczOptions,
    workspace: &mut Workspace,
) -> Result<(), EstimatorError> {
    match options.tier {
        Tier::LinearPrograms => {
            let mut encoding = Reencoding::new(options.constraints);
            (encoding.stop_ratio, encoding.widths) = (STOP_RATIO, options.widths);
            state.set.reencode(encoding, &mut state.memory.directions, workspace)?;
        }
        Tier::Rescaling => {
            let generators = 2 * state.set.dim() + options.constraints;
            let limit = Complexity { generators, constraints: options.constraints };
            state.set.reduce(limit, Reduction::Method4, workspace)?;
            state.memory.directions.clear();
        }
    }
    state.memory.unreduced = 0;
    Ok(())
}

/// Writes the hull of a set as the tier finds it, in place of `hull`, cut with what `hull` held; an empty side means that
/// they have no point in common.
pub(super) fn cut_hull(
    set: &mut ConstrainedZonotope,
    hull: &mut [Interval],
    own: &mut Vec<Interval>,
    options: &RczOptions,
    workspace: &mut Workspace,
) -> Result<(), EstimatorError> {
    own.clear();
    own.resize(hull.len(), Interval::EMPTY);
    match options.tier {
        Tier::LinearPrograms => set.interval_hull_into(own, workspace)?,
        Tier::Rescaling => {
            set.rescale(workspace)?;
            set.unconstrained().interval_hull_into(own)?;
        }
    }
    hull.iter_mut().zip(own.iter()).for_each(|(side, found)| *side = side.intersection(*found));
    Ok(())
}
