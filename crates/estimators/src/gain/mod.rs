//! Observer gains `L`: how much of the innovation corrects the state.

mod eigenvectors;
mod f_radius;
mod observability;
mod place;
mod poles;

pub use f_radius::f_radius_gain;
pub use observability::observability_rank;
pub use place::place;

use nalgebra::{Complex, SMatrix};

/// Rule for the gain `L` of a filter with `N` states and `M` outputs.
#[derive(Debug, Clone, PartialEq)]
pub enum Gain<const N: usize, const M: usize> {
    /// The gain that minimises the F-radius of the next set, paper 000 (12).
    FRadius,
    /// The gain that gives `A - L C` these eigenvalues, paper 000 Theorem 3.2. Recomputed only when `A` or `C` changes.
    ///
    /// It acts on a whole step; [`Estimator::update`](crate::Estimator::update) alone returns
    /// [`GainNeedsInput`](crate::EstimatorError::GainNeedsInput).
    Poles([Complex<f64>; N]),
    /// This gain, always: `L` in a step, `K` in an update alone.
    Fixed(SMatrix<f64, N, M>),
}

impl<const N: usize, const M: usize> Gain<N, M> {
    /// [`Gain::Poles`] with real poles.
    #[must_use]
    pub fn real_poles(poles: [f64; N]) -> Self {
        Self::Poles(poles.map(|re| Complex::new(re, 0.0)))
    }
}
