//! Noises beside the vertices of a polytope.

use std::borrow::Cow;

use scalars::Interval;
use setrep::{VPolytope, Zonotope};

use crate::EstimatorError;
use crate::set_filter::is_box;

/// Most generators of a noise whose vertices are listed.
const MAX_GENERATORS: usize = 6;

/// Most vertices of the product with such a noise.
const MAX_VERTICES: usize = 4096;

/// States and noises: `(X, [w])` for a noise that is a box; `(X x Ver W, [])` for one that mixes its components and has few vertices;
/// `(X, hull W)` for any other.
///
/// The box goes to `sides`.
pub(super) fn beside<'a>(
    set: &'a VPolytope,
    noise: &Zonotope,
    sides: &mut Vec<Interval>,
) -> Result<Cow<'a, VPolytope>, EstimatorError> {
    sides.clear();
    if !is_box(noise) && noise.num_generators() <= MAX_GENERATORS {
        let vertices = noise.to_v_polytope()?.remove_redundant()?;
        if set.num_vertices().saturating_mul(vertices.num_vertices()) <= MAX_VERTICES {
            return Ok(Cow::Owned(set.cartesian_product(&vertices)?));
        }
    }
    sides.resize(noise.dim(), Interval::ZERO);
    noise.interval_hull_into(sides)?;
    Ok(Cow::Borrowed(set))
}
