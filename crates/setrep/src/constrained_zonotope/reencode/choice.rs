//! Which directions become constraints: greedily, where the result is widest beside the set.

use scalars::Interval;

use super::one_row::one_row;
use super::{Reencoding, Scratch, TemplateWidths};
use crate::constrained_zonotope::optimizer::{prepared, refused};
use crate::{ConstrainedZonotope, SetError, Workspace};

/// Directions with a larger squared cosine, in units of the hull, count as one: a cosine of 0.9995.
const PARALLEL: f64 = 0.9995 * 0.9995;

/// A candidate that is chosen has seen all rows there will be.
const CHOSEN: usize = usize::MAX;

/// Buffers of the choice.
///
/// A row only narrows the result, so that the ratio of a candidate's widths only rises: one that was found before some of the rows were
/// added is a lower bound. The candidate of least bound is brought up to date until the least is; most are never looked at again.
#[derive(Debug, Default, Clone)]
pub(super) struct Choice {
    /// Indices of the candidates taken, in order.
    pub(super) chosen: Vec<usize>,
    /// `G'd`, candidate after candidate; those of the chosen are the rows.
    coefficients: Vec<f64>,
    /// Half-widths of the result along the candidates, about its center: down and up.
    reach: Vec<(f64, f64)>,
    /// With how many rows they were found.
    seen: Vec<usize>,
    negated: Vec<f64>,
    breakpoints: Vec<(f64, f64)>,
}

impl ConstrainedZonotope {
    /// Adds rows to the parallelotope: the candidate of least width over the set beside its width over the result, again and again.
    pub(super) fn add_rows(
        &mut self,
        options: Reencoding,
        scratch: &mut Scratch,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let Scratch { candidates, ranges, choice, .. } = scratch;
        let (n, columns) = (self.dim(), self.num_generators());
        choice.start(self, candidates);
        if options.widths == TemplateWidths::LinearPrograms {
            prepared(&mut workspace.solver)?.load_columns(columns, &[], &[], &[]).map_err(refused)?;
        }
        while choice.chosen.len() < options.constraints {
            let Some(k) = choice.widest(ranges, options.stop_ratio) else { break };
            if choice.seen[k] < choice.chosen.len() {
                match options.widths {
                    TemplateWidths::SingleRows => choice.narrow_by_rows(k, columns, &self.ranges),
                    TemplateWidths::LinearPrograms => {
                        choice.narrow_by_programs(k, columns, prepared(&mut workspace.solver)?);
                    }
                }
                continue;
            }
            choice.seen[k] = CHOSEN;
            choice.chosen.push(k);
            self.push_row(&candidates[k * n..(k + 1) * n], ranges[k], &mut workspace.objective)?;
            if options.widths == TemplateWidths::LinearPrograms {
                let range = self.ranges[self.ranges.len() - 1];
                let solver = prepared(&mut workspace.solver)?;
                solver.push_row(&workspace.objective, range.lo(), range.hi()).map_err(refused)?;
            }
        }
        Ok(())
    }

    /// Appends the row `d'x in [q]` as `d'G xi in [q] - d'c +- |d|'r`; leaves `d'G` in `row`.
    fn push_row(&mut self, d: &[f64], range: Interval, row: &mut Vec<f64>) -> Result<(), SetError> {
        let index = self.ranges.len();
        row.clear();
        row.resize(self.num_generators(), 0.0);
        let formed = self.form_row(d, range, row, 0.0, 0).ok_or(SetError::Overflow { row: index })?;
        self.constraints.push_zero_rows(1);
        for (j, &a) in row.iter().enumerate() {
            self.constraints.col_mut(j)[index] = a;
        }
        self.ranges.push(formed);
        Ok(())
    }
}

impl Choice {
    /// Nothing chosen; the reach of the parallelotope.
    fn start(&mut self, body: &ConstrainedZonotope, candidates: &[f64]) {
        self.chosen.clear();
        self.coefficients.clear();
        self.reach.clear();
        for d in candidates.chunks_exact(body.dim()) {
            let mut sum = 0.0;
            for g in body.generators().columns() {
                let f: f64 = d.iter().zip(g).map(|(d, g)| d * g).sum();
                sum += f.abs();
                self.coefficients.push(f);
            }
            self.reach.push((sum, sum));
        }
        self.seen.clear();
        self.seen.resize(self.reach.len(), 0);
    }

    /// The candidate of least ratio of its widths over the set and, as far as it is known, over the result, if that is below `stop`.
    fn widest(&self, ranges: &[Interval], stop: f64) -> Option<usize> {
        let mut best = (stop, None);
        for (k, (range, (below, above))) in ranges.iter().zip(&self.reach).enumerate() {
            let ratio = range.width() / (below + above);
            // A ratio of nothing to nothing is NaN, and not below.
            if ratio < best.0 && self.seen[k] != CHOSEN {
                best = (ratio, Some(k));
            }
        }
        best.1
    }

    /// The widths along candidate `k` over the new rows, each by itself.
    fn narrow_by_rows(&mut self, k: usize, columns: usize, ranges: &[Interval]) {
        let Self { chosen, coefficients, reach, seen, breakpoints, .. } = self;
        let of = |k: usize| &coefficients[k * columns..(k + 1) * columns];
        let (below, above) = &mut reach[k];
        for (&row, range) in chosen.iter().zip(ranges).skip(seen[k]) {
            *above = above.min(one_row(of(k), of(row), range.lo(), range.hi(), breakpoints));
            *below = below.min(one_row(of(k), of(row), -range.hi(), -range.lo(), breakpoints));
        }
        seen[k] = chosen.len();
    }

    /// The widths along candidate `k` over all rows that the solver holds.
    fn narrow_by_programs(&mut self, k: usize, columns: usize, solver: &mut boxlp::Solver) {
        let f = &self.coefficients[k * columns..(k + 1) * columns];
        let mut bound = |f: &[f64]| solver.maximize(f).map_or(f64::INFINITY, |solution| solution.bound);
        let (below, above) = &mut self.reach[k];
        self.negated.clear();
        self.negated.extend(f.iter().map(|f| -f));
        *above = above.min(bound(f));
        *below = below.min(bound(&self.negated));
        self.seen[k] = self.chosen.len();
    }
}

/// Whether two directions nearly agree up to sign, in the units given.
pub(super) fn parallel(a: &[f64], b: &[f64], units: &[f64]) -> bool {
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    for ((a, b), unit) in a.iter().zip(b).zip(units) {
        let (a, b) = (a * unit, b * unit);
        ab += a * b;
        aa += a * a;
        bb += b * b;
    }
    ab * ab > PARALLEL * aa * bb
}
