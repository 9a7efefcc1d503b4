//! Which bound to free: an estimate of what the elimination of each coordinate and each row range costs.
//!
//! If `|xi_j| <= 1` is dropped, `xi_j` may exceed it by at most `s_j`, the excess of the ranges that the rows imply. The least
//! change `d` of the coordinates with `d_j = s_j` and `A d = 0` that keeps `|G d|^2 + w |d|^2` small moves the set by about `|G d|`.
//! With `L = [G; A]` and `S = L L' + diag(w I, s^2)`, where the radii `s` of the ranges stand for slacks,
//! `|G d| = s_j w |(S^-1 l_j)_{1..n}| / (1 - l_j' S^-1 l_j)`: one factorisation of size `n + nc` for all candidates.
//!
//! A heuristic: any choice gives a valid enclosure.
//!
//! **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Appendix, in a smaller system.

use super::ConstrainedZonotope;
use crate::Workspace;
use crate::bounds::add_abs_row_sums;
use crate::cholesky::{factorise, solve_lower_rows, solve_upper_end};

/// Weight of the change of coordinates, in units of the hull.
const WEIGHT: f64 = 0.1;

/// Share of the excess of a row range that is counted. It is measured by the 1-norm of the row, which a set seldom reaches, while that of a
/// coordinate is what all rows imply; without this, rows that hardly bind are kept and coordinates freed that do.
const ROW_SHARE: f64 = 0.3;

/// What to free.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Choice {
    /// The coordinate of a column, solved for in a row.
    Generator {
        /// The column.
        column: usize,
        /// The row.
        row: usize,
    },
    /// The range of a row.
    Row(usize),
}

impl ConstrainedZonotope {
    /// Writes the `count` eliminations of least estimated loss to `workspace.choices`, the least first; there is at least one constraint, and
    /// `count` is at least one.
    ///
    /// The constraints come before the dimensions in `S`, so that of `S^-1 l` only the last entries are needed: `l' S^-1 l` is the
    /// squared length of half a solution.
    pub(super) fn rank_losses(&self, count: usize, workspace: &mut Workspace) {
        let (n, rows, columns) = (self.dim(), self.num_constraints(), self.num_generators());
        let (size, candidates) = (n + rows, columns + rows);
        let Workspace { frame: lift, eigen: factor, scales: units, coordinates: solved, row_sums, choices, .. } =
            workspace;
        // 1 / units, by the hull and the rows' reach.
        row_sums.clear();
        row_sums.resize(size, 0.0);
        add_abs_row_sums(self.constraints.as_slice(), &mut row_sums[..rows]);
        add_abs_row_sums(self.generators().as_slice(), &mut row_sums[rows..]);
        units.clear();
        units.extend(row_sums.iter().map(|&sum| if sum > 1e-300 { 1.0 / sum } else { 0.0 }));
        lift.clear();
        for j in 0..columns {
            let entries = self.constraints.col(j).iter().chain(self.generators().col(j));
            lift.extend(entries.zip(units.iter()).map(|(x, unit)| x * unit));
        }
        gram(lift, size, factor);
        for i in 0..size {
            let slack = if i < rows { (self.ranges[i].rad() * units[i]).powi(2) } else { WEIGHT };
            // The last term keeps dependent rows factorable.
            factor[i * size + i] += slack + 1e-13;
        }
        factorise(factor, size);

        // Row by row the entries of all candidates: columns, then ranges.
        solved.clear();
        for i in 0..size {
            solved.extend(lift.iter().skip(i).step_by(size));
            let radius = |k: usize| if k == i { self.ranges[k].rad() * units[k] } else { 0.0 };
            solved.extend((0..rows).map(radius));
        }
        solve_lower_rows(factor, size, solved);
        let (inner, outer) = solved.split_at_mut(rows * candidates);
        let rests = row_sums;
        rests.clear();
        rests.resize(candidates, 1.0);
        for row in inner.chunks_exact(candidates).chain(outer.chunks_exact(candidates)) {
            rests.iter_mut().zip(row).for_each(|(rest, x)| *rest -= x * x);
        }
        solve_upper_end(factor, size, n, outer);

        choices.clear();
        choices.push((f64::INFINITY, Choice::Row(rows - 1)));
        let mut consider = |candidate: usize, excess: f64, choice: Choice| {
            let moved = outer.iter().skip(candidate).step_by(candidates).map(|x| x * x).sum::<f64>().sqrt();
            let loss = excess * moved / rests[candidate].max(1e-12);
            // NaN fails the comparison.
            if let Some(place) = choices.iter().position(|(other, _)| loss < *other) {
                choices.insert(place, (loss, choice));
                choices.truncate(count);
            }
        };
        for j in 0..columns {
            if let Some((excess, row)) = self.excess(j, units) {
                consider(j, excess, Choice::Generator { column: j, row });
            }
        }
        for i in 0..rows {
            let (middle, radius) = (self.ranges[i].mid(), self.ranges[i].rad());
            if radius > 0.0 && units[i] > 0.0 {
                let excess = ((1.0 / units[i] + middle.abs()) / radius - 1.0).max(0.0);
                consider(columns + i, ROW_SHARE * excess, Choice::Row(i));
            }
        }
    }

    /// By how much `xi_j` may exceed `[-1, 1]` as far as single rows tell, and the row in which its entry is largest; `units` has `1 / |A_i|_1`.
    fn excess(&self, j: usize, units: &[f64]) -> Option<(f64, usize)> {
        let (mut lo, mut hi, mut largest) = (f64::NEG_INFINITY, f64::INFINITY, (1e-9, None));
        for (i, ((&a, &unit), range)) in self.constraints.col(j).iter().zip(units).zip(&self.ranges).enumerate() {
            let weight = a.abs() * unit;
            if weight < 1e-9 {
                continue;
            }
            if weight >= largest.0 {
                largest = (weight, Some(i));
            }
            let others = 1.0 / unit - a.abs();
            let ends = [(range.lo() - others) / a, (range.hi() + others) / a];
            lo = lo.max(ends[0].min(ends[1]));
            hi = hi.min(ends[0].max(ends[1]));
        }
        largest.1.map(|row| ((hi - 1.0).max(-1.0 - lo).max(0.0), row))
    }
}

/// Lower triangle of `L L'` (column-major), from the columns of `L`.
fn gram(lift: &[f64], size: usize, product: &mut Vec<f64>) {
    product.clear();
    product.resize(size * size, 0.0);
    for column in lift.chunks_exact(size) {
        for (k, &scale) in column.iter().enumerate().filter(|(_, scale)| **scale != 0.0) {
            let target = &mut product[k * size + k..(k + 1) * size];
            target.iter_mut().zip(&column[k..]).for_each(|(sum, x)| *sum += scale * x);
        }
    }
}
