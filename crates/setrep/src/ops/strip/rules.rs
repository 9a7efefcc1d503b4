//! Rules for the weights of a strip, in plain floating point: any choice gives an enclosure.

use crate::cholesky::{factorise, solve_lower};
use crate::{Workspace, Zonotope};

/// Share of the units that keeps the factorisation of a flat set going; it judges the set within its span.
const FLATNESS: f64 = 1e-13;

/// What a rule says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Choice {
    /// Leave the set alone.
    Unchanged,
    /// The weights in `workspace.scales`.
    Weights {
        /// The generator that the weights make zero, up to rounding.
        replaced: Option<usize>,
    },
}

impl Zonotope {
    /// Bravo's candidate of least determinant, if one is below the set's own.
    pub(super) fn least_determinant(&self, a: &[f64], sigma: f64, workspace: &mut Workspace) -> Choice {
        let n = self.dim();
        self.scaled_factor(workspace);
        let Workspace { eigen: factor, scales: weights, objective: units, .. } = workspace;
        // The width of the strip is common to all: the least g'(G G')^-1 g / (a'g)^2 wins, also for a strip of width 0.
        let mut best: Option<(f64, usize)> = None;
        for (j, column) in self.generators.columns().enumerate() {
            weights.clear();
            weights.extend(column.iter().zip(units.iter()).map(|(g, unit)| g * unit));
            solve_lower(factor, n, weights);
            let leverage: f64 = weights.iter().map(|w| w * w).sum();
            let share = leverage / dot(a, column).powi(2);
            // NaN and infinity are no candidates, nor is the zero that an overflow leaves.
            if share > 0.0 && share < best.map_or(f64::MAX, |(least, _)| least) {
                best = Some((share, j));
            }
        }
        let Some((share, j)) = best else { return Choice::Unchanged };
        let smaller = sigma * sigma * share < 1.0;
        if !smaller {
            return Choice::Unchanged;
        }
        self.candidate(j, a, weights)
    }

    /// The candidate of least volume, if one is below the set's own.
    pub(super) fn least_volume(&self, a: &[f64], sigma: f64, workspace: &mut Workspace) -> Choice {
        let total = match self.sum_minors(workspace) {
            Ok(total) if total > 0.0 => total,
            _ => return self.least_determinant(a, sigma, workspace),
        };
        let Workspace { coordinates: sums, scales: weights, .. } = workspace;
        // The width of the strip is common to all.
        let mut best: Option<(f64, usize)> = None;
        for (j, (column, sum)) in self.generators.columns().zip(sums.iter()).enumerate() {
            let share = sum / dot(a, column).abs();
            // NaN and infinity are no candidates.
            if share < best.map_or(f64::MAX, |(least, _)| least) {
                best = Some((share, j));
            }
        }
        match best {
            Some((share, j)) if sigma * share < total => self.candidate(j, a, weights),
            _ => Choice::Unchanged,
        }
    }

    /// The weights of candidate `j`.
    fn candidate(&self, j: usize, a: &[f64], weights: &mut Vec<f64>) -> Choice {
        let column = self.generators.col(j);
        let along = dot(a, column);
        weights.clear();
        weights.extend(column.iter().map(|g| g / along));
        finite(Choice::Weights { replaced: Some(j) }, weights)
    }

    /// The weights of least F-radius.
    pub(super) fn least_segments(&self, a: &[f64], sigma: f64, workspace: &mut Workspace) -> Choice {
        let Workspace { gram, scales: weights, .. } = workspace;
        self.covariation_into(gram);
        weights.clear();
        weights.extend((0..self.dim()).map(|i| dot(gram.col(i), a)));
        let spread = dot(a, weights) + sigma * sigma;
        weights.iter_mut().for_each(|w| *w /= spread);
        finite(Choice::Weights { replaced: None }, weights)
    }

    /// The Cholesky factor of `G G' + diag(r)^2` in units of its diagonal, in `workspace.eigen`, the inverse units in `objective`.
    fn scaled_factor(&self, workspace: &mut Workspace) {
        let n = self.dim();
        let Workspace { gram, eigen: factor, objective: units, .. } = workspace;
        self.covariation_into(gram);
        units.clear();
        units.extend((0..n).map(|i| {
            let squared = gram[(i, i)];
            if squared > 0.0 { 1.0 / squared.sqrt() } else { 0.0 }
        }));
        factor.clear();
        for k in 0..n {
            factor.extend((0..n).map(|i| gram[(i, k)] * units[i] * units[k]));
            factor[k * n + k] += FLATNESS;
        }
        factorise(factor, n);
    }
}

/// The choice, if its weights are numbers.
fn finite(choice: Choice, weights: &[f64]) -> Choice {
    if weights.iter().all(|w| w.is_finite()) { choice } else { Choice::Unchanged }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
