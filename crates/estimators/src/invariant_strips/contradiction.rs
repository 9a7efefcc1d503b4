//! Contradictions, and the measurements that make them.

use scalars::Interval;

use super::InvariantStrips;
use super::arc::TURN;
use super::plane::unit;
use super::tags::Origin;
use crate::{Case, Culprit, EstimatorError, Evidence, Guarantee, Inconsistency};

/// By how much caps are made smaller for their proofs: the contradiction of a whole cap is one of equality.
const INSIDE: f64 = 1e-9;

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

    /// The error with the rows that carry the bounds of this contraction as culprits.
    pub(super) fn contradiction(&self, evidence: Evidence) -> EstimatorError {
        // Derived rows, the last ones, may be gone: they stand for the prediction.
        let rows = self.suspects.iter().filter(|&&i| i < self.tags.len());
        self.inconsistent_with_arc(rows.map(|&i| self.culprit(i)).collect(), evidence)
    }

    /// The error with these culprits and all measurements of this instant that have carried a bound: arc, scale and arms may be
    /// what they are by them.
    pub(super) fn inconsistent_with_arc(&self, mut culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
        let used = (0..self.tags.len()).filter(|&i| self.tags[i].used == self.instant).map(|i| self.culprit(i));
        culprits.extend(used.filter(|culprit| matches!(culprit, Culprit::Measurement(_))));
        self.inconsistent(culprits, evidence)
    }

    /// Bounds have crossed without a proof that could be kept.
    pub(super) fn unproven(&self) -> Evidence {
        Evidence::Propagation { hull: self.enclosure.fixed.as_flattened().to_vec() }
    }

    /// The caps as cases: a heading within `r` of `psi` has `<z, e^{i psi}> >= s cos r`, which contradicts the rows.
    pub(super) fn evidence_of_caps(&mut self) -> Result<Evidence, EstimatorError> {
        let (cover, scale, rows) = (self.arc.angles(), self.enclosure.scale, self.rows.len());
        let mut cases = Vec::new();
        for k in 0..self.caps.len() {
            let cap = self.caps[k];
            let reach = cap.reach - INSIDE;
            if reach <= INSIDE {
                continue;
            }
            let cosine = Interval::point(reach).sin_cos().1.lo();
            let least = Interval::point(cosine).scale(if cosine < 0.0 { scale.hi() } else { scale.lo() });
            self.push_heading_row(unit(Interval::point(cap.center)).map(|t| -t), -least.lo())?;
            self.bound()?;
            if let Some(proof) = self.rows.contradiction().filter(|_| self.emptied) {
                for turns in [-1.0, 0.0, 1.0] {
                    // The rounding of two angles of at most some turns is far below the rest of INSIDE.
                    let part = Interval::point(cap.center + turns * TURN).inflate(reach - 0.5 * INSIDE);
                    if !part.disjoint(&cover) {
                        cases.push(Case { part, evidence: Evidence::HalfSpaces { proof: Box::new(proof.clone()) } });
                    }
                }
            }
            self.keep(rows);
        }
        let evidence = Evidence::Cases { cover, cases };
        Ok(if evidence.verify() { evidence } else { self.unproven() })
    }

    /// The error with these culprits and the prediction, in order.
    pub(super) fn inconsistent(&self, mut culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
        culprits.push(Culprit::Prediction);
        culprits.sort_unstable();
        culprits.dedup();
        let guarantee = Guarantee::Rigorous;
        EstimatorError::Inconsistent(Box::new(Inconsistency { step: self.step, culprits, evidence, guarantee }))
    }
}
