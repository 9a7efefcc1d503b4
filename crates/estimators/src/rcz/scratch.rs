//! Buffers of an [`Rcz`](crate::Rcz) filter, and what is made in them.

use nonlin_bounds::{AffineEnclosure, Rows, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Directions, Matrix};

use crate::Culprit;
use crate::set_filter::Stacked;

/// Everything a step needs room for; grows once, is then reused and holds no result.
#[derive(Debug, Default, Clone)]
pub struct Scratch {
    pub(super) bounds: Workspace,
    pub(super) enclosure: AffineEnclosure,
    pub(super) rows: Rows,
    pub(super) stacked: Stacked,
    /// The hull of a set, before it is cut with another; that other; the hull at the begin of a pass.
    pub(super) own: Vec<Interval>,
    pub(super) held: Vec<Interval>,
    pub(super) before: Vec<Interval>,
    /// The set of the prediction without remainder, and with the rows of a pass.
    pub(super) base: Option<ConstrainedZonotope>,
    pub(super) trial: Option<ConstrainedZonotope>,
    /// Noises that mix the outputs.
    pub(super) noise: Option<ConstrainedZonotope>,
    /// Part of a Jacobian.
    pub(super) map: Matrix,
    /// What each row of the trial comes from, and the directions of its new rows.
    pub(super) culprits: Vec<Culprit>,
    pub(super) directions: Directions,
    /// Widths of the ranges of the new rows of the last pass.
    pub(super) widths: Vec<f64>,
}
