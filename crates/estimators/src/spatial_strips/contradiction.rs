//! Contradictions, and the measurements that make them.

use scalars::Interval;

use super::SpatialStrips;
use crate::invariant_strips::Origin;
use crate::{Culprit, EstimatorError, Evidence, Guarantee, Inconsistency};

impl SpatialStrips {
    /// What a row stands for.
    fn culprit(&self, row: usize) -> Culprit {
        match self.tags[row].origin {
            Origin::Measured { step, entry } if step == self.step && self.tags[row].born == self.instant => {
                Culprit::Measurement(entry)
            }
            Origin::Measured { step, entry } => Culprit::Earlier { step, entry },
            Origin::Bound | Origin::Derived => Culprit::Prediction,
        }
    }

    /// The last program left nothing of a cell, whose rows are those from `rows` on: an error if it is the only one.
    pub(super) fn refuted(&mut self, rows: usize) -> Result<(), EstimatorError> {
        if self.cells.len() > 1 {
            self.keep(rows);
            return Ok(());
        }
        match self.rows.contradiction().filter(|_| self.emptied) {
            Some(proof) => {
                let culprits = proof.rows().iter().map(|&i| self.culprit(i)).collect();
                let evidence = Evidence::HalfSpaces { proof: Box::new(proof.clone()) };
                let of_cell = proof.rows().iter().any(|&i| self.tags[i].origin == Origin::Derived);
                Err(if of_cell {
                    self.inconsistent_with_cell(culprits, evidence)
                } else {
                    self.inconsistent(culprits, evidence)
                })
            }
            None => Err(self.no_cell()),
        }
    }

    /// No cell is possible.
    pub(super) fn no_cell(&self) -> EstimatorError {
        self.contradiction(Evidence::Propagation { hull: self.enclosure.vectors.as_flattened().to_vec() })
    }

    /// The error of two enclosures of one quantity that are disjoint.
    pub(super) fn disjoint(&self, predicted: Interval, required: Interval) -> EstimatorError {
        self.contradiction(Evidence::Disjoint { predicted, required })
    }

    /// The error with the rows that carry the bounds of this contraction as culprits.
    fn contradiction(&self, evidence: Evidence) -> EstimatorError {
        // Derived rows, the last ones, may be gone: they stand for the prediction.
        let rows = self.suspects.iter().filter(|&&i| i < self.tags.len());
        self.inconsistent_with_cell(rows.map(|&i| self.culprit(i)).collect(), evidence)
    }

    /// The error with these culprits and all measurements of this instant that have carried a bound: the cells may be what they
    /// are by them.
    fn inconsistent_with_cell(&self, mut culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
        let used = (0..self.tags.len()).filter(|&i| self.tags[i].used == self.instant).map(|i| self.culprit(i));
        culprits.extend(used.filter(|culprit| matches!(culprit, Culprit::Measurement(_))));
        self.inconsistent(culprits, evidence)
    }

    /// The error with these culprits and the prediction, in order.
    fn inconsistent(&self, mut culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
        culprits.push(Culprit::Prediction);
        culprits.sort_unstable();
        culprits.dedup();
        let guarantee = Guarantee::Rigorous;
        EstimatorError::Inconsistent(Box::new(Inconsistency { step: self.step, culprits, evidence, guarantee }))
    }
}
