//! Updates by remainder-form decomposition, which [`DCz`](super::DCz) and [`DZb`](super::DZb) share.

use nonlin_bounds::{Workspace, decomposition_solution};
use scalars::Interval;
use setrep::ConstrainedZonotope;

use crate::set_filter::{Equation, of_hull};
use crate::{Culprit, EstimatorError, Measured, Phase, System};

/// A set that is cut, and what is known beside it.
pub(super) struct Cutting<'a> {
    pub(super) step: u64,
    pub(super) set: &'a mut ConstrainedZonotope,
    /// The hull of the state.
    pub(super) hull: &'a mut [Interval],
    /// Where the constraints of the set come from.
    pub(super) culprits: &'a mut Vec<Culprit>,
    pub(super) bounds: &'a mut Workspace,
}

impl Cutting<'_> {
    /// Cuts with a measurement, if there is one, and with the invariant.
    pub(super) fn correct(
        &mut self,
        system: &System,
        measured: Option<Measured<'_>>,
        trace: &mut dyn FnMut(Phase),
    ) -> Result<(), EstimatorError> {
        self.culprits.clear();
        self.culprits.resize(self.set.num_constraints(), Culprit::Prediction);
        if let Some(measured) = measured {
            self.solve(&Equation::measurement(system, measured))?;
            trace(Phase::Update);
        }
        if let Some(invariant) = Equation::invariant(system) {
            self.solve(&invariant)?;
            trace(Phase::Consistency);
        }
        Ok(())
    }

    /// Cuts set and hull with the rows of an equation, its noises as generators.
    fn solve(&mut self, equation: &Equation<'_>) -> Result<(), EstimatorError> {
        let g = equation.relation.function();
        if let Some(noise) = equation.noise {
            self.set.product_assign_zonotope(noise);
        }
        *self.set = decomposition_solution(g, self.set, equation.values, equation.parameters, self.bounds)?;
        if equation.noise.is_some() {
            *self.set = self.set.project(&(0..self.hull.len()).collect::<Vec<_>>())?;
        }
        self.culprits.extend((0..equation.values.len()).map(equation.culprit));
        self.cut_hull()
    }

    /// Cuts the hull with that of the set; a proof if nothing is left.
    pub(super) fn cut_hull(&mut self) -> Result<(), EstimatorError> {
        let Self { step, set, hull, culprits, bounds } = self;
        let own = set.interval_hull(&mut bounds.sets)?;
        if own.iter().zip(hull.iter()).any(|(found, side)| found.disjoint(side)) {
            return Err(of_hull(*step, set, (&own, hull), culprits, &mut bounds.sets));
        }
        hull.iter_mut().zip(own.iter()).for_each(|(side, found)| *side = side.intersection(*found));
        Ok(())
    }
}
