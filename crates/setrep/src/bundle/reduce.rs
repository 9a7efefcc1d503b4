//! Reduction to a bounded number of members and generators.

use super::ZonotopeBundle;
use crate::{ConstrainedZonotope, Directions, Part, Reduction, Reencoding, SetError, Workspace, Zonotope};

/// How large a zonotope bundle may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BundleComplexity {
    /// Most members, at least one.
    pub members: usize,
    /// Most generators of a member, at least the dimension of the set.
    pub generators: usize,
}

impl ZonotopeBundle {
    /// Encloses the set in one of at most the given complexity; does nothing if it is within it already.
    ///
    /// If there are too many members, those of the smallest boxes stay, and the last one allowed is the parallelotope of
    /// [`ConstrainedZonotope::reencode`] around the whole intersection, which the dropped ones helped to make small. Then every
    /// member is reduced by itself.
    ///
    /// **Guarantee:** superset of the set, of at most the given complexity.
    ///
    /// # Errors
    /// [`SetError::Dimension`] for no members, [`SetError::TooFewGenerators`] for a limit below the dimension,
    /// [`SetError::Overflow`], [`SetError::TooLarge`]; the set is then unchanged.
    pub fn reduce(
        &mut self,
        limit: BundleComplexity,
        method: Reduction,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        if limit.members == 0 {
            return Err(SetError::Dimension { part: Part::Members, expected: 1, found: 0 });
        }
        if limit.generators < self.dim() {
            return Err(SetError::TooFewGenerators { max_generators: limit.generators, dim: self.dim() });
        }
        let parallelotope =
            if self.members.len() > limit.members { Some(self.parallelotope(workspace)?) } else { None };
        self.change(workspace, |member, workspace| member.reduce(method, limit.generators, workspace))?;
        if let Some(parallelotope) = parallelotope {
            self.members.sort_by(|x, y| size(x).total_cmp(&size(y)));
            self.members.truncate(limit.members - 1);
            self.members.push(parallelotope);
        }
        Ok(())
    }

    /// The parallelotope of the re-encoding around the intersection.
    fn parallelotope(&self, workspace: &mut Workspace) -> Result<Zonotope, SetError> {
        let mut whole: ConstrainedZonotope = self.to_constrained_zonotope()?;
        whole.reencode(Reencoding::new(0), &mut Directions::new(self.dim()), workspace)?;
        Ok(whole.unconstrained().clone())
    }
}

/// Logarithm of the volume of the interval hull.
fn size(member: &Zonotope) -> f64 {
    member.interval_hull().iter().map(|side| side.rad().ln()).sum()
}
