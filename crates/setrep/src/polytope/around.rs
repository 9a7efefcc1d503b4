//! Half-space forms of sets that are known by their support function.

use scalars::Interval;

use super::HPolytope;
use crate::{Matrix, Mesh, Outline, SetError, SupportFunction, VPolytope, Workspace};

/// Corners of an outline that its rounding has doubled are one up to this share of its width.
const THIN: f64 = 1e-12;

impl HPolytope {
    /// A convex set in half-space form: all its facets in up to three dimensions, by the refinement of [`Outline`] and [`Mesh`]; beyond, or if
    /// there are more than `max_half_spaces`, [`enclosing`](Self::enclosing).
    ///
    /// **Guarantee:** superset of the set, with no more half-spaces than asked for; the set itself but for rounding where all facets of
    /// a polytope are found.
    ///
    /// # Errors
    /// As [`Outline::new`], [`Mesh::new`] and [`enclosing`](Self::enclosing).
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, HPolytope, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut set = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2])?;
    /// set.intersect_half_space(&[1.0, 2.0], 2.0, &mut workspace)?;
    /// assert_eq!(HPolytope::around(&set, 8, &mut workspace)?.num_half_spaces(), 5);
    /// assert_eq!(HPolytope::around(&set, 4, &mut workspace)?.num_half_spaces(), 4);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn around(
        set: &dyn SupportFunction,
        max_half_spaces: usize,
        workspace: &mut Workspace,
    ) -> Result<Self, SetError> {
        let all = match set.dim() {
            1 => {
                let hull = set.interval_hull(workspace)?;
                if hull.iter().any(Interval::is_empty) {
                    return Err(SetError::EmptySet);
                }
                Some(Self::from_intervals(&hull)?)
            }
            2 => {
                let outline = Outline::new(set, [0, 1], workspace)?;
                let mut corners = Matrix::zeros(2, 0);
                outline.outer.iter().for_each(|corner| corners.append_columns(corner));
                Some(VPolytope::new(corners)?.thinned(THIN).to_h_polytope()?)
            }
            3 => Some(Mesh::new(set, [0, 1, 2], workspace)?.outer.drop_redundant(workspace)?),
            _ => None,
        };
        match all {
            Some(all) if all.num_half_spaces() <= max_half_spaces => Ok(all),
            Some(all) if all.num_half_spaces() > 2 * set.dim() => all.simplified(max_half_spaces, workspace),
            _ => Self::enclosing(set, max_half_spaces, workspace),
        }
    }
}
