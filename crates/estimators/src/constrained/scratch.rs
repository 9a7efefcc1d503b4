//! Buffers of a [`CzFilter`](crate::CzFilter), and where functions are enclosed.

use nonlin_bounds::{AffineEnclosure, Domain, Expansion, QuadraticEnclosure, Rows, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use super::options::{CzOptions, Extension, Inclusion};
use crate::set_filter::{Stacked, store};
use crate::{Culprit, EstimatorError};

/// Everything a step needs room for; grows once, is then reused and holds no result.
#[derive(Debug, Default, Clone)]
pub struct Scratch {
    pub(super) bounds: Workspace,
    pub(super) enclosure: AffineEnclosure,
    pub(super) quadratic: Option<QuadraticEnclosure>,
    pub(super) rows: Rows,
    /// Where functions are enclosed.
    pub(super) place: Place,
    /// The set with the noises, or the noises as a set.
    pub(super) product: Option<ConstrainedZonotope>,
    /// The hull of a set.
    pub(super) own: Vec<Interval>,
    /// Strips as rows; a selection of coordinates.
    pub(super) map: Matrix,
    pub(super) ranges: Vec<Interval>,
    /// What each constraint of the set comes from.
    pub(super) culprits: Vec<Culprit>,
}

/// The box of states and noises, the expansion point in it, and what bounds the distance from it.
#[derive(Debug, Default, Clone)]
pub(super) struct Place {
    stacked: Stacked,
    reach: Vec<Interval>,
    widened: bool,
    noises: usize,
    /// The set without its constraints.
    free: Option<ConstrainedZonotope>,
}

impl Place {
    /// Chooses the expansion point for a set in `hull` and noises, and what bounds the distance from it for an `extension`: that of first
    /// order takes the hull.
    ///
    /// C2 and C3 minimise a weighted 1-norm of `c - gamma` over the hull, which is separable: the center is clamped to the hull, whatever
    /// the weights, and no linear program is needed.
    pub(super) fn choose(
        &mut self,
        options: &CzOptions,
        extension: Extension,
        (set, hull): (&ConstrainedZonotope, &[Interval]),
        noise: Option<&Zonotope>,
        workspace: &mut Workspace,
    ) -> Result<(), EstimatorError> {
        let n = hull.len();
        self.stacked.fill(hull, noise)?;
        self.noises = noise.map_or(0, Zonotope::dim);
        if let Some(noise) = noise {
            let (sides, point) = (&self.stacked.sides[n..], &mut self.stacked.point[n..]);
            Expansion::SetCenter.of_zonotope(noise, sides, point)?;
        }
        let mut expansion = options.expansion;
        let mut source = set;
        let by_elimination = extension == Extension::MeanValue && options.inclusion == Inclusion::Elimination;
        self.widened = by_elimination && set.num_constraints() > 0;
        if self.widened {
            let free = store(&mut self.free, set);
            free.eliminate_constraints(0, &mut workspace.sets)?;
            self.reach.clear();
            self.reach.extend_from_slice(&self.stacked.sides);
            free.unconstrained().interval_hull_into(&mut self.reach[..n])?;
            if expansion == Expansion::EliminationCenter {
                (expansion, source) = (Expansion::SetCenter, free);
            }
        }
        expansion.of_constrained(source, hull, workspace, &mut self.stacked.point[..n])?;
        Ok(())
    }

    /// The place as a domain.
    pub(super) fn domain<'a>(&'a self, parameters: &'a [Interval]) -> Domain<'a> {
        let domain = Domain::new(&self.stacked.sides, &self.stacked.point);
        let domain = domain.with_parameters(parameters).with_noises(self.noises);
        if self.widened { domain.with_reach(&self.reach) } else { domain }
    }
}

/// Projects a set of `n` states, stacked with noises, on the states.
pub(super) fn forget_noises(
    n: usize,
    product: &mut ConstrainedZonotope,
    map: &mut Matrix,
    workspace: &mut Workspace,
) -> Result<(), EstimatorError> {
    map.reset(n, product.dim());
    (0..n).for_each(|i| map[(i, i)] = 1.0);
    Ok(product.linear_map_in_place(map, &mut workspace.sets)?)
}
