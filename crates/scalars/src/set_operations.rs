//! Intervals as sets: membership, order by inclusion, hull, intersection.

use crate::Interval;
use crate::rounding::{add_up, sub_down};

impl Interval {
    /// `x in X`; false for infinite `x` and NaN.
    #[inline]
    #[must_use]
    pub fn contains(&self, x: f64) -> bool {
        self.lo <= x && x <= self.hi && x.is_finite()
    }

    /// `X` is a subset of `Y`; the empty set is a subset of every set.
    #[inline]
    #[must_use]
    pub fn subset_of(&self, other: &Self) -> bool {
        self.is_empty() || (other.lo <= self.lo && self.hi <= other.hi)
    }

    /// `X` lies in the topological interior of `Y`: every member of `X` has a neighbourhood within `Y`.
    #[inline]
    #[must_use]
    pub fn interior_of(&self, other: &Self) -> bool {
        self.is_empty()
            || ((other.lo < self.lo || other.lo == f64::NEG_INFINITY)
                && (self.hi < other.hi || other.hi == f64::INFINITY))
    }

    /// `X` and `Y` have no common member.
    #[inline]
    #[must_use]
    pub fn disjoint(&self, other: &Self) -> bool {
        !(self.lo <= other.hi && other.lo <= self.hi)
    }

    /// Smallest interval that contains both sets.
    #[inline]
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        // min and max ignore NaN: the empty set is neutral.
        Self::raw(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    /// Common members of both sets.
    #[inline]
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        if self.disjoint(&other) {
            return Self::EMPTY;
        }
        Self::raw(self.lo.max(other.lo), self.hi.min(other.hi))
    }

    /// `X + [-r, r]`, outward rounded. A NaN radius is an unknown one: the whole line; a negative one counts as zero.
    #[inline]
    #[must_use]
    pub fn inflate(self, radius: f64) -> Self {
        if self.is_empty() || radius <= 0.0 {
            return self;
        }
        Self::raw(sub_down(self.lo, radius), add_up(self.hi, radius))
    }
}
