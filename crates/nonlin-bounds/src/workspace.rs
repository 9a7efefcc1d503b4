//! Scratch memory that the caller owns, so that enclosures in steady state allocate nothing.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::{Jet, Rows};

/// Buffers for the enclosures that take one. Grows to the largest use and is then reused; holds no result.
#[derive(Debug, Default, Clone)]
pub struct Workspace {
    /// The buffers of operations on sets.
    pub sets: setrep::Workspace,
    /// Derivatives over a box.
    pub(crate) over_box: Jet,
    /// Derivatives at the expansion point.
    pub(crate) at_point: Jet,
    /// Derivatives with the states at the expansion point and the noises in the box.
    pub(crate) noise_at_point: Jet,
    /// A point as a box, a box about the expansion point, a row of slopes, a row of a matrix.
    pub(crate) point: Vec<Interval>,
    pub(crate) steps: Vec<Interval>,
    pub(crate) slopes: Vec<Interval>,
    pub(crate) row: Vec<f64>,
    /// An affine enclosure being built.
    pub(crate) jacobian: Matrix,
    pub(crate) offsets: Vec<Interval>,
    /// Part of a matrix, rows of a solution set, sets being changed.
    pub(crate) map: Matrix,
    pub(crate) rows: Rows,
    pub(crate) zonotope: Option<Zonotope>,
    pub(crate) constrained: Option<ConstrainedZonotope>,
    /// A quadratic enclosure being built.
    pub(crate) quadratic: crate::quadratic::Parts,
    /// A set whose constraints are being eliminated, to find its expansion point.
    pub(crate) eliminated: Option<ConstrainedZonotope>,
    /// The derivatives of the function at hand.
    pub(crate) jet: Jet,
    /// The buffers of ranges.
    pub(crate) range: crate::range::Scratch,
    /// The buffers of the contractors.
    pub(crate) contract: crate::contract::Scratch,
    /// The buffers of reverse-mode derivatives.
    pub(crate) adjoint: crate::tape::AdjointBuffers,
}

impl Workspace {
    /// An empty workspace.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}
