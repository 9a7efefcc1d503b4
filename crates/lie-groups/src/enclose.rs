//! From an element over `f64` to one over intervals.

use scalars::Interval;

use crate::{Complex, LieGroup, Rn, SE2, SO2, Turn};

/// A group over `f64` whose elements can be enclosed by elements of the same group over intervals.
///
/// Generic code computes with `Self` and bounds with [`Enclosed`](Self::Enclosed).
///
/// **Guarantee:** the answer contains the exact element that the rounded one stands for: rotations scaled to length 1, translations as they
/// are. NaN and infinities give unbounded enclosures.
pub trait Enclose<const N: usize, const D: usize>: LieGroup<f64, N, D> {
    /// The same group over intervals.
    type Enclosed: LieGroup<Interval, N, D>;

    /// The exact element that this rounded one stands for, as a tight box.
    fn enclose(&self) -> Self::Enclosed;
}

impl Enclose<1, 2> for SO2<f64> {
    type Enclosed = SO2<Interval>;

    fn enclose(&self) -> SO2<Interval> {
        let (re, im) = (Interval::point(self.unit().re), Interval::point(self.unit().im));
        let norm = (re.sqr() + im.sqr()).sqrt();
        Turn::new(Complex::new(re / norm, im / norm), im.atan2(re)).into()
    }
}

impl Enclose<3, 2> for SE2<f64> {
    type Enclosed = SE2<Interval>;

    fn enclose(&self) -> SE2<Interval> {
        SE2::new(self.rotation().enclose(), &self.translation().map(Interval::point))
    }
}

impl<const N: usize> Enclose<N, N> for Rn<f64, N> {
    type Enclosed = Rn<Interval, N>;

    fn enclose(&self) -> Rn<Interval, N> {
        Rn::new(self.vector().map(Interval::point))
    }
}
