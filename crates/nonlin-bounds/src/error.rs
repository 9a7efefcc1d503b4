//! [`BoundError`]: what can go wrong when a function is enclosed.

use scalars::Interval;
use setrep::SetError;

use crate::{Jet, Smoothness};

/// The argument that an error is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Operand {
    /// The variables `x`.
    Variables,
    /// The parameters `p`.
    Parameters,
    /// The values `y`.
    Outputs,
    /// The point of expansion.
    ExpansionPoint,
    /// The interval hull handed in with a set.
    Hull,
}

impl std::fmt::Display for Operand {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Variables => "variables",
            Self::Parameters => "parameters",
            Self::Outputs => "outputs",
            Self::ExpansionPoint => "expansion point",
            Self::Hull => "hull",
        })
    }
}

/// Errors of ranges, derivatives and images. The caller's objects are as they were before the call.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BoundError {
    /// A slice of the wrong length.
    #[error("{operand}: expected {expected} entries, found {found}")]
    Dimension {
        /// Which argument.
        operand: Operand,
        /// What the function asks for.
        expected: usize,
        /// What was given.
        found: usize,
    },
    /// An entry that is NaN, infinite or an unbounded interval.
    #[error("{operand}: entry {index} is not finite")]
    NonFinite {
        /// Which argument.
        operand: Operand,
        /// Which entry.
        index: usize,
    },
    /// An empty interval in a box.
    #[error("{operand}: interval {index} is empty")]
    EmptyInterval {
        /// Which argument.
        operand: Operand,
        /// Which entry.
        index: usize,
    },
    /// The function is not proven smooth enough on the box for the theorem behind the method.
    #[error("output {output} is only proven {found:?} on the box, {required:?} is needed")]
    NotSmooth {
        /// Which output.
        output: usize,
        /// What the method needs.
        required: Smoothness,
        /// What the evaluation proved.
        found: Smoothness,
    },
    /// The function offers no derivatives of this order.
    #[error("derivatives of order {order} are not available")]
    OrderNotAvailable {
        /// The order asked for.
        order: usize,
    },
    /// A point of expansion outside the interval hull of its set.
    #[error("expansion point: entry {index} lies outside the hull")]
    OutsideHull {
        /// Which entry.
        index: usize,
    },
    /// A bound is not finite although the function is defined (a derivative that overflows).
    #[error("the bound of output {output} is not finite")]
    UnboundedResult {
        /// Which output.
        output: usize,
    },
    /// No set was found that the solutions of a differential equation do not leave during the step; a shorter one helps.
    #[error("no a-priori enclosure was found for a step of {step}")]
    NoAPrioriEnclosure {
        /// The step's largest magnitude.
        step: f64,
    },
    /// An operation on sets failed.
    #[error(transparent)]
    Set(#[from] SetError),
}

impl BoundError {
    /// `Ok` if `found == expected`.
    pub(crate) fn check_size(operand: Operand, expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self::Dimension { operand, expected, found }) }
    }

    /// `Ok` if a box has the right number of sides, each nonempty and bounded.
    pub(crate) fn check_box(operand: Operand, expected: usize, sides: &[Interval]) -> Result<(), Self> {
        Self::check_size(operand, expected, sides.len())?;
        match sides.iter().position(|side| !side.is_bounded()) {
            None => Ok(()),
            Some(index) if sides[index].is_empty() => Err(Self::EmptyInterval { operand, index }),
            Some(index) => Err(Self::NonFinite { operand, index }),
        }
    }

    /// Whether the same function may be enclosed on another box.
    pub(crate) fn is_of_the_box(&self) -> bool {
        matches!(
            self,
            Self::NotSmooth { .. }
                | Self::UnboundedResult { .. }
                | Self::NonFinite { .. }
                | Self::NoAPrioriEnclosure { .. }
        )
    }

    /// `Ok` if every output of a jet is proven to be as smooth as `required`.
    pub(crate) fn check_smooth(jet: &Jet, required: Smoothness) -> Result<(), Self> {
        Self::check_smooth_where(jet, required, |_| true)
    }

    /// As [`check_smooth`](Self::check_smooth) for the outputs that are asked for.
    pub(crate) fn check_smooth_where(
        jet: &Jet,
        required: Smoothness,
        is_asked_for: impl Fn(usize) -> bool,
    ) -> Result<(), Self> {
        let mut found = jet.smoothness().iter().enumerate();
        match found.position(|(output, &found)| found < required && is_asked_for(output)) {
            None => Ok(()),
            Some(output) => Err(Self::NotSmooth { output, required, found: jet.smoothness()[output] }),
        }
    }
}
