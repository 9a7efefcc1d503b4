//! [`Equation`]: `g(x, v) in Y`, as a measurement or an invariant states it.

use nonlin_bounds::Conflict;
use scalars::Interval;
use setrep::{Strip, Zonotope};

use super::Measured;
use crate::error::check_size;
use crate::system::Relation;
use crate::{Culprit, EstimatorError, System};

/// A function, the values that it takes, and where they come from.
#[derive(Clone, Copy)]
pub(crate) struct Equation<'a> {
    pub(crate) relation: &'a Relation,
    /// The noises after the states, if there are any.
    pub(crate) noise: Option<&'a Zonotope>,
    pub(crate) values: &'a [Interval],
    pub(crate) parameters: &'a [Interval],
    pub(crate) culprit: fn(usize) -> Culprit,
}

impl<'a> Equation<'a> {
    /// What a measurement says.
    pub(crate) fn measurement(system: &'a System, measured: Measured<'a>) -> Self {
        Self {
            relation: system.measurement(),
            noise: Some(system.measurement_noise()),
            values: measured.values,
            parameters: measured.parameters,
            culprit: Culprit::Measurement,
        }
    }

    /// What the invariant says, if there is one.
    pub(crate) fn invariant(system: &'a System) -> Option<Self> {
        system.invariant().map(|invariant| Self {
            relation: invariant.relation(),
            noise: None,
            values: invariant.range(),
            parameters: &[],
            culprit: Culprit::Invariant,
        })
    }

    /// The outputs that a conflict names: one, or all.
    pub(crate) fn culprits(&self, conflict: Option<Conflict>) -> Vec<Culprit> {
        match conflict {
            Some(Conflict::Output { output, .. }) => vec![(self.culprit)(output)],
            _ => (0..self.values.len()).map(self.culprit).collect(),
        }
    }
}

/// `Ok` if strips of feasible states lie in the space of `n` states.
pub(crate) fn check_strips(n: usize, strips: &[Strip]) -> Result<(), EstimatorError> {
    strips.iter().try_for_each(|strip| check_size("strip of feasible states", n, strip.dim()))
}
