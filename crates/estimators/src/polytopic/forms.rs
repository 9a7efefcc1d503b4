//! [`PolytopeForm`]: sets that a polytope can be turned into, and back.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, HPolytope, Matrix, SetError, SupportFunction, VPolytope, Workspace, Zonotope, ZonotopeBundle,
};

/// Corners of a conversion that are one up to this share of the set's extents.
const THIN: f64 = 1e-10;

/// A remainder beyond this share of the set's extent is not rounding.
const MODEL_SIZE: f64 = 1e-6;

/// The set with a remainder of model size turned into vertices, `conv V + [-r, r] = conv { v +- r }`; what is of rounding size stays.
///
/// # Errors
/// [`SetError::OverBudget`] for too many corners, [`SetError::Overflow`].
pub(super) fn materialized(set: VPolytope) -> Result<VPolytope, SetError> {
    let hull = set.interval_hull();
    let is_large = |k: usize| set.remainder()[k] > MODEL_SIZE * hull[k].width();
    let (mut sides, mut rest) = (vec![Interval::ZERO; set.dim()], set.remainder().to_vec());
    for k in (0..set.dim()).filter(|&k| is_large(k)) {
        sides[k] = Interval::ZERO.inflate(core::mem::take(&mut rest[k]));
    }
    if sides.iter().all(|side| *side == Interval::ZERO) {
        return Ok(set);
    }
    let n = set.dim();
    let mut sum = Matrix::zeros(n, 2 * n);
    (0..n).for_each(|k| (sum[(k, k)], sum[(k, n + k)]) = (1.0, 1.0));
    let small = VPolytope::with_remainder(set.vertices().clone(), &rest)?;
    Ok(small.cartesian_product(&VPolytope::from_intervals(&sides)?)?.linear_map(&sum)?.thinned(THIN))
}

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

/// The hull, and a parallelotope for every half-space beyond it: the facets if they are at most `5 n`, as many that cut off most if not.
impl PolytopeForm for ZonotopeBundle {
    fn from_polytope(polytope: &VPolytope, workspace: &mut Workspace) -> Result<Self, SetError> {
        let hull = polytope.interval_hull();
        let mid: Vec<f64> = hull.iter().map(Interval::mid).collect();
        let radii: Vec<f64> = hull.iter().map(Interval::rad).collect();
        let mut bundle = Self::from(Zonotope::from_box(&mid, &radii)?);
        bundle.intersect_h_polytope(&polytope.half_spaces(5 * polytope.dim(), workspace)?, workspace)?;
        Ok(bundle)
    }
}
