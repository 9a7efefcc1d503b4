//! Enclosures of any type, and what the experiment asks of them.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, IntervalVector, Membership, SetError, SupportFunction, VPolytope, Workspace, Zonotope,
};

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
    /// The set as its support function.
    #[must_use]
    pub fn support(&self) -> &dyn SupportFunction {
        match self {
            Self::Box(set) => set,
            Self::Zonotope(set) => set,
            Self::Constrained(set) => set,
            Self::Vertices(set) => set,
        }
    }

    /// Number of generators, or of vertices.
    #[must_use]
    pub fn columns(&self) -> usize {
        match self {
            Self::Box(_) => 0,
            Self::Zonotope(set) => set.num_generators(),
            Self::Constrained(set) => set.num_generators(),
            Self::Vertices(set) => set.num_vertices(),
        }
    }

    /// Number of constraints.
    #[must_use]
    pub fn constraints(&self) -> usize {
        if let Self::Constrained(set) = self { set.num_constraints() } else { 0 }
    }

    /// Whether a point known to lie in a box lies in the set.
    ///
    /// # Errors
    /// Those of the set's own type.
    pub fn membership(&self, point: &[Interval], workspace: &mut Workspace) -> Result<Membership, SetError> {
        match self {
            Self::Box(set) => Ok(match point {
                _ if point.iter().zip(set.iter()).any(|(x, side)| x.disjoint(side)) => Membership::ProvenOutside,
                _ if point.iter().zip(set.iter()).all(|(x, side)| x.subset_of(side)) => Membership::ProvenInside,
                _ => Membership::Undecided,
            }),
            Self::Zonotope(set) => set.membership(point),
            Self::Constrained(set) => set.membership(point, workspace),
            Self::Vertices(set) => set.membership(point),
        }
    }
}

/// Of points known to lie in boxes: how many are not proven to lie outside, and how many are proven to lie inside.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Containment {
    /// All points.
    pub points: usize,
    /// Points not proven outside.
    pub not_outside: usize,
    /// Points proven inside.
    pub inside: usize,
}

impl Containment {
    /// Asks for each point.
    ///
    /// # Errors
    /// Those of [`Enclosure::membership`].
    pub fn of(set: &Enclosure, points: &[Vec<Interval>], workspace: &mut Workspace) -> Result<Self, SetError> {
        let mut containment = Self::default();
        for point in points {
            let verdict = set.membership(point, workspace)?;
            containment.points += 1;
            containment.not_outside += usize::from(verdict != Membership::ProvenOutside);
            containment.inside += usize::from(verdict == Membership::ProvenInside);
        }
        Ok(containment)
    }

    /// The two shares; none without points.
    #[must_use]
    pub fn shares(&self) -> Option<(f64, f64)> {
        let share = |count: usize| count as f64 / self.points as f64;
        (self.points > 0).then(|| (share(self.not_outside), share(self.inside)))
    }
}
