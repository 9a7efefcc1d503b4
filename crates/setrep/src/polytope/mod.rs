//! Polytopes in half-space and vertex form, and the conversions between them, rounding included.
//!
//! [`HPolytope`] is `{ x : H x <= h }`, [`VPolytope`] is `conv V + [-r, r]`. Both conversions are one algorithm, the double description
//! method on a cone in `R^(n+1)`:
//! - *H to V*: the cone `{ (t, x) : t >= 0, h t - H x >= 0 }`; its extreme rays with `t > 0` are the vertices `x / t`, those with
//!   `t = 0` the directions in which the set is unbounded, and there is none with `t > 0` iff the set is empty;
//! - *V to H*: the cone `{ (b, a) : b + a'v >= 0 for each vertex v }`; its extreme rays are the facets.
//!
//! # Why nothing is lost
//! 1. Which constraints are tight at which ray is **exact**: every decision of the method is the sign of a sum of products of the input
//!    floats, taken from a floating-point filter with a proven error where that decides and from exact arithmetic where not. So the
//!    list of vertices (facets) is the one of real arithmetic: none is missing, none is invented, and `empty`, `unbounded`, `flat`
//!    are proven answers without a tolerance.
//! 2. *H to V*: each vertex is the solution of `n` independent equations of its tight set, enclosed by a verified solve
//!    (or an exact quotient). The largest radii are the box remainder `r`, so `conv V + [-r, r]` contains the hull of the exact
//!    vertices, which is the set.
//! 3. *V to H*: the normals are rounded, and then each offset is the support function of the whole set in its normal, rounded up. So every
//!    half-space contains the set, whatever rounding did to the normal.
//! 4. *V cut by half-spaces* ([`VPolytope::intersection`]): the same method goes on from the vertices of `conv V` and its exact facets.
//!
//! Sets that are computed step by step need no exact combinatorics, only a superset that stays small: [`VPolytope::cut_by_values`] and
//! [`VPolytope::thinned`] work on points alone, in floating point, and pay for what they leave out in the remainder, with a proof by convex
//! combinations; [`VPolytope::absorb_remainder`] takes it into the hull, [`VPolytope::enclosed_within`] bounds the number of vertices.
//!
//! What needs no vertices goes through linear programs instead, one for each question, certified by weak duality and made for a
//! thousand rows: supports ([`HPolytope::optimizer`]), [`HPolytope::bounding_box`], [`HPolytope::chebyshev_ball`],
//! [`HPolytope::drop_redundant`], [`HPolytope::enclosing`]. Rows that come and go inside a known box are [`BoxedRows`].
//!
//! Cost: the exact arithmetic is needed for degenerate inputs (more than `n` facets at a vertex, or points on a common facet) and
//! for those within rounding of it; the filter decides the rest. Rounding makes degenerate inputs *nearly* degenerate: a
//! `VPolytope` whose columns were rounded can have many facets of nearly the same normal, where the unrounded one had a single
//! facet; and the rounded normals of the facets of a hull split each vertex at which more than `n` of them meet. To intersect a
//! hull with half-spaces, [`VPolytope::intersection`] avoids the second. The limits on the number of faces ([`MAX_FACES`], the
//! `_within` methods) refuse what grows too large.

mod absorb;
mod around;
mod bounded;
mod bounding_box;
mod boxed_rows;
mod chebyshev;
mod clip;
mod cone;
mod enclosing;
pub(crate) mod error_free;
mod exact;
mod facets;
mod feasibility;
mod frame;
mod h_polytope;
mod incidence;
mod membership;
mod optimizer;
mod planar;
mod product;
mod rays;
mod redundancy;
mod row_contradiction;
mod rows;
mod solve;
mod table;
mod thin;
mod v_polytope;
mod vertices;
mod volume;
mod waiting;
mod walk;
mod weighted_cut;

pub use boxed_rows::BoxedRows;
pub use chebyshev::ChebyshevBall;
pub use feasibility::Feasibility;
pub use h_polytope::HPolytope;
pub use optimizer::PolytopeOptimizer;
pub use row_contradiction::RowContradiction;
pub use v_polytope::VPolytope;

/// Most vertices or facets that a conversion without an explicit limit keeps at any stage.
pub const MAX_FACES: usize = 20_000;
