//! Constraint elimination as the authors of paper 003 run it.
//!
//! The steps of Scott, Raimondo, Marseglia and Braatz 2016 (Section 4.2 and appendix) with the pivoting, the two sweeps of
//! rescaling and the estimate of the error of the library those authors use: the enclosure, and with it every number of the paper
//! that rests on it, depends on these choices.

use nalgebra::{DMatrix, DVector};

use super::CgRep;

/// A coordinate whose range is cut off by less than this is free to go.
const NEARLY_EXACT: f64 = 1e-3;

/// The set with at most `limit` constraints; a superset in real arithmetic.
///
/// `None` if the rescaling finds the set empty.
#[must_use]
pub fn eliminate(set: &CgRep, limit: usize) -> Option<CgRep> {
    let mut set = set.clone();
    while set.constraints.nrows() > limit {
        let rows = set.constraints.nrows();
        let tolerance = tolerance(&set);
        precondition(&mut set, tolerance);
        let scores = rescale(&mut set, tolerance)?;
        let zero: Vec<usize> = (0..rows).filter(|&i| set.constraints.row(i).amax() <= tolerance).collect();
        if !zero.is_empty() {
            if zero.iter().any(|&i| set.offsets[i].abs() > tolerance) {
                return None;
            }
            set.constraints = set.constraints.remove_rows_at(&zero);
            set.offsets = set.offsets.remove_rows_at(&zero);
            continue;
        }
        let column = cheapest(&set, &scores);
        substitute(&mut set, column);
    }
    Some(set)
}

fn tolerance(set: &CgRep) -> f64 {
    let size = set.constraints.nrows().max(set.constraints.ncols() + 1) as f64;
    let row_sum = |i: usize| set.constraints.row(i).iter().map(|a| a.abs()).sum::<f64>() + set.offsets[i].abs();
    size * f64::EPSILON * (0..set.constraints.nrows()).map(row_sum).fold(0.0, f64::max)
}

/// Gauss-Jordan elimination of `[A b]` with full pivoting: the pivot of a row is its largest entry, the row that of least
/// `|row|_1 / |pivot| - 1` with its offset counted. Rows below the tolerance become zero.
fn precondition(set: &mut CgRep, tolerance: f64) {
    let (rows, columns) = set.constraints.shape();
    for k in 0..rows.min(columns) {
        let best = (k..rows)
            .filter_map(|i| {
                let pivot = (k..columns).max_by(|&p, &q| {
                    set.constraints[(i, p)].abs().total_cmp(&set.constraints[(i, q)].abs()).then(q.cmp(&p))
                })?;
                let size = set.constraints[(i, pivot)].abs();
                let sum: f64 = (k..columns).map(|j| set.constraints[(i, j)].abs()).sum::<f64>() + set.offsets[i].abs();
                (size > tolerance).then_some((sum / size - 1.0, i, pivot))
            })
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, row, column)) = best else {
            for i in k..rows {
                set.constraints.row_mut(i).fill(0.0);
                set.offsets[i] = if set.offsets[i].abs() <= tolerance { 0.0 } else { set.offsets[i] };
            }
            return;
        };
        set.constraints.swap_rows(k, row);
        set.offsets.swap_rows(k, row);
        set.constraints.swap_columns(k, column);
        set.generators.swap_columns(k, column);
        let pivot = set.constraints[(k, k)];
        set.constraints.row_mut(k).scale_mut(1.0 / pivot);
        set.offsets[k] /= pivot;
        for i in (0..rows).filter(|&i| i != k) {
            let factor = set.constraints[(i, k)];
            let change = set.constraints.row(k) * factor;
            set.constraints.row_mut(i).zip_apply(&change, |a, c| *a -= c);
            set.constraints[(i, k)] = 0.0;
            set.offsets[i] -= factor * set.offsets[k];
        }
    }
}

