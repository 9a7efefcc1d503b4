//! Random boxes of tangent vectors, with points at every place where a range could go wrong.

use lie_groups::{LieGroup, Rn, SE2, SO2};
use nalgebra::{DMatrix, SVector};
use scalars::Interval;

use crate::support::random::Random;

/// A group with a way back from a box of matrices.
pub(crate) trait Boxed<const N: usize, const D: usize>: LieGroup<Interval, N, D> {
    type Point: LieGroup<f64, N, D>;
    /// All elements whose matrix lies in the box.
    fn from_matrix(m: &DMatrix<Interval>) -> Self;
}

impl Boxed<1, 2> for SO2<Interval> {
    type Point = SO2<f64>;
    fn from_matrix(m: &DMatrix<Interval>) -> Self {
        SO2::from_cos_sin(m[(0, 0)], m[(1, 0)]).unwrap()
    }
}

impl Boxed<3, 2> for SE2<Interval> {
    type Point = SE2<f64>;
    fn from_matrix(m: &DMatrix<Interval>) -> Self {
        let rotation = SO2::from_cos_sin(m[(0, 0)], m[(1, 0)]).unwrap();
        SE2::new(rotation, &SVector::<Interval, 2>::new(m[(0, 2)], m[(1, 2)]))
    }
}

impl<const N: usize> Boxed<N, N> for Rn<Interval, N> {
    type Point = Rn<f64, N>;
    fn from_matrix(m: &DMatrix<Interval>) -> Self {
        Rn::new(SVector::from_fn(|row, _| m[(row, N)]))
    }
}

pub(crate) fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(lo.min(hi), lo.max(hi)).unwrap()
}

/// A radius: zero, tiny or up to `widest`.
fn radius(random: &mut Random, widest: f64) -> f64 {
    match random.below(4) {
        0 => 0.0,
        1 => random.log_uniform(1e-18, 1e-3).abs(),
        _ => random.log_uniform(1e-3, widest).abs(),
    }
}

/// A box of angles: across 0, tiny, wide, next to turning points of the coefficient functions and to multiples of pi, up to 12.
pub(crate) fn angles(random: &mut Random) -> Interval {
    let sign = if random.bits() & 1 == 0 { 1.0 } else { -1.0 };
    // Turning points of the coefficient functions, and the limits of their series.
    let special = [std::f64::consts::PI, 2.331122370414423, 4.493409457909064, 4.49, 2.0, std::f64::consts::FRAC_PI_2];
    let center = match random.below(6) {
        0 => 0.0,
        1 => random.log_uniform(1e-15, 3.0),
        2 => sign * (special[random.below(6) as usize] + random.log_uniform(1e-12, 0.5)),
        3 => sign * (std::f64::consts::TAU + random.log_uniform(1e-3, 0.5)),
        4 => random.uniform(-7.0, 7.0),
        _ => random.log_uniform(1e-300, 1e-6),
    };
    let radius = radius(random, 5.0);
    interval(center - radius, center + radius)
}

/// A box of tangent vectors: angles as above, the other coordinates of sizes 1e-6 to 1e3.
pub(crate) fn tangents<const N: usize>(random: &mut Random) -> SVector<Interval, N> {
    SVector::from_fn(|row, _| {
        if row == 0 {
            return angles(random);
        }
        let center = if random.below(4) == 0 { 0.0 } else { random.log_uniform(1e-6, 1e3) };
        let radius = radius(random, 100.0);
        interval(center - radius, center + radius)
    })
}

/// A point of a box, often with coordinates at its ends.
pub(crate) fn point_of<const N: usize>(random: &mut Random, bounds: &SVector<Interval, N>) -> SVector<f64, N> {
    bounds.map(|x| match random.below(8) {
        0 => x.lo(),
        1 => x.hi(),
        _ => random.uniform(x.lo(), x.hi()),
    })
}
