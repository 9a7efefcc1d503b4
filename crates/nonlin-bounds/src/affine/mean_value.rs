//! The mean value form.

use scalars::Interval;

use super::fit::{Parts, midpoints};
use super::natural;

/// `J = mid f'(H)`, `[e] = f(gamma) + (f'(H) - J) d`; in the columns of noises the derivative is taken with the states at `gamma`.
///
/// Columns of constant derivative add nothing. With `gamma = mid H` the second term is `+- rad f'(H) rad H`, the least of all points.
pub(super) fn row(parts: &Parts<'_>, i: usize, row: &mut [f64]) -> Interval {
    let (n, over_box) = (parts.steps.len(), parts.gradient_over_box(i));
    let slopes = match parts.noise_at_point {
        None => over_box.iter().chain(&[]),
        Some(jet) => over_box[..parts.states].iter().chain(&jet.jacobian()[i * n + parts.states..(i + 1) * n]),
    };
    midpoints(slopes.clone(), row);
    let offset = parts.at_point.values()[i] + parts.spread(slopes, row);
    offset.intersection(natural::offset(parts, i, row))
}
