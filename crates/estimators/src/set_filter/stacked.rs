//! [`Stacked`]: the box of states and noises that functions are enclosed over.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

use crate::EstimatorError;

/// A box of states, then noises, and its middle; a buffer.
#[derive(Debug, Default, Clone)]
pub(crate) struct Stacked {
    pub(crate) sides: Vec<Interval>,
    pub(crate) point: Vec<f64>,
}

impl Stacked {
    /// The box `hull x hull(noise)`, of the states alone without a noise.
    pub(crate) fn fill(&mut self, hull: &[Interval], noise: Option<&Zonotope>) -> Result<(), EstimatorError> {
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
}

/// Fills the storage of an optional set.
pub(crate) fn store<'a>(
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
pub(crate) fn is_box(noise: &Zonotope) -> bool {
    noise.generators().columns().all(|column| column.iter().filter(|g| **g != 0.0).count() <= 1)
}
