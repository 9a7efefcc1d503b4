//! Outer polytopes with few vertices.

use super::enclosing::template;
use super::{HPolytope, VPolytope};
use crate::{Mesh, SetError, Workspace};

/// Facets of the set that are tried as directions.
const MAX_FACETS: usize = 400;

/// Columns that lie in the hull of the others up to this share of the extents are dropped at the end.
const SHARE: f64 = 1e-12;

impl VPolytope {
    /// A polytope around the set with at most `max_vertices` vertices; the set itself if it has no more.
    ///
    /// Half-spaces are chosen as by [`HPolytope::enclosing_along`] among the set's own facets (if there are at most 400) and the directions
    /// of [`HPolytope::enclosing`], as many as can meet in `max_vertices` points: a polytope with `f` facets has at most `C(f - ceil(n/2),
    /// floor(n/2)) + C(f - floor(n/2) - 1, ceil(n/2) - 1)` vertices, `f` in the plane and `2 f - 4` in space.
    ///
    /// **Guarantee:** superset, of bounded size.
    /// **Source:** McMullen, *The maximum numbers of faces of a convex polytope* (1970).
    ///
    /// # Errors
    /// [`SetError::OverBudget`] for fewer vertices than the `2^n` of a box; as [`HPolytope::enclosing_along`].
    ///
    /// ```
    /// # use setrep::{Matrix, VPolytope, Workspace};
    /// let circle: Vec<[f64; 2]> = (0..100).map(|k| [f64::from(k).cos(), f64::from(k).sin()]).collect();
    /// let columns: Vec<&[f64]> = circle.iter().map(|v| &v[..]).collect();
    /// let set = VPolytope::new(Matrix::from_columns(&columns)?)?;
    /// let outer = set.enclosed_within(12, &mut Workspace::new())?;
    /// assert!(outer.num_vertices() <= 12 && outer.volume()?.hi() < 3.4);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn enclosed_within(&self, max_vertices: usize, workspace: &mut Workspace) -> Result<Self, SetError> {
        if self.num_vertices() <= max_vertices {
            return Ok(self.clone());
        }
        let n = self.dim();
        let corners = 1_usize.checked_shl(u32::try_from(n).unwrap_or(u32::MAX)).unwrap_or(usize::MAX);
        if corners > max_vertices {
            return Err(SetError::OverBudget { count: corners, limit: max_vertices });
        }
        let mut facets = 2 * n;
        while facets < MAX_FACETS && most_vertices(n, facets + 1) <= max_vertices {
            facets += 1;
        }
        // In space a surface on a grid has the facets without the slivers of nearly degenerate points.
        let own = match n {
            3 => Mesh::new(self, [0, 1, 2], workspace).map(|mesh| mesh.outer),
            _ => self.to_h_polytope_within(MAX_FACETS),
        };
        let outer = match own {
            Ok(own) => {
                let mut directions = own.normals().transpose();
                directions.append_columns(template(self, workspace)?.as_slice());
                HPolytope::enclosing_along(self, &directions, facets, workspace)?
            }
            Err(_) => HPolytope::enclosing(self, facets, workspace)?,
        };
        match outer.to_v_polytope().map(|vertices| vertices.thinned(SHARE)) {
            Ok(vertices) if vertices.num_vertices() <= max_vertices => Ok(vertices),
            // Flat sets have more half-spaces than facets: the box is left.
            Ok(_) | Err(SetError::OverBudget { .. }) => Self::from_intervals(&self.interval_hull()),
            Err(error) => Err(error),
        }
    }
}

/// The most vertices of a polytope with `f` facets in `R^n`.
fn most_vertices(n: usize, f: usize) -> usize {
    let (low, high) = (n / 2, n.div_ceil(2));
    binomial(f - high, low).saturating_add(binomial(f - low - 1, high - 1))
}

/// `n choose k`, at most the largest number.
fn binomial(n: usize, k: usize) -> usize {
    (0..k).fold(1_usize, |c, i| if c == usize::MAX { c } else { c.saturating_mul(n.saturating_sub(i)) / (i + 1) })
}

#[cfg(test)]
mod tests {
    use super::most_vertices;

    /// Polygons, polyhedra, and the dual of the cyclic polytope with 8 points in four dimensions.
    #[test]
    fn numbers_of_vertices_are_those_of_the_theorem() {
        assert_eq!(
            (most_vertices(1, 2), most_vertices(2, 7), most_vertices(3, 7), most_vertices(4, 8)),
            (2, 7, 10, 20)
        );
    }
}
