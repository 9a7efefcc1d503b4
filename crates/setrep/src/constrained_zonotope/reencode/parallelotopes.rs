//! A constrained zonotope as an intersection of parallelotopes.

use super::{Directions, Reencoding, Scratch, Source};
use crate::{ConstrainedZonotope, Part, SetError, Workspace, Zonotope, ZonotopeBundle};

impl ConstrainedZonotope {
    /// Encloses the set in a bundle of at most `max_members` parallelotopes, each as small as its axes allow.
    ///
    /// The first is that of the [re-encoding](Self::reencode); each of the others has `n` of the directions along which the
    /// re-encoding cuts the first, found from the [constraints](Directions::push_constraints) and the axes.
    ///
    /// **Guarantee:** superset of the set.
    ///
    /// # Errors
    /// [`SetError::Dimension`] for no members, [`SetError::TooLarge`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut corner = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// corner.intersect_half_space(&[1.0, 1.0], 0.0, &mut workspace)?;
    /// let bundle = corner.to_zonotope_bundle(2, &mut workspace)?;
    /// assert!(bundle.support(&[1.0, 1.0], &mut workspace)? < 1e-12);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn to_zonotope_bundle(
        &self,
        max_members: usize,
        workspace: &mut Workspace,
    ) -> Result<ZonotopeBundle, SetError> {
        if max_members == 0 {
            return Err(SetError::Dimension { part: Part::Members, expected: 1, found: 0 });
        }
        let n = self.dim();
        let (mut first, mut directions) = (self.clone(), Directions::new(n));
        directions.push_constraints(self, workspace)?;
        first.reencode(Reencoding::new((max_members - 1) * n), &mut directions, workspace)?;
        let mut members = vec![first.body];
        let rows: Vec<&[f64]> = directions.iter().collect();
        for group in rows.chunks(n) {
            members.push(self.parallelotope_along(group, workspace)?);
        }
        ZonotopeBundle::new(members)
    }

    /// The smallest parallelotope around the set with sides along the given directions, at most `n` of them, and axes; a point for a
    /// set that is proven empty.
    fn parallelotope_along(&self, directions: &[&[f64]], workspace: &mut Workspace) -> Result<Zonotope, SetError> {
        let mut scratch = Scratch::default();
        let mut set = self.clone();
        scratch.center.clone_from(&set.body.center);
        set.body.center.fill(0.0);
        if scratch.measure(&set, Source::Along(directions), &Directions::new(self.dim()), workspace)? {
            set.become_parallelotope(&scratch)?;
        } else {
            set.become_empty(0);
        }
        set.body.translate(&scratch.center)?;
        Ok(set.body)
    }
}
