//! Means of group elements.

use nalgebra::SVector;

use crate::{GroupError, LieGroup};

/// Iterations after which a mean is given up; close elements need 3 to 5.
const MOST_ITERATIONS: usize = 64;

/// Weighted mean of group elements: the `M` with `sum_i w_i log(M^-1 X_i) = 0`, by the iteration `M <- M exp(sum_i w_i log(M^-1 X_i))`.
///
/// On rotations it is the Karcher mean of the bi-invariant metric; on groups without one it is still the mean that does not depend on the
/// frame: of `A X_i B` it is `A M B`. Equal weights if none are given; others are taken relative to their sum.
///
/// **Guarantee:** rounded; `|sum_i w_i log(M^-1 X_i)|` is at most 1e-14 of the spread of the elements, or down to where rounding stops it from falling.
/// **Source:** Pennec, Arsigny, Exponential barycenters of the canonical Cartan connection and invariant means on Lie groups, 2012.
///
/// # Errors
/// [`GroupError::NoMean`] without elements, with weights of another number or of no positive sum, or if the iteration does not converge (elements spread over a half turn);
/// the errors of [`LieGroup::log`].
///
/// ```
/// use lie_groups::{SE2, mean};
///
/// // Headings on both sides of the half turn: averaging the numbers would give 0.
/// let poses = [SE2::from_pose(3.1, 1.0, 0.0), SE2::from_pose(-3.1, 1.2, 0.0)];
/// let middle = mean(&poses, None)?;
/// assert!((middle.rotation().angle()?.abs() - std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
pub fn mean<G, const N: usize, const D: usize>(elements: &[G], weights: Option<&[f64]>) -> Result<G, GroupError>
where
    G: LieGroup<f64, N, D>,
{
    let none = GroupError::NoMean { iterations: 0, step: f64::NAN };
    let total = weights.map_or(elements.len() as f64, |w| w.iter().sum());
    if elements.is_empty() || weights.is_some_and(|w| w.len() != elements.len()) || !(total > 0.0 && total.is_finite())
    {
        return Err(none);
    }
    let mut middle = elements[0];
    let mut last = f64::INFINITY;
    for _ in 0..MOST_ITERATIONS {
        let inverse = middle.inverse();
        let (mut step, mut spread) = (SVector::<f64, N>::zeros(), 0.0_f64);
        for (k, element) in elements.iter().enumerate() {
            let log = inverse.compose(element).log()?;
            spread = spread.max(log.norm());
            step += log * (weights.map_or(1.0, |w| w[k]) / total);
        }
        let length = step.norm();
        // Close to the mean the step falls by a factor each time until rounding stops it.
        if length <= 1e-14 * spread || (length >= 0.5 * last && length <= 1e-9 * spread) {
            return Ok(middle);
        }
        middle = middle.compose(&G::exp(&step));
        last = length;
    }
    Err(GroupError::NoMean { iterations: MOST_ITERATIONS, step: last })
}
