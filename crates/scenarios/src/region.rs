//! [`Region`]: a set of states of any type that can be asked for its points; [`Containment`]: the answers counted.

use scalars::Interval;
use setrep::{
    ConstrainedZonotope, IntervalVector, Membership, SetError, SupportFunction, VPolytope, Workspace, Zonotope,
    ZonotopeBundle,
};

/// A set of states.
pub trait Region: SupportFunction {
    /// Whether a point known to lie in a box lies in the set.
    ///
    /// # Errors
    /// Those of the set's own type.
    fn membership(&self, point: &[Interval], workspace: &mut Workspace) -> Result<Membership, SetError>;

    /// Number of generators, or of vertices.
    fn columns(&self) -> usize {
        0
    }

    /// Number of constraints.
    fn constraints(&self) -> usize {
        0
    }
}

impl Region for IntervalVector {
    fn membership(&self, point: &[Interval], _: &mut Workspace) -> Result<Membership, SetError> {
        Ok(in_box(self, point))
    }
}

impl Region for Zonotope {
    fn membership(&self, point: &[Interval], _: &mut Workspace) -> Result<Membership, SetError> {
        Self::membership(self, point)
    }

    fn columns(&self) -> usize {
        self.num_generators()
    }
}

impl Region for ConstrainedZonotope {
    fn membership(&self, point: &[Interval], workspace: &mut Workspace) -> Result<Membership, SetError> {
        Self::membership(self, point, workspace)
    }

    fn columns(&self) -> usize {
        self.num_generators()
    }

    fn constraints(&self) -> usize {
        self.num_constraints()
    }
}

impl Region for ZonotopeBundle {
    fn membership(&self, point: &[Interval], workspace: &mut Workspace) -> Result<Membership, SetError> {
        Self::membership(self, point, workspace)
    }

    fn columns(&self) -> usize {
        self.num_generators()
    }
}

impl Region for VPolytope {
    fn membership(&self, point: &[Interval], _: &mut Workspace) -> Result<Membership, SetError> {
        Self::membership(self, point)
    }

    fn columns(&self) -> usize {
        self.num_vertices()
    }
}

/// Whether a point known to lie in a box lies in the box `sides`.
#[must_use]
pub fn in_box(sides: &[Interval], point: &[Interval]) -> Membership {
    if point.iter().zip(sides).any(|(x, side)| x.disjoint(side)) {
        Membership::ProvenOutside
    } else if point.iter().zip(sides).all(|(x, side)| x.subset_of(side)) {
        Membership::ProvenInside
    } else {
        Membership::Undecided
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
    /// Asks a set for each point.
    ///
    /// # Errors
    /// Those of [`Region::membership`].
    pub fn of(set: &dyn Region, points: &[Vec<Interval>], workspace: &mut Workspace) -> Result<Self, SetError> {
        let mut containment = Self::default();
        for point in points {
            containment.add(set.membership(point, workspace)?);
        }
        Ok(containment)
    }

    /// Counts one answer.
    pub fn add(&mut self, verdict: Membership) {
        self.points += 1;
        self.not_outside += usize::from(verdict != Membership::ProvenOutside);
        self.inside += usize::from(verdict == Membership::ProvenInside);
    }

    /// The two shares; none without points.
    #[must_use]
    pub fn shares(&self) -> Option<(f64, f64)> {
        let share = |count: usize| count as f64 / self.points as f64;
        (self.points > 0).then(|| (share(self.not_outside), share(self.inside)))
    }
}
