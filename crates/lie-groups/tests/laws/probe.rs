//! How a law is judged over each scalar.

use lie_groups::Coeff;
use nalgebra::{Dim, Matrix, RawStorage};
use scalars::Interval;

/// A scalar that laws can be tested over.
pub(crate) trait Probe: Coeff {
    /// Relative error that the laws of groups of space may reach.
    const SPACE_BAR: f64;
    /// Distance of two results that stand for the same number; infinite if they contradict each other.
    fn gap(a: Self, b: Self) -> f64;
    /// Size of a number, for relative errors.
    fn size(self) -> f64;
}

impl Probe for f64 {
    const SPACE_BAR: f64 = 1e-13;

    fn gap(a: f64, b: f64) -> f64 {
        let difference = (a - b).abs();
        if difference.is_nan() { f64::INFINITY } else { difference }
    }

    fn size(self) -> f64 {
        self.abs()
    }
}

impl Probe for Interval {
    const SPACE_BAR: f64 = 1e-12;

    /// Width of the hull of both; enclosures of one number must meet.
    fn gap(a: Interval, b: Interval) -> f64 {
        if a.is_empty() || b.is_empty() || a.disjoint(&b) { f64::INFINITY } else { a.hull(b).width() }
    }

    fn size(self) -> f64 {
        self.mag()
    }
}

/// Largest gap of two matrices, relative to `scale`.
pub(crate) fn distance<S, R, C, T, U>(a: &Matrix<S, R, C, T>, b: &Matrix<S, R, C, U>, scale: f64) -> f64
where
    S: Probe,
    R: Dim,
    C: Dim,
    T: RawStorage<S, R, C>,
    U: RawStorage<S, R, C>,
{
    assert_eq!(a.shape(), b.shape());
    a.iter().zip(b.iter()).fold(0.0, |worst: f64, (&x, &y)| worst.max(S::gap(x, y))) / scale
}

/// Largest entry in modulus, at least 1.
pub(crate) fn size<S: Probe, R: Dim, C: Dim, T: RawStorage<S, R, C>>(m: &Matrix<S, R, C, T>) -> f64 {
    m.iter().fold(1.0, |worst, &x| worst.max(x.size()))
}
