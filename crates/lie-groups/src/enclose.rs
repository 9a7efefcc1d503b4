//! From an element over `f64` to one over intervals.

use nalgebra::SVector;
use scalars::Interval;

use crate::{
    Complex, FrameGroup, LieGroup, Prod, RPlus, Rn, SE2, SO2, SO3, ScaledSO2, ScaledSO3, SpinSet, Turn, TwoFrame,
};

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

impl Enclose<3, 3> for SO3<f64> {
    type Enclosed = SO3<Interval>;

    fn enclose(&self) -> SO3<Interval> {
        SO3::from_spin(SpinSet::point(self.quaternion()))
    }
}

impl Enclose<4, 3> for ScaledSO3<f64> {
    type Enclosed = ScaledSO3<Interval>;

    fn enclose(&self) -> ScaledSO3<Interval> {
        ScaledSO3::new(self.rotation().enclose(), self.scaling().enclose())
    }
}

impl<A, B, const NA: usize, const NB: usize, const DA: usize, const DB: usize, const N: usize> Enclose<N, DA>
    for Prod<A, B, NA, NB, DB, N>
where
    A: Enclose<NA, DA>,
    B: Enclose<NB, DB>,
{
    type Enclosed = Prod<A::Enclosed, B::Enclosed, NA, NB, DB, N>;

    fn enclose(&self) -> Self::Enclosed {
        Prod::new(self.first().enclose(), self.second().enclose())
    }
}
