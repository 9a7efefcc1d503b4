//! The answers of the solver.

use crate::bound::Multiplier;
use crate::certificate::Certificate;
use crate::witness::Witness;

/// What a solve ended with; the bound is proven in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The point is a vertex of the set and optimal, to working accuracy.
    Optimal,
    /// The set is proven empty: see [`Solver::emptiness`](crate::Solver::emptiness). Value and bound are minus infinity.
    Empty,
    /// Stopped at the pivot limit or in numerical doubt: the point need not satisfy the rows, the bound may be loose.
    Stopped,
}

/// Answer to one objective.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Solution<'a> {
    /// What the numbers mean.
    pub status: Status,
    /// `c'x` at the point, with plain rounding: an approximation of the maximum.
    pub value: f64,
    /// Proven upper bound of the maximum, at most `|c|_1` (rounded up).
    pub bound: f64,
    /// The point `x`, always in the box; if the status is `Optimal` it satisfies the rows to a few roundings (`12 (n + 4)` units
    /// of 2^-53) of their 1-norms, and to 1e-11 where a set is so thin that rows merely touch.
    pub point: &'a [f64],
    /// The multipliers that prove the bound, by [`Problem::upper_bound`](crate::Problem::upper_bound); those of the certificate if the set is empty.
    pub multipliers: &'a [Multiplier],
    /// Exchanges made.
    pub pivots: usize,
}

impl Solution<'_> {
    /// `bound - value`: how much tighter the bound could be at most, up to rounding of the value (0 for an empty set).
    #[must_use]
    pub fn gap(&self) -> f64 {
        if self.status == Status::Empty { 0.0 } else { self.bound - self.value }
    }
}

/// Whether a set is empty. Nothing is claimed without a proof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emptiness<'a> {
    /// Proven empty.
    Empty(&'a Certificate),
    /// Proven to have a point.
    NonEmpty(&'a Witness),
    /// Neither could be proven, as for a set that is empty by the rounding of its data: to be treated as non-empty.
    Undecided,
}
