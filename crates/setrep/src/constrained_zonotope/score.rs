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
use crate::cholesky::{factorise, solve};

/// Weight of the change of coordinates, in units of the hull.
const WEIGHT: f64 = 0.1;

/// Share of the excess of a row range that is counted. It is measured by the 1-norm of the row, which a set seldom reaches, while that of a
/// coordinate is what all rows imply; without this, rows that hardly bind are kept and coordinates freed that do.
const ROW_SHARE: f64 = 0.3;

/// What to free.
#[derive(Debug, Clone, Copy)]
pub(super) enum Choice {
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
    /// The elimination of least estimated loss; there is at least one constraint.
    pub(super) fn least_loss(&self, workspace: &mut Workspace) -> Choice {
        let (n, rows, columns) = (self.dim(), self.num_constraints(), self.num_generators());
        let size = n + rows;
        // Columns of L in units of the hull and of the rows' reach, and 1 / units.
        let Workspace { frame: lift, eigen: factor, scales: units, coordinates: solution, remainder: bounds, .. } =
            workspace;
        bounds.clear();
        bounds.extend((0..rows).map(|i| self.row_bound(i)));
        units.clear();
        units.resize(size, 0.0);
        for j in 0..columns {
            let entries = self.generators().col(j).iter().chain(self.constraints.col(j));
            units.iter_mut().zip(entries).for_each(|(sum, x)| *sum += x.abs());
        }
        units.iter_mut().for_each(|sum| *sum = if *sum > 1e-300 { 1.0 / *sum } else { 0.0 });
        lift.clear();
        for j in 0..columns {
            let entries = self.generators().col(j).iter().chain(self.constraints.col(j));
            lift.extend(entries.zip(units.iter()).map(|(x, unit)| x * unit));
        }
        factor.clear();
        factor.resize(size * size, 0.0);
        for column in lift.chunks_exact(size) {
            for k in 0..size {
                for i in k..size {
                    factor[k * size + i] += column[i] * column[k];
                }
            }
        }
        for i in 0..size {
            let slack = if i < n { WEIGHT } else { (self.ranges[i - n].rad() * units[i]).powi(2) };
            // The last term keeps dependent rows factorable.
            factor[i * size + i] += slack + 1e-13;
        }
        factorise(factor, size);

        let mut best = (f64::INFINITY, Choice::Row(rows - 1));
        let mut consider = |excess: f64, column: &[f64], choice: Choice| {
            solution.clear();
            solution.extend_from_slice(column);
            solve(factor, size, solution);
            let moved = solution[..n].iter().map(|x| x * x).sum::<f64>().sqrt();
            let rest: f64 = 1.0 - column.iter().zip(solution.iter()).map(|(l, x)| l * x).sum::<f64>();
            let loss = excess * moved / rest.max(1e-12);
            // NaN fails the comparison.
            if loss < best.0 {
                best = (loss, choice);
            }
        };
        for j in 0..columns {
            if let Some((excess, row)) = self.excess(j, units, bounds) {
                let column = &lift[j * size..(j + 1) * size];
                consider(excess, column, Choice::Generator { column: j, row });
            }
        }
        let column = &mut workspace.row_sums;
        for i in 0..rows {
            let (middle, radius) = (self.ranges[i].mid(), self.ranges[i].rad());
            if radius > 0.0 {
                column.clear();
                column.resize(size, 0.0);
                column[n + i] = radius * units[n + i];
                let excess = ((bounds[i] + middle.abs()) / radius - 1.0).max(0.0);
                consider(ROW_SHARE * excess, column, Choice::Row(i));
            }
        }
        best.1
    }

    /// By how much `xi_j` may exceed `[-1, 1]` as far as single rows (of 1-norm `bounds`) tell, and the row in which its entry is largest (in `units`).
    fn excess(&self, j: usize, units: &[f64], bounds: &[f64]) -> Option<(f64, usize)> {
        let n = self.dim();
        let weight = |i: usize| self.constraints.col(j)[i].abs() * units[n + i];
        let row = (0..self.num_constraints()).max_by(|&i, &k| weight(i).total_cmp(&weight(k)))?;
        if weight(row) < 1e-9 {
            return None;
        }
        let (mut lo, mut hi) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in (0..self.num_constraints()).filter(|&i| weight(i) >= 1e-9) {
            let implied = self.implied(i, j, bounds[i]);
            lo = lo.max(implied.lo());
            hi = hi.min(implied.hi());
        }
        Some(((hi - 1.0).max(-1.0 - lo).max(0.0), row))
    }
}
