//! [`PolytopeForm`]: sets that a polytope can be turned into, and back.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, HPolytope, SetError, SupportFunction, VPolytope, Workspace, Zonotope, ZonotopeBundle,
};

/// Corners of a conversion that are one up to this share of the set's extents.
const THIN: f64 = 1e-12;

/// A form of sets that holds polytopes, at least from outside.
pub trait PolytopeForm: SupportFunction + Sized {
    /// A superset of the polytope `conv V + [-r, r]`, where possible the polytope itself.
    ///
    /// # Errors
    /// [`SetError::Overflow`], [`SetError::OverBudget`].
    fn from_polytope(polytope: &VPolytope, workspace: &mut Workspace) -> Result<Self, SetError>;

    /// A superset of the set in vertex form, from at most so many half-spaces where they are asked for.
    ///
    /// # Errors
    /// As [`HPolytope::around`].
    fn vertices(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<VPolytope, SetError> {
        Ok(self.half_spaces(max_half_spaces, workspace)?.to_v_polytope()?.thinned(THIN))
    }

    /// A superset of the set in half-space form, of at most so many half-spaces.
    ///
    /// # Errors
    /// As [`HPolytope::around`].
    fn half_spaces(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<HPolytope, SetError> {
        HPolytope::around(self, max_half_spaces, workspace)
    }
}

/// The set itself.
impl PolytopeForm for VPolytope {
    fn from_polytope(polytope: &VPolytope, _workspace: &mut Workspace) -> Result<Self, SetError> {
        Ok(polytope.clone())
    }

    fn vertices(&self, _max_half_spaces: usize, _workspace: &mut Workspace) -> Result<VPolytope, SetError> {
        Ok(self.clone())
    }

    fn half_spaces(&self, max_half_spaces: usize, workspace: &mut Workspace) -> Result<HPolytope, SetError> {
        match self.to_h_polytope_within(max_half_spaces) {
            Err(SetError::OverBudget { .. }) => HPolytope::around(self, max_half_spaces, workspace),
            result => result,
        }
    }
}

/// `n` generators, and a ranged constraint for every pair of facets.
impl PolytopeForm for ConstrainedZonotope {
    fn from_polytope(polytope: &VPolytope, workspace: &mut Workspace) -> Result<Self, SetError> {
        Self::from_h_polytope(&polytope.to_h_polytope()?, workspace)
    }
}

/// The hull, and a parallelotope for every facet beyond it.
impl PolytopeForm for ZonotopeBundle {
    fn from_polytope(polytope: &VPolytope, workspace: &mut Workspace) -> Result<Self, SetError> {
        let hull = polytope.interval_hull();
        let mid: Vec<f64> = hull.iter().map(Interval::mid).collect();
        let radii: Vec<f64> = hull.iter().map(Interval::rad).collect();
        let mut bundle = Self::from(Zonotope::from_box(&mid, &radii)?);
        bundle.intersect_h_polytope(&polytope.to_h_polytope()?, workspace)?;
        Ok(bundle)
    }
}
