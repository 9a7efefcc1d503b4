//! [`Inconsistency`]: a proof that measurements, invariants and bounds contradict each other.

use std::fmt;

use scalars::Interval;
use setrep::{ConstrainedZonotope, Contradiction, RowContradiction};

use crate::set_filter::Stacked;
use crate::{Case, Guarantee, System};

/// What takes part in a contradiction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Culprit {
    /// An entry of the measurement of this step.
    Measurement(usize),
    /// An entry of the invariant.
    Invariant(usize),
    /// One of the strips that a filter was told contain every state.
    Feasible(usize),
    /// An entry of the measurements of an earlier step, by a filter that keeps them.
    Earlier {
        /// Number of predictions before the measurement.
        step: u64,
        /// The entry.
        entry: usize,
    },
    /// The set before the update: the model, its noise bounds and all that was measured before.
    Prediction,
}

impl fmt::Display for Culprit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Measurement(index) => write!(f, "measurement {index}"),
            Self::Invariant(index) => write!(f, "invariant {index}"),
            Self::Feasible(index) => write!(f, "feasible strip {index}"),
            Self::Earlier { step, entry } => write!(f, "measurement {entry} of step {step}"),
            Self::Prediction => f.write_str("prediction"),
        }
    }
}

/// What proves that no state is left.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Evidence {
    /// Two enclosures of one quantity that have no point in common.
    Disjoint {
        /// Where the prediction puts it.
        predicted: Interval,
        /// Where the measurement or the invariant puts it.
        required: Interval,
    },
    /// Bounds over this box of states left nothing: a measurement past it, or bounds of the cut set that cross. The filter run again shows
    /// it.
    Propagation {
        /// The box.
        hull: Vec<Interval>,
    },
    /// No state of a box gives the measurement, or the invariant, a value that is required of it: propagation through its tape leaves
    /// nothing, or it is defined nowhere in the box. [`Inconsistency::verify_with`] checks it again.
    Values {
        /// The box that holds the state.
        hull: Vec<Interval>,
        /// Whether it is the invariant.
        invariant: bool,
        /// What is required of each entry; unbounded where nothing is.
        required: Vec<Interval>,
        /// The parameters of the measurement.
        parameters: Vec<Interval>,
    },
    /// Rows without a common point, among them past measurements; the proof carries them.
    HalfSpaces {
        /// Rows and multipliers.
        proof: Box<RowContradiction>,
    },
    /// A quantity lies in `cover`, and in none of the intervals of the cases, which leave nothing of it.
    Cases {
        /// Where the quantity is: a heading in rad.
        cover: Interval,
        /// What excludes it part by part.
        cases: Vec<Case>,
    },
    /// Multipliers of the constraints of a set that prove it empty; [`Contradiction::verify`] checks them again.
    Rows {
        /// The set that is empty: the prediction with the rows of the update.
        set: Box<ConstrainedZonotope>,
        /// The multipliers.
        certificate: Contradiction,
    },
}

impl Evidence {
    /// [`Inconsistency::margin`]; of cases the least.
    pub(crate) fn margin(&self) -> f64 {
        match self {
            Self::Disjoint { predicted, required } => {
                if predicted.is_empty() || required.is_empty() {
                    return 0.0;
                }
                (required.lo() - predicted.hi()).max(predicted.lo() - required.hi())
            }
            Self::Propagation { .. } | Self::Values { .. } => 0.0,
            Self::HalfSpaces { proof } => proof.miss(),
            Self::Cases { cases, .. } => {
                let least = cases.iter().map(|case| case.evidence.margin()).fold(f64::INFINITY, f64::min);
                if cases.is_empty() { 0.0 } else { least }
            }
            Self::Rows { set, certificate } => certificate.miss(set),
        }
    }

    /// Whether it is a proof, from the data it carries alone.
    pub(crate) fn verify(&self) -> bool {
        match self {
            Self::Disjoint { predicted, required } => {
                !predicted.is_empty() && !required.is_empty() && predicted.disjoint(required)
            }
            Self::Propagation { .. } | Self::Values { .. } => false,
            Self::HalfSpaces { proof } => proof.verify(),
            Self::Cases { cover, cases } => {
                Case::leave_nothing(cover, cases) && cases.iter().all(|case| case.evidence.verify())
            }
            Self::Rows { set, certificate } => certificate.verify(set),
        }
    }
}

/// A proven contradiction. The filter that reports it keeps its predicted set.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Inconsistency {
    /// Number of predictions so far.
    pub step: u64,
    /// What contradicts each other, in order. Entries of measurement and invariant without a part in the proof are left out; the
    /// prediction has one in nearly every proof, and is always named.
    pub culprits: Vec<Culprit>,
    /// The proof.
    pub evidence: Evidence,
    /// What the sets of the filter promise. Where that is not [`Guarantee::Rigorous`], only the simplified model of the filter is refuted.
    pub guarantee: Guarantee,
}

impl Inconsistency {
    /// By how much the contradiction is missed: the distance of the two intervals, or how far every point is from the range of some row of
    /// 1-norm 1. Positive for these proofs; 0 where propagation found it, which measures nothing.
    #[must_use]
    pub fn margin(&self) -> f64 {
        self.evidence.margin()
    }

    /// Checks the proof again, from the data it carries; false for [`Evidence::Propagation`], for [`Evidence::Values`], which needs the
    /// system as well, and for filters that are not rigorous.
    ///
    /// **Guarantee:** true only for a proof.
    #[must_use]
    pub fn verify(&self) -> bool {
        self.guarantee == Guarantee::Rigorous && self.evidence.verify()
    }

    /// As [`verify`](Self::verify), and for [`Evidence::Values`] by propagation and evaluation over its box again, with the functions and noises
    /// of `system`, which have to be those of the update.
    ///
    /// **Guarantee:** true only for a proof.
    #[must_use]
    pub fn verify_with(&self, system: &System) -> bool {
        match &self.evidence {
            Evidence::Values { hull, invariant, required, parameters } if self.guarantee == Guarantee::Rigorous => {
                let (relation, noise) = if *invariant {
                    let Some(invariant) = system.invariant() else { return false };
                    (invariant.relation(), None)
                } else {
                    (system.measurement(), Some(system.measurement_noise()))
                };
                let mut stacked = Stacked::default();
                stacked.fill(hull, noise).is_ok() && relation.excludes(&mut stacked.sides, required, parameters)
            }
            _ => self.verify(),
        }
    }
}

impl fmt::Display for Inconsistency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "step {}: ", self.step)?;
        for (k, culprit) in self.culprits.iter().enumerate() {
            write!(f, "{}{culprit}", if k == 0 { "" } else { ", " })?;
        }
        write!(f, " contradict each other, margin {:.2e}", self.margin())
    }
}
