//! Contradictions, and the measurements that make them.

use scalars::Interval;

use super::InvariantStrips;
use super::tags::Origin;
use crate::{Culprit, EstimatorError, Evidence, Guarantee, Inconsistency};

impl InvariantStrips {
    /// What a row stands for.
    pub(super) fn culprit(&self, row: usize) -> Culprit {
        match self.tags[row].origin {
            Origin::Measured { step, entry } if step == self.step && self.tags[row].born == self.instant => {
                Culprit::Measurement(entry)
            }
            Origin::Measured { step, entry } => Culprit::Earlier { step, entry },
            Origin::Bound | Origin::Derived => Culprit::Prediction,
        }
    }

    /// The error of two enclosures of one quantity that are disjoint.
    pub(super) fn disjoint(&self, predicted: Interval, required: Interval) -> EstimatorError {
        self.contradiction(Evidence::Disjoint { predicted, required })
    }

    /// The error with the rows that carry the bounds of this contraction as culprits, beside the prediction.
    pub(super) fn contradiction(&self, evidence: Evidence) -> EstimatorError {
        // Derived rows, the last ones, may be gone: they stand for the prediction.
        let rows = self.suspects.iter().filter(|&&i| i < self.tags.len());
        let mut culprits: Vec<Culprit> = rows.map(|&i| self.culprit(i)).collect();
        culprits.push(Culprit::Prediction);
        self.inconsistent(culprits, evidence)
    }

    /// The error with these culprits, in order.
    pub(super) fn inconsistent(&self, mut culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
        culprits.sort_unstable();
        culprits.dedup();
        let guarantee = Guarantee::Rigorous;
        EstimatorError::Inconsistent(Box::new(Inconsistency { step: self.step, culprits, evidence, guarantee }))
    }
}
