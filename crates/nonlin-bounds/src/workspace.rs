//! Scratch memory that the caller owns, so that enclosures in steady state allocate nothing.

use crate::Jet;

/// Buffers for the enclosures that take one. Grows to the largest use and is then reused; holds no result.
#[derive(Debug, Default, Clone)]
pub struct Workspace {
    /// The buffers of operations on sets.
    pub sets: setrep::Workspace,
    /// A set whose constraints are being eliminated, to find its expansion point.
    pub(crate) eliminated: Option<setrep::ConstrainedZonotope>,
    /// The derivatives of the function at hand.
    pub(crate) jet: Jet,
    /// The buffers of ranges.
    pub(crate) range: crate::range::Scratch,
}

impl Workspace {
    /// An empty workspace.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}
