//! Polygons and meshes of sets of any type, for plots: [`Outline`] in the plane, [`Mesh`] in space.
//!
//! Both refine the hull of support vectors: the outward normal of each edge (facet) is a direction to ask for next, and the edge is
//! final when the support does not reach beyond it. What is left between inside and outside is stated, and the outside is certified.

mod hull;
mod mesh;
mod outline;
mod rim;

pub use mesh::Mesh;
pub use outline::Outline;
