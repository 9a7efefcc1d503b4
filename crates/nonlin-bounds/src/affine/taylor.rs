//! The Taylor form of first order with a one-sided quadratic remainder.

use scalars::Interval;

use super::fit::{Parts, midpoints};
use super::natural;

/// `J = mid f'(gamma)`, `[e] = f(gamma) + (f'(gamma) - J) d + sum_k h_kk d_k^2 / 2 + sum_{j<k} h_jk d_j d_k`, Hessian `h` over the box.
///
/// `f'(gamma)` has the width of rounding and of the parameters. The squares are not products: `d_k^2 >= 0`.
pub(super) fn row(parts: &Parts<'_>, i: usize, row: &mut [f64]) -> Interval {
    let gradient = parts.gradient_at_point(i);
    midpoints(gradient.iter(), row);
    let mut offset = parts.at_point.values()[i] + parts.spread(gradient.iter(), row);
    let mut hessian = parts.hessian(i);
    for (j, step) in parts.steps.iter().enumerate() {
        let (own, rest) = hessian.split_at(parts.steps.len() - j);
        hessian = rest;
        let mut cross = Interval::ZERO;
        for (entry, other) in own.iter().zip(&parts.steps[j..]).skip(1) {
            if *entry != Interval::ZERO {
                cross += *entry * *other;
            }
        }
        if own[0] != Interval::ZERO {
            offset += (own[0] * step.sqr()).scale(0.5);
        }
        if cross != Interval::ZERO {
            offset += cross * *step;
        }
    }
    // The same row of J in the mean value theorem, and against the range.
    let mean_value = parts.at_point.values()[i] + parts.spread(parts.gradient_over_box(i).iter(), row);
    offset.intersection(mean_value).intersection(natural::offset(parts, i, row))
}
