//! The zonotope bundle: an intersection of zonotopes that is never computed; one operation family a file.

mod conversions;
mod cut;
mod operations;
mod program;
mod reduce;

pub use reduce::BundleComplexity;

use crate::{Part, SetError, Zonotope};

/// An intersection of zonotopes in one space, `{ x : x in Z_1, .., x in Z_k }`, `k >= 1`.
///
/// Intersection is free: it appends members. Maps and sums go member by member, which encloses them (an invertible map of an
/// intersection is exactly the intersection of the images; a sum is not). Supports, hull and emptiness look at all members together,
/// through one linear program whose equality rows say that the members mean the same point; so they are as tight as those of the
/// [`ConstrainedZonotope`](crate::ConstrainedZonotope) that the bundle [is](Self::to_constrained_zonotope).
///
/// The set may be empty: operations on an empty set are valid, and emptiness is only ever claimed with a proof.
///
/// **Source:** Althoff, Krogh 2011, *Zonotope bundles for the efficient computation of reachable sets*.
///
/// ```
/// use setrep::{Matrix, Workspace, Zonotope, ZonotopeBundle};
///
/// let square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
/// let diamond = Zonotope::new(&[1.0, 0.0], &Matrix::from_rows(&[&[0.5, 0.5], &[0.5, -0.5]])?)?;
/// let mut bundle = ZonotopeBundle::from(square);
/// bundle.intersect(&diamond)?;
/// let hull = bundle.interval_hull(&mut Workspace::new())?;
/// assert!(hull[0].contains(0.0) && hull[0].width() < 1.0 + 1e-14);
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Stored"))]
pub struct ZonotopeBundle {
    members: Vec<Zonotope>,
}

impl ZonotopeBundle {
    /// The intersection of the members.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if there is no member, or if they live in different spaces.
    pub fn new(members: Vec<Zonotope>) -> Result<Self, SetError> {
        let Some(first) = members.first() else {
            return Err(SetError::Dimension { part: Part::Members, expected: 1, found: 0 });
        };
        let n = first.dim();
        members.iter().try_for_each(|member| SetError::check_size(Part::Members, n, member.dim()))?;
        Ok(Self { members })
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.first().dim()
    }

    /// Number `k` of members.
    #[must_use]
    pub fn num_members(&self) -> usize {
        self.members.len()
    }

    /// Number of generators of all members together.
    #[must_use]
    pub fn num_generators(&self) -> usize {
        self.members.iter().map(Zonotope::num_generators).sum()
    }

    /// The members `Z_1, .., Z_k`.
    #[must_use]
    pub fn members(&self) -> &[Zonotope] {
        &self.members
    }

    /// `Z_1`, which every bundle has.
    fn first(&self) -> &Zonotope {
        &self.members[0]
    }
}

/// A zonotope is a bundle of one member, exactly.
impl From<Zonotope> for ZonotopeBundle {
    fn from(member: Zonotope) -> Self {
        Self { members: vec![member] }
    }
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for ZonotopeBundle {
    fn clone(&self) -> Self {
        Self { members: self.members.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        self.members.clone_from(&source.members);
    }
}

/// What is stored of a bundle; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Stored {
    members: Vec<Zonotope>,
}

#[cfg(feature = "serde")]
impl TryFrom<Stored> for ZonotopeBundle {
    type Error = SetError;

    fn try_from(stored: Stored) -> Result<Self, SetError> {
        Self::new(stored.members)
    }
}
