//! Interval vectors: axis-aligned boxes.

use core::ops::{Deref, DerefMut};

use scalars::Interval;

use crate::{Part, SetError};

/// A vector of intervals, read as a slice of [`Interval`]: the box `[x_1] x .. x [x_n]`.
///
/// ```
/// # use setrep::IntervalVector;
/// let x = IntervalVector::from_center(&[1.0, 2.0], &[0.5, 0.0])?;
/// assert!(x[0].contains(1.5) && x[1].contains(2.0));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
pub struct IntervalVector(Vec<Interval>);

impl IntervalVector {
    /// The box with the given sides.
    #[must_use]
    pub fn new(sides: Vec<Interval>) -> Self {
        Self(sides)
    }

    /// The box of one point, without width.
    #[must_use]
    pub fn point(x: &[f64]) -> Self {
        x.iter().map(|&x| Interval::point(x)).collect()
    }

    /// The box `center +- radius`.
    ///
    /// **Guarantee:** superset of the exact box (the bounds are rounded outward).
    ///
    /// # Errors
    /// Sizes that differ, entries that are not finite, negative radii.
    pub fn from_center(center: &[f64], radius: &[f64]) -> Result<Self, SetError> {
        SetError::check_size(Part::Radius, center.len(), radius.len())?;
        SetError::check_finite(Part::Center, center.len(), center)?;
        SetError::check_lengths(Part::Radius, radius.len(), radius)?;
        Ok(center.iter().zip(radius).map(|(&c, &r)| Interval::point(c).inflate(r)).collect())
    }

    /// Whether every side of `self` lies in the same side of `other`; `false` if the sizes differ.
    #[must_use]
    pub fn subset_of(&self, other: &[Interval]) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(a, b)| a.subset_of(b))
    }

    /// Whether the point lies in the box; `false` if the sizes differ.
    #[must_use]
    pub fn contains(&self, x: &[f64]) -> bool {
        self.len() == x.len() && self.iter().zip(x).all(|(a, &x)| a.contains(x))
    }

    /// The midpoints of the sides (rounded).
    #[must_use]
    pub fn mid(&self) -> Vec<f64> {
        self.iter().map(Interval::mid).collect()
    }

    /// Upper bounds of the radii about [`mid`](Self::mid).
    #[must_use]
    pub fn rad(&self) -> Vec<f64> {
        self.iter().map(Interval::rad).collect()
    }
}

impl FromIterator<Interval> for IntervalVector {
    fn from_iter<I: IntoIterator<Item = Interval>>(sides: I) -> Self {
        Self(sides.into_iter().collect())
    }
}

impl Deref for IntervalVector {
    type Target = [Interval];

    fn deref(&self) -> &[Interval] {
        &self.0
    }
}

impl DerefMut for IntervalVector {
    fn deref_mut(&mut self) -> &mut [Interval] {
        &mut self.0
    }
}
