//! Rows that are exact linear combinations of others.

use core::cmp::Ordering;

use crate::exact::sign_of_sum;
use crate::problem::Problem;
use crate::tableau::Tableau;

/// Largest common denominator of the coefficients that is tried.
const DENOMINATORS: usize = 64;

/// A tableau entry below this is zero, were it not for rounding.
const ZERO: f64 = 1e-9;

/// Relative difference between a coefficient and its rounding to few digits.
const NEAR: f64 = 1e-9;

/// Whether the row whose logical is basic in row `r` of the tableau follows from rows of known activities.
///
/// `activity(k)` is the exact activity of row `k`, if known. The tableau gives approximate
/// coefficients of the row in terms of those; for small `d` and nearby numbers `u_k` of few digits it is checked **exactly** that
/// `d A_i = sum_k u_k A_k` and `d lower_i <= sum_k u_k activity_k <= d upper_i`.
pub(crate) fn is_implied(
    problem: &Problem,
    tableau: &Tableau<f64>,
    r: usize,
    activity: impl Fn(usize) -> Option<f64>,
) -> bool {
    let n = problem.variables();
    let Some(i) = (tableau.rows.variable[r] as usize).checked_sub(n) else { return false };
    let columns = || tableau.columns.variable.iter().zip(tableau.row(r));
    let scale = problem.ranges()[i].scale;
    // The terms (k, t_k) of the combination; other columns must not take part.
    let terms = || {
        columns().filter(|(_, t)| t.abs() > ZERO).map(|(&v, &t)| {
            let k = (v as usize).checked_sub(n)?;
            Some((k, t * problem.ranges()[k].scale / scale))
        })
    };
    if terms().any(|term| term.is_none_or(|(k, _)| activity(k).is_none())) {
        return false;
    }
    let (lower, upper) = problem.range(i);
    (1..=DENOMINATORS).map(|d| d as f64).any(|d| {
        let rounded = || terms().flatten().map(|(k, t)| (k, rounding(d * t)));
        let dependent = |column: usize| {
            let others = rounded().map(|(k, u)| (u.unwrap_or(f64::NAN), problem.row(k)[column]));
            sign_of_sum(others.chain([(d, -problem.row(i)[column])])) == Ordering::Equal
        };
        let compare = |end: f64| {
            let activities = rounded().filter_map(|(k, u)| Some((u?, activity(k)?)));
            sign_of_sum(activities.chain([(d, -end)]))
        };
        rounded().all(|(_, u)| u.is_some())
            && (0..n).all(dependent)
            && (lower == f64::NEG_INFINITY || compare(lower) != Ordering::Less)
            && (upper == f64::INFINITY || compare(upper) != Ordering::Greater)
    })
}

/// The number of at most 20 binary digits near a coefficient, if there is one.
fn rounding(coefficient: f64) -> Option<f64> {
    let c = 8_589_934_593.0 * coefficient; // 2^33 + 1, Veltkamp's splitting
    let digits = c - (c - coefficient);
    ((digits - coefficient).abs() <= NEAR * coefficient.abs()).then_some(digits)
}