/// Two sweeps over the rows that shrink the range of each coordinate to what the row allows; the larger of the two scores of each
/// coordinate (how far the row would let it go beyond its ends), infinite for one that no row speaks of.
fn rescale(set: &mut CgRep, tolerance: f64) -> Option<Vec<f64>> {
    let (rows, columns) = set.constraints.shape();
    let mut scores = vec![[f64::INFINITY; 2]; columns];
    for i in (0..rows).chain(0..rows) {
        let row: Vec<f64> = set.constraints.row(i).iter().copied().collect();
        let (offset, sum) = (set.offsets[i], row.iter().map(|a| a.abs()).sum::<f64>());
        for (j, &a) in row.iter().enumerate().filter(|(_, a)| a.abs() > tolerance) {
            let reach = (sum - a.abs()) / a.abs();
            let (low, high) = (offset / a - reach, offset / a + reach);
            let (from, to) = (low.max(-1.0), high.min(1.0));
            let (middle, radius) = (0.5 * (from + to), 0.5 * (to - from));
            if radius < -tolerance {
                return None;
            }
            let score = |beyond: bool, end: f64, old: f64| {
                if beyond { old.min((end.abs() - 1.0) / radius) } else { 0.0 }
            };
            scores[j] = [score(low < -1.0, low, scores[j][0]), score(high > 1.0, high, scores[j][1])];
            if radius != 1.0 {
                set.center += set.generators.column(j) * middle;
                set.offsets -= set.constraints.column(j) * middle;
                set.generators.column_mut(j).scale_mut(radius);
                set.constraints.column_mut(j).scale_mut(radius);
            }
        }
        let largest = set.constraints.row(i).amax();
        if largest > tolerance {
            set.constraints.row_mut(i).scale_mut(1.0 / largest);
            set.offsets[i] /= largest;
        }
    }
    Some(scores.into_iter().map(|[low, high]| low.max(high)).collect())
}

/// The coordinate to eliminate: one that is nearly exact, else that of the least estimated error `|G d|_2`.
fn cheapest(set: &CgRep, scores: &[f64]) -> usize {
    let least = |values: &[f64]| (0..values.len()).min_by(|&i, &j| values[i].total_cmp(&values[j])).unwrap_or(0);
    let first = least(scores);
    if scores[first] < NEARLY_EXACT {
        return first;
    }
    let (rows, columns) = set.constraints.shape();
    let mut system = DMatrix::zeros(columns + rows, columns + rows);
    let gram = set.generators.tr_mul(&set.generators) + DMatrix::identity(columns, columns);
    system.view_mut((0, 0), (columns, columns)).copy_from(&gram);
    system.view_mut((0, columns), (columns, rows)).copy_from(&set.constraints.transpose());
    system.view_mut((columns, 0), (rows, columns)).copy_from(&set.constraints);
    let factors = system.lu();
    let error = |j: usize| {
        let unit = DVector::from_fn(columns + rows, |i, _| f64::from(u8::from(i == j)));
        let solution = factors.solve(&unit)?;
        let moved = solution.rows(0, columns) * (scores[j] / solution[j]);
        Some((&set.generators * moved).norm())
    };
    let errors: Vec<f64> = (0..columns)
        .map(|j| if scores[j].is_finite() { error(j).unwrap_or(f64::INFINITY) } else { f64::INFINITY })
        .collect();
    least(&errors)
}

/// Solves the row of the largest entry in a column for that coordinate and substitutes it everywhere.
fn substitute(set: &mut CgRep, column: usize) {
    let entry = |i: usize| set.constraints[(i, column)].abs();
    let row = (0..set.constraints.nrows()).max_by(|&i, &k| entry(i).total_cmp(&entry(k)).then(k.cmp(&i))).unwrap_or(0);
    let pivot = set.constraints.row(row) / set.constraints[(row, column)];
    let offset = set.offsets[row] / set.constraints[(row, column)];
    let generator = set.generators.column(column).clone_owned();
    set.center += &generator * offset;
    set.generators -= generator * &pivot;
    let coefficients = set.constraints.column(column).clone_owned();
    set.constraints -= &coefficients * &pivot;
    set.offsets -= coefficients * offset;
    set.generators = set.generators.clone().remove_column(column);
    set.constraints = set.constraints.clone().remove_column(column).remove_row(row);
    set.offsets = set.offsets.clone().remove_row(row);
}
