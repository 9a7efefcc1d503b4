//! The numbers a tableau is computed in: `f64`, and double-double numbers where these do not suffice.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A number of a tableau, with the tolerances that belong to its precision.
///
/// Rows have 1-norms in [1/2, 1) and the box has half-width 1, so the tolerances are shares of these.
pub(crate) trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + From<f64>
{
    const ZERO: Self;
    const ONE: Self;

    /// Violations below this are forgiven.
    const FEASIBILITY: f64;

    /// A row contradicts the others beyond doubt only if it misses by more than this share of its 1-norm after all flips.
    const CONTRADICTION: f64;

    /// A violation below this share of a row's 1-norm may be a rounding error.
    const NOISE: f64;

    /// A column enters with an entry below this share of the row's largest only if there is no other.
    const SMALL_PIVOT: f64;

    /// Entries above this are good pivots whatever the others.
    const SURE_PIVOT: f64;

    /// Entries below this are rounding errors: their column neither flips nor enters.
    const ZERO_PIVOT: f64;

    /// Smallest entry an exchange may divide by when a basis is rebuilt.
    const REBUILD_PIVOT: f64;

    /// By how much reduced costs are moved apart where the method stalls, as a share of the largest.
    const SHIFT: f64;

    /// The nearest `f64`.
    fn to_f64(self) -> f64;

    /// `(head, tail)` whose sum is the number, but for its last digits; `tail` has the sign of `head`, and is 0 for an `f64`.
    fn split(self) -> (f64, f64);

    fn abs(self) -> Self;

    /// `1 / self`.
    fn recip(self) -> Self;

    /// `self / divisor`.
    fn over(self, divisor: Self) -> Self;
}

impl Real for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const FEASIBILITY: f64 = 1e-13;
    const CONTRADICTION: f64 = 1e-9;
    const NOISE: f64 = 1e-9;
    const SMALL_PIVOT: f64 = 1e-7;
    const SURE_PIVOT: f64 = 1e-3;
    const ZERO_PIVOT: f64 = 1e-13;
    const REBUILD_PIVOT: f64 = 1e-9;
    const SHIFT: f64 = 1e-12;

    fn to_f64(self) -> f64 {
        self
    }

    fn split(self) -> (f64, f64) {
        (self, 0.0)
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn recip(self) -> Self {
        1.0 / self
    }

    fn over(self, divisor: Self) -> Self {
        self / divisor
    }
}
