//! From an element over `f64` to one over intervals.

use scalars::Interval;

use crate::{LieGroup, Rn, SE2, SO2};

/// A group over `f64` whose elements can be enclosed by elements of the same group over intervals.
///
/// Generic code computes with `Self` and bounds with [`Enclosed`](Self::Enclosed).
pub trait Enclose<const N: usize, const D: usize>: LieGroup<f64, N, D> {
    /// The same group over intervals.
    type Enclosed: LieGroup<Interval, N, D>;

    /// The exact element that this rounded one stands for, as a tight box.
    fn enclose(&self) -> Self::Enclosed;
}

impl Enclose<1, 2> for SO2<f64> {
    type Enclosed = SO2<Interval>;

    #[inline]
    fn enclose(&self) -> SO2<Interval> {
        Self::enclose(self)
    }
}

impl Enclose<3, 2> for SE2<f64> {
    type Enclosed = SE2<Interval>;

    #[inline]
    fn enclose(&self) -> SE2<Interval> {
        Self::enclose(self)
    }
}

impl<const N: usize> Enclose<N, N> for Rn<f64, N> {
    type Enclosed = Rn<Interval, N>;

    #[inline]
    fn enclose(&self) -> Rn<Interval, N> {
        Self::enclose(self)
    }
}
