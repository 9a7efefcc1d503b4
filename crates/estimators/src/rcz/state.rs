//! What an [`Rcz`](crate::Rcz) filter knows between calls.

use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Directions, Reduction, Reencoding, SetError, Workspace};

use super::options::{RczOptions, Tier};
use crate::EstimatorError;

/// Share of a candidate direction's width that ends the choice of constraints.
const STOP_RATIO: f64 = 0.98;

/// The set of states, its hull and what the next reduction starts from: all that has to be saved to go on later.
///
/// The state lies in the set **and** in the hull, which may be tighter than the set's own after a reduction.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RczState {
    /// The set.
    pub set: ConstrainedZonotope,
    /// A box that holds the state as well.
    pub hull: Vec<Interval>,
    /// Directions in which the set is kept tight.
    pub directions: Directions,
    /// Number of predictions so far.
    pub step: u64,
    /// Number of predictions since the last reduction.
    pub unreduced: usize,
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for RczState {
    fn clone(&self) -> Self {
        let Self { set, hull, directions, step, unreduced } = self;
        let (set, hull, directions) = (set.clone(), hull.clone(), directions.clone());
        Self { set, hull, directions, step: *step, unreduced: *unreduced }
    }

    fn clone_from(&mut self, source: &Self) {
        self.set.clone_from(&source.set);
        self.hull.clone_from(&source.hull);
        self.directions.clone_from(&source.directions);
        (self.step, self.unreduced) = (source.step, source.unreduced);
    }
}

impl RczState {
    /// The first state: a set and its hull.
    pub(super) fn new(set: ConstrainedZonotope, workspace: &mut Workspace) -> Result<Self, EstimatorError> {
        let hull = set.interval_hull(workspace)?.to_vec();
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet.into());
        }
        let directions = Directions::new(set.dim());
        Ok(Self { set, hull, directions, step: 0, unreduced: 0 })
    }

    /// Whether the set is to be reduced before it moves on; `noises` columns come with a step.
    pub(super) fn is_due(&self, options: &RczOptions, noises: usize) -> bool {
        let columns = (options.reduce_every + 2) * (self.set.dim() + noises);
        self.unreduced >= options.reduce_every.max(1) || self.set.num_generators() > columns
    }

    /// Whether the set has more constraints than `rows` an update can have left since the last reduction that was due: several updates
    /// have come without a prediction between them.
    pub(super) fn is_crowded(&self, options: &RczOptions, rows: usize) -> bool {
        self.set.num_constraints() > options.constraints + (options.reduce_every + 2) * rows
    }

    /// Encloses the set in a small one; the hull stays.
    pub(super) fn reduce(&mut self, options: &RczOptions, workspace: &mut Workspace) -> Result<(), EstimatorError> {
        match options.tier {
            Tier::LinearPrograms => {
                let mut encoding = Reencoding::new(options.constraints);
                (encoding.stop_ratio, encoding.widths) = (STOP_RATIO, options.widths);
                self.set.reencode(encoding, &mut self.directions, workspace)?;
            }
            Tier::Rescaling => {
                let generators = 2 * self.set.dim() + options.constraints;
                let limit = Complexity { generators, constraints: options.constraints };
                self.set.reduce(limit, Reduction::Method4, workspace)?;
                self.directions.clear();
            }
        }
        self.unreduced = 0;
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
}
