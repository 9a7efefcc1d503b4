//! What an [`Equation`] says of a box and of a set.

use nonlin_bounds::{BoundError, Conflict, Contraction, Domain, ForwardBackward};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

use super::scratch::Scratch;
use crate::EstimatorError;
use crate::set_filter::{Equation, is_box};

/// What [`Rcz`](crate::Rcz) does with an equation.
impl Equation<'_> {
    /// Shrinks the box of states by propagation through the tape; a conflict leaves it as it was.
    pub(super) fn contract(
        &self,
        contractor: ForwardBackward,
        hull: &mut [Interval],
        scratch: &mut Scratch,
    ) -> Result<Option<Conflict>, EstimatorError> {
        let Some(tape) = self.relation.tape() else { return Ok(None) };
        let Scratch { bounds, stacked, .. } = scratch;
        stacked.fill(hull, self.noise)?;
        let sides = &mut stacked.sides;
        if let Contraction::ProvenEmpty(conflict) =
            contractor.contract_stated(tape, sides, self.parameters, self.values, bounds)?
        {
            return Ok(Some(conflict));
        }
        let n = hull.len();
        hull.copy_from_slice(&sides[..n]);
        Ok(None)
    }

    /// Cuts a set with the rows of the equation over the box of states, and notes where each row comes from.
    pub(super) fn cut(
        &self,
        hull: &[Interval],
        set: &mut ConstrainedZonotope,
        scratch: &mut Scratch,
    ) -> Result<(), EstimatorError> {
        let Scratch { bounds, enclosure, rows, stacked, noise: storage, culprits, directions, .. } = scratch;
        stacked.fill(hull, self.noise)?;
        let domain = Domain::new(&stacked.sides, &stacked.point)
            .with_parameters(self.parameters)
            .with_noises(self.noise.map_or(0, Zonotope::dim));
        enclosure.enclose_where_possible(self.relation.function(), &domain, bounds)?;
        enclosure.rows_into(hull.len(), self.values, rows)?;
        directions.push_rows(rows.directions())?;
        if let Some(noise) = self.noise.filter(|noise| !is_box(noise)) {
            // Noises that mix the outputs are generators of the cut; that needs every output to be bounded.
            let generators = storage.get_or_insert_with(|| ConstrainedZonotope::from(noise.clone()));
            generators.assign_zonotope(noise);
            match enclosure.intersect_with_noise(set, self.values, generators, bounds) {
                Err(BoundError::UnboundedResult { .. }) => {}
                result => {
                    culprits.extend((0..self.values.len()).map(self.culprit));
                    return Ok(result?);
                }
            }
        }
        rows.intersect(set, bounds)?;
        culprits.extend(rows.outputs().iter().map(|&output| (self.culprit)(output)));
        Ok(())
    }
}
