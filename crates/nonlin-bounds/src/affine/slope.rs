//! The slope form.

use scalars::Interval;

use super::fit::{Parts, midpoints};
use super::natural;

/// `S_k = f'_k(gamma) + sum_j h_jk d_j / 2` with the Hessian `h` over the box; `J = mid S`, `[e] = f(gamma) + (S - J) d`.
///
/// Lagrange's remainder `(x - gamma)' h (x - gamma) / 2` with one factor `x - gamma` kept as a variable. For quadratics `h` is constant
/// and `S` is the derivative over `(H + gamma) / 2`: half as wide as over `H`.
pub(super) fn row(parts: &Parts<'_>, i: usize, row: &mut [f64], slopes: &mut Vec<Interval>) -> Interval {
    slopes.clear();
    slopes.extend_from_slice(parts.gradient_at_point(i));
    let mut hessian = parts.hessian(i).iter();
    for j in 0..parts.steps.len() {
        for (k, entry) in (j..parts.steps.len()).zip(&mut hessian) {
            if *entry == Interval::ZERO {
                continue;
            }
            let half = entry.scale(0.5);
            slopes[k] += half * parts.steps[j];
            if j < k {
                slopes[j] += half * parts.steps[k];
            }
        }
    }
    midpoints(slopes.iter(), row);
    let offset = parts.at_point.values()[i] + parts.spread(slopes.iter(), row);
    offset.intersection(natural::offset(parts, i, row))
}
