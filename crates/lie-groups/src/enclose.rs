//! From an element over `f64` to one over intervals.

use nalgebra::SVector;
use scalars::Interval;

use crate::{Complex, FrameGroup, LieGroup, RPlus, Rn, SE2, SO2, ScaledSO2, Turn, TwoFrame};

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

impl Enclose<1, 1> for RPlus<f64> {
    type Enclosed = RPlus<Interval>;

    /// The logarithm counts, the factor is the exponential of it.
    fn enclose(&self) -> RPlus<Interval> {
        RPlus::from_log(Interval::point(self.log_scale()))
    }
}

impl Enclose<2, 2> for ScaledSO2<f64> {
    type Enclosed = ScaledSO2<Interval>;

    fn enclose(&self) -> ScaledSO2<Interval> {
        ScaledSO2::new(self.rotation().enclose(), self.scaling().enclose())
    }
}

impl<G, const D: usize, const NX: usize, const NB: usize, const DG: usize, const N: usize> Enclose<N, D>
    for TwoFrame<G, f64, D, NX, NB, DG, N>
where
    G: FrameGroup<f64, D, DG> + Enclose<DG, D>,
    G::Enclosed: FrameGroup<Interval, D, DG>,
{
    type Enclosed = TwoFrame<G::Enclosed, Interval, D, NX, NB, DG, N>;

    fn enclose(&self) -> Self::Enclosed {
        let boxed = |v: &SVector<f64, D>| v.map(Interval::point);
        let (fixed, body) = (self.fixed(), self.body());
        TwoFrame::new(
            self.frame().enclose(),
            std::array::from_fn(|i| boxed(&fixed[i])),
            std::array::from_fn(|j| boxed(&body[j])),
        )
    }
}
