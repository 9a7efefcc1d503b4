//! [`CombMember`]: what a filter of a [`Comb`](crate::Comb) is asked.

use std::fmt::Debug;

use setrep::{HPolytope, SetError, VPolytope, Workspace};

use crate::polytopic::forms::PolytopeForm;
use crate::{Estimator, EstimatorError, Guarantee, Method, SetFilter};

/// A filter that can be a member of a [`Comb`](crate::Comb): it can be put back on a polytope, and its set can be had as one.
///
/// Every [`SetFilter`] whose sets are a [`PolytopeForm`] is one; filters with sets of their own may implement it.
pub trait CombMember: Debug + Send + Sync {
    /// Number `n` of states.
    fn states(&self) -> usize;

    /// What the sets promise.
    fn promise(&self) -> Guarantee;

    /// Goes on at a step from a superset of a polytope.
    ///
    /// # Errors
    /// What the conversion says.
    fn restart(&mut self, set: &VPolytope, step: u64, workspace: &mut Workspace) -> Result<(), EstimatorError>;

    /// As [`Estimator::predict`].
    ///
    /// # Errors
    /// Those of the filter.
    fn advance(&mut self, input: &[f64]) -> Result<(), EstimatorError>;

    /// As [`Estimator::update`] with a measurement of which some entries may be missing; without one as [`Estimator::consistency`].
    ///
    /// # Errors
    /// Those of the filter.
    fn correct(&mut self, output: Option<&[Option<f64>]>) -> Result<(), EstimatorError>;

    /// As [`PolytopeForm::vertices`].
    ///
    /// # Errors
    /// What the conversion says.
    fn vertices(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<VPolytope, SetError>;

    /// As [`PolytopeForm::half_spaces`].
    ///
    /// # Errors
    /// What the conversion says.
    fn half_spaces(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<HPolytope, SetError>;
}

impl<M> CombMember for SetFilter<M>
where
    M: Method + Send + Sync,
    M::Set: PolytopeForm + Send + Sync,
    M::Memory: Send + Sync,
    M::Options: Send + Sync,
    M::Scratch: Send + Sync,
{
    fn states(&self) -> usize {
        self.system().states()
    }

    fn promise(&self) -> Guarantee {
        self.guarantee()
    }

    fn restart(&mut self, set: &VPolytope, step: u64, workspace: &mut Workspace) -> Result<(), EstimatorError> {
        let set = M::Set::from_polytope(set, workspace)?;
        let mut state = Self::new(self.system().clone(), set, self.options().clone())?.state().clone();
        state.step = step;
        self.restore(&state)
    }

    fn advance(&mut self, input: &[f64]) -> Result<(), EstimatorError> {
        self.predict(input)
    }

    fn correct(&mut self, output: Option<&[Option<f64>]>) -> Result<(), EstimatorError> {
        match output {
            Some(output) => self.update_some(output, &[]),
            None => self.consistency(),
        }
    }

    fn vertices(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<VPolytope, SetError> {
        self.enclosure().vertices(max_half_spaces, workspace)
    }

    fn half_spaces(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<HPolytope, SetError> {
        self.enclosure().half_spaces(max_half_spaces, workspace)
    }
}
