//! Enclosures of any type.

use setrep::{ConstrainedZonotope, IntervalVector, VPolytope, Zonotope};

use crate::region::Region;

/// A set that a method returned.
#[derive(Debug, Clone)]
pub enum Enclosure {
    /// A box.
    Box(IntervalVector),
    /// A zonotope.
    Zonotope(Zonotope),
    /// A constrained zonotope.
    Constrained(ConstrainedZonotope),
    /// A polytope by vertices.
    Vertices(VPolytope),
}

impl Enclosure {
    /// The set, whatever its type.
    #[must_use]
    pub fn region(&self) -> &dyn Region {
        match self {
            Self::Box(set) => set,
            Self::Zonotope(set) => set,
            Self::Constrained(set) => set,
            Self::Vertices(set) => set,
        }
    }
}
