//! [`CzOptions`]: which of the paper's estimators a filter is.

use nonlin_bounds::{Copies, Expansion};
use setrep::{Complexity, Strip};

use super::policy::{ReduceAfter, ReductionPolicy};

/// How functions are enclosed on a zonotope or a constrained zonotope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Extension {
    /// The mean value theorem: Propositions 1 and 3, Corollary 1. Needs `C1` and Jacobians; adds as many generators as outputs.
    MeanValue,
    /// Taylor's theorem of first order, whose quadratic term is a set of its own: Propositions 2 and 4, Corollary 2. Needs `C2` and
    /// Hessians; adds generators and constraints for all pairs of those of the set. Functions that are not `C2` on the hull fall back to
    /// the mean value theorem.
    FirstOrder,
}

/// What bounds `x - gamma` in the remainder `P` of the mean value extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Inclusion {
    /// The zonotope that is left when all constraints are eliminated, as in Theorem 1 and Remark 2.
    Elimination,
    /// The interval hull, which is at hand: never wider.
    Hull,
}

/// How the quadratic term of the first-order extension enters an update.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Curvature {
    /// With its generators and constraints, as the paper has it: exact before a reduction, but then most of it is lost with parts of the set.
    Generators,
    /// By its interval hull, which widens the rows: tighter once sets are reduced, and faster.
    Hull,
}

/// Options of a [`CzFilter`](crate::CzFilter). They affect tightness and time, never validity, but for [`feasible`](Self::feasible), which is a
/// promise about the states.
///
/// | estimator of the paper | options |
/// |---|---|
/// | CZMV, CZFO | [`CzOptions::czmv`], [`CzOptions::czfo`] |
/// | CZMV+C, CZFO+C | [`consistency`](Self::consistency) on |
/// | CZMV+F, CZFO+F | [`feasible`](Self::feasible) given |
/// | CZMV+FC, CZFO+FC | both |
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CzOptions {
    /// How functions are enclosed.
    pub extension: Extension,
    /// The expansion point `gamma` for the states (for noises it is the center): C1, C2 or C3 of Section 4.4.
    #[cfg_attr(feature = "serde", serde(with = "crate::remote::StoredExpansion"))]
    pub expansion: Expansion<'static>,
    /// The bound in the remainder of the mean value extension.
    pub inclusion: Inclusion,
    /// The coordinates of the cross term of the first-order extension.
    #[cfg_attr(feature = "serde", serde(with = "crate::remote::StoredCopies"))]
    pub copies: Copies,
    /// How the quadratic term of the first-order extension enters an update.
    pub curvature: Curvature,
    /// "+C": whether an update ends with the consistency step, which cuts the set with the invariant of the system. A system without an
    /// invariant has nothing to cut with.
    pub consistency: bool,
    /// "+F": strips that are known to contain every state, an enclosure of the feasible states. An update cuts with them before the
    /// consistency step (Remark 11).
    pub feasible: Vec<Strip>,
    /// How sets are kept small.
    pub reduction: ReductionPolicy,
    /// Whether the hull of a set is cut with that from before a reduction, which still holds the state. The paper does not.
    pub keep_hull: bool,
}

impl CzOptions {
    /// CZMV: the mean value extension about C2, reduced at the end of a step; with `None` sets are never reduced.
    #[must_use]
    pub fn czmv(limit: Option<Complexity>) -> Self {
        Self {
            extension: Extension::MeanValue,
            expansion: Expansion::EliminationCenter,
            inclusion: Inclusion::Elimination,
            copies: Copies::Shared,
            curvature: Curvature::Hull,
            consistency: false,
            feasible: Vec::new(),
            reduction: ReductionPolicy::new(limit, ReduceAfter::EndOfStep),
            keep_hull: false,
        }
    }

    /// CZFO: the first-order extension about C3, reduced after every part of a step; with `None` sets are never reduced, and soon too large.
    ///
    /// In updates the quadratic term enters by its hull; [`Curvature::Generators`] is the paper's.
    #[must_use]
    pub fn czfo(limit: Option<Complexity>) -> Self {
        Self {
            extension: Extension::FirstOrder,
            expansion: Expansion::SetCenter,
            reduction: ReductionPolicy::new(limit, ReduceAfter::EveryPart),
            ..Self::czmv(limit)
        }
    }

    /// The same with eliminations that compare some candidates ([`ReductionPolicy::candidates`]): tighter for CZFO, whose sets have a hundred
    /// columns and more, of which the paper's estimate knows little. Four are a good choice.
    #[must_use]
    pub fn with_candidates(mut self, candidates: usize) -> Self {
        self.reduction.candidates = candidates;
        self
    }

    /// The same with the consistency step: "+C".
    #[must_use]
    pub fn with_consistency(self) -> Self {
        Self { consistency: true, ..self }
    }

    /// The same with strips that contain every state: "+F".
    #[must_use]
    pub fn with_feasible(self, feasible: Vec<Strip>) -> Self {
        Self { feasible, ..self }
    }
}
