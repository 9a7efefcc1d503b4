//! Buffers of an [`Rcz`](crate::Rcz) filter, and what is made in them.

use nonlin_bounds::{AffineEnclosure, Rows, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Directions, Matrix, Zonotope};

use crate::{Culprit, EstimatorError};

/// Everything a step needs room for; grows once, is then reused and holds no result.
#[derive(Debug, Default, Clone)]
pub(super) struct Scratch {
    pub(super) bounds: Workspace,
    pub(super) enclosure: AffineEnclosure,
    pub(super) rows: Rows,
    /// States and noises, and the middle of that box.
    pub(super) sides: Vec<Interval>,
    pub(super) point: Vec<f64>,
    pub(super) parameters: Vec<Interval>,
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
}

impl Scratch {
    /// The box of states and noises, and its middle.
    pub(super) fn stack(&mut self, hull: &[Interval], noise: Option<&Zonotope>) -> Result<(), EstimatorError> {
        self.sides.clear();
        self.sides.extend_from_slice(hull);
        if let Some(noise) = noise {
            self.sides.resize(hull.len() + noise.dim(), Interval::ZERO);
            noise.interval_hull_into(&mut self.sides[hull.len()..])?;
        }
        self.point.clear();
        self.point.extend(self.sides.iter().map(Interval::mid));
        Ok(())
    }

    /// Known numbers as parameters.
    pub(super) fn set_parameters(&mut self, p: &[f64]) {
        self.parameters.clear();
        self.parameters.extend(p.iter().map(|&p| Interval::point(p)));
    }
}

/// Fills the storage of an optional set.
pub(super) fn store<'a>(
    slot: &'a mut Option<ConstrainedZonotope>,
    source: &ConstrainedZonotope,
) -> &'a mut ConstrainedZonotope {
    match slot {
        Some(set) => {
            set.clone_from(source);
            set
        }
        None => slot.insert(source.clone()),
    }
}

/// Whether a noise acts along axes: its box is then the noise itself.
pub(super) fn is_box(noise: &Zonotope) -> bool {
    noise.generators().columns().all(|column| column.iter().filter(|g| **g != 0.0).count() <= 1)
}
