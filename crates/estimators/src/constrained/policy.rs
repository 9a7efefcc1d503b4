//! [`ReductionPolicy`]: when sets are reduced, and how far.

use setrep::{Complexity, ConstrainedZonotope, Reduction, SetError, Workspace};

/// After which parts of a step a set is reduced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum ReduceAfter {
    /// At the end of an update, after the consistency step: for the mean value extension, which adds few generators.
    EndOfStep,
    /// After the prediction, after the update, and after the consistency step: for the first-order extension, whose sets grow with the
    /// square of their size.
    EveryPart,
}

/// How the sets of a [`CzFilter`](crate::CzFilter) are kept small. It affects tightness and time, never validity.
///
/// Constraints are eliminated first, then generators reduced ([`ConstrainedZonotope::reduce`]). A set that has grown beyond the limit
/// for want of updates is also reduced before the next prediction.
///
/// Limits count ranged constraints and no slacks: the textbook form of a set within `(ng, nc)` has up to `ng + nc` generators.
///
/// **Source:** paper 003, Section 5; Scott, Raimondo, Marseglia, Braatz 2016.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ReductionPolicy {
    /// How large sets may be; `None`: they grow with every step, for a few steps only.
    pub limit: Option<Complexity>,
    /// When they are reduced.
    pub after: ReduceAfter,
    /// How generators are reduced.
    pub method: Reduction,
    /// How many eliminations are compared by the hulls they leave, of the last ones
    /// ([`ConstrainedZonotope::eliminate_comparing`]); 1: none, the paper's estimate decides.
    pub candidates: usize,
}

impl ReductionPolicy {
    /// The policy of the paper for its limits: Method 4 after the parts given.
    #[must_use]
    pub fn new(limit: Option<Complexity>, after: ReduceAfter) -> Self {
        Self { limit, after, method: Reduction::Method4, candidates: 1 }
    }

    /// Whether a set is larger than it may be after a step.
    pub(super) fn is_exceeded(&self, set: &ConstrainedZonotope) -> bool {
        let too_large =
            |limit: Complexity| set.num_generators() > limit.generators || set.num_constraints() > limit.constraints;
        self.limit.is_some_and(too_large)
    }

    /// Brings a set within the limit; what the box remainder holds of uncertainty becomes generators first.
    pub(super) fn apply(&self, set: &mut ConstrainedZonotope, workspace: &mut Workspace) -> Result<(), SetError> {
        set.materialize_model_size();
        match self.limit {
            Some(limit) => set.reduce_comparing(limit, self.method, self.candidates, workspace),
            None => Ok(()),
        }
    }
}
