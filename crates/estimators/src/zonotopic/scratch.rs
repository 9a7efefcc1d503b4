//! Buffers of a [`ZonotopeFilter`](crate::ZonotopeFilter), and where its predictions expand.

use nonlin_bounds::{AffineEnclosure, OutputStrip, QuadraticEnclosure, Rows, Workspace};
use scalars::Interval;
use setrep::Zonotope;

use super::State;
use crate::EstimatorError;
use crate::set_filter::Stacked;

/// Everything a step needs room for; grows once, is then reused and holds no result.
#[derive(Debug, Default, Clone)]
pub struct Scratch {
    pub(super) bounds: Workspace,
    pub(super) enclosure: AffineEnclosure,
    pub(super) quadratic: Option<QuadraticEnclosure>,
    pub(super) strip: OutputStrip,
    pub(super) rows: Rows,
    /// The direction of a strip.
    pub(super) direction: Vec<f64>,
    pub(super) stacked: Stacked,
    /// The set with the noises.
    pub(super) product: Option<Zonotope>,
    /// The hull of a set.
    pub(super) own: Vec<Interval>,
}

impl Scratch {
    /// The box of states and noises, and their centers as the point of expansion: those lie in the hulls, up to rounding.
    pub(super) fn about_centers(&mut self, state: &State, noise: Option<&Zonotope>) -> Result<(), EstimatorError> {
        self.stacked.fill(&state.hull, noise)?;
        let noise = noise.map_or(&[][..], Zonotope::center);
        let (centers, point) = (state.set.center().iter().chain(noise), &mut self.stacked.point);
        point.clear();
        point.extend(centers.zip(&self.stacked.sides).map(|(c, side)| c.clamp(side.lo(), side.hi())));
        Ok(())
    }
}
