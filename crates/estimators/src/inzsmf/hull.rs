//! Boxes around the states of an invariant set.

use lie_groups::{Enclose, LieGroup};
use nalgebra::SVector;
use scalars::Interval;

use super::{ErrorSide, InZsmf};
use crate::EstimatorError;

impl<G, const N: usize, const D: usize, Side, const M: usize> InZsmf<G, N, D, Side, M>
where
    G: LieGroup<f64, N, D>,
    Side: ErrorSide,
{
    /// First-order box of the world position `X . p` of a body point, `p = 0` for the position itself (approximate).
    ///
    /// `Xhat . p +- (sum_j |K g_j| + |K| r)` over the generators `g_j` and the remainder `r`, with `K = R J(p)` (left) or `J(Xhat . p)` (right): the exponential is
    /// replaced by its linear part, as in paper 000's AAR. Plain floating point.
    ///
    /// **Guarantee:** none: a wide heading moves the position outside; [`world_hull`](Self::world_hull) is the enclosure.
    pub fn world_hull_approx(&self, p: &SVector<f64, D>) -> [Interval; D] {
        let jacobian = Side::point_jacobian(self.estimate(), p);
        let center = self.estimate().act(p);
        let mut radii = jacobian.abs() * SVector::<f64, N>::from_column_slice(self.tangent_set().remainder());
        for generator in self.tangent_set().generators().columns() {
            radii += (jacobian * SVector::<f64, N>::from_column_slice(generator)).abs();
        }
        std::array::from_fn(|i| Interval::new(center[i] - radii[i], center[i] + radii[i]).unwrap_or(Interval::ENTIRE))
    }

    /// All states of the set as one element over intervals: `Xhat exp([H])` (left) or `exp([H]) Xhat` (right), `[H]` the interval hull
    /// of the tangent set.
    ///
    /// **Guarantee:** superset of the states `Xhat exp(eps)`, `eps` in the tangent set, however wide the heading. That the tangent
    /// set holds the error is of first order only.
    ///
    /// # Errors
    /// Never for sets a filter makes; the error of the set operation if there is one.
    pub fn world_element(&self) -> Result<G::Enclosed, EstimatorError>
    where
        G: Enclose<N, D>,
    {
        let mut hull = [Interval::ZERO; N];
        self.tangent_set().interval_hull_into(&mut hull)?;
        let error = G::Enclosed::exp(&SVector::from(hull));
        let estimate = Enclose::enclose(self.estimate());
        Ok(if Side::IS_LEFT { estimate.compose(&error) } else { error.compose(&estimate) })
    }

    /// Box of the world position `X . p` of a body point over all states of the set, `p = 0` for the position itself.
    ///
    /// **Guarantee:** superset, rounding included, as [`world_element`](Self::world_element).
    ///
    /// # Errors
    /// Those of [`world_element`](Self::world_element).
    pub fn world_hull(&self, p: &SVector<f64, D>) -> Result<[Interval; D], EstimatorError>
    where
        G: Enclose<N, D>,
    {
        let image = self.world_element()?.act(&p.map(Interval::point));
        Ok(std::array::from_fn(|i| image[i]))
    }
}
