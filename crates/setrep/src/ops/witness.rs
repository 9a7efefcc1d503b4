//! Proof that a point lies in a zonotope, by a witness.

use nalgebra::{DMatrix, DVector};
use scalars::Interval;
use scalars::rounding::{add_up, div_up, mul_up, sub_down};

use super::membership::Query;
use crate::{Matrix, Zonotope};

/// Rounds of clamping before the search gives up; the facets then decide.
const MAX_ROUNDS: usize = 12;

/// A candidate `xi`, the columns whose `xi_j` is strictly inside, and the map from a residual to a correction of these.
struct Candidate {
    xi: Vec<f64>,
    free: Vec<bool>,
    /// Row `j` of `K: ng x n`, in units of the hull's half-widths: a residual `z` is corrected by `K z` (zero for fixed columns).
    correction: DMatrix<f64>,
}

impl Zonotope {
    /// Whether a point `xi` of the unit cube with `G xi = p - c` is proven to exist for every point `p` of the query.
    ///
    /// The candidate comes from least squares with columns clamped to `+-1` one after the other. Its exact residual `s` is then
    /// corrected: with `D = diag(h)` of half-widths, `E = D^-1 G K - I` and `|E|_inf < 1` there is a `z` with `G K z = s` and
    /// `|z|_inf <= |D^-1 s|_inf / (1 - |E|_inf)`, so `xi + K z` is a witness if `|xi_j| + sum_l |K_jl| |z|_inf <= 1` for the free
    /// columns. Everything is evaluated in interval arithmetic; the box remainder takes part as generators.
    pub(crate) fn has_witness(&self, query: &Query) -> bool {
        let flat = |k: usize| query.hull[k] == 0.0;
        if (0..self.dim()).any(|k| flat(k) && query.offset[k].mag() > 0.0) {
            return false;
        }
        let rows: Vec<usize> = (0..self.dim()).filter(|&k| !flat(k)).collect();
        let generators = self.all_generators();
        // A set without extent is its center, which the flat rows just compared.
        rows.is_empty()
            || candidate(&generators, query, &rows).is_some_and(|c| is_proven(&generators, query, &rows, &c))
    }
}

/// Searches a candidate in plain floating point.
fn candidate(generators: &Matrix, query: &Query, rows: &[usize]) -> Option<Candidate> {
    let (m, n) = (generators.cols(), rows.len());
    let scaled = DMatrix::from_fn(n, m, |i, j| generators.col(j)[rows[i]] / query.hull[rows[i]]);
    let target = DVector::from_fn(n, |i, _| query.mid[rows[i]] / query.hull[rows[i]]);
    let (mut xi, mut free) = (vec![0.0; m], vec![true; m]);
    for _ in 0..MAX_ROUNDS {
        let (mut rest, mut gram) = (target.clone(), DMatrix::zeros(n, n));
        for j in 0..m {
            let g = scaled.column(j);
            if free[j] {
                gram.ger(1.0, &g, &g, 1.0);
            } else {
                rest.axpy(-xi[j], &g, 1.0);
            }
        }
        let inverse = gram.try_inverse()?;
        let multiplier = &inverse * rest;
        let mut clamped = false;
        for j in (0..m).filter(|&j| free[j]).collect::<Vec<_>>() {
            xi[j] = scaled.column(j).dot(&multiplier);
            if xi[j].abs() >= 1.0 {
                xi[j] = xi[j].signum();
                free[j] = false;
                clamped = true;
            }
        }
        if !clamped {
            let mut correction = scaled.transpose() * inverse;
            for j in (0..m).filter(|&j| !free[j]) {
                correction.row_mut(j).fill(0.0);
            }
            return xi.iter().all(|x| x.is_finite()).then_some(Candidate { xi, free, correction });
        }
    }
    None
}

/// Verifies a candidate.
fn is_proven(generators: &Matrix, query: &Query, rows: &[usize], candidate: &Candidate) -> bool {
    let (mut residual, mut contraction) = (0.0_f64, 0.0_f64);
    for (i, &k) in rows.iter().enumerate() {
        let half_width = query.hull[k];
        let mut exact = query.offset[k];
        let mut errors = vec![Interval::ZERO; rows.len()];
        errors[i] = Interval::point(-half_width);
        for (j, column) in generators.columns().enumerate() {
            let g = Interval::point(column[k]);
            exact -= g.scale(candidate.xi[j]);
            if candidate.free[j] {
                for (l, error) in errors.iter_mut().enumerate() {
                    *error += g.scale(candidate.correction[(j, l)]);
                }
            }
        }
        residual = residual.max(div_up(exact.mag(), half_width));
        let row_sum = errors.iter().fold(0.0, |sum, error| add_up(sum, error.mag()));
        contraction = contraction.max(div_up(row_sum, half_width));
    }
    let gap = sub_down(1.0, contraction);
    if gap.is_nan() || gap <= 0.0 {
        return false;
    }
    let step = div_up(residual, gap);
    (0..candidate.xi.len()).filter(|&j| candidate.free[j]).all(|j| {
        let reach = candidate.correction.row(j).iter().fold(0.0, |sum, k| add_up(sum, k.abs()));
        add_up(candidate.xi[j].abs(), mul_up(reach, step)) <= 1.0
    })
}
