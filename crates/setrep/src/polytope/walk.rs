//! Points as convex combinations of others, found by walking from facet to facet.
//!
//! Let `c` lie inside the hull of points `p_i` and let `q - c = sum w_i (p_i - c)` with `w >= 0` over `n` of them, whose cone then holds the
//! ray from `c` through `q`. Their hyperplane is `a'(p - c) = 1`, and `sum w = a'(q - c)`.
//! - `sum w <= 1`: `q` lies in the hull, `q = (1 - sum w) c + sum w_i p_i`.
//! - Else a point beyond the hyperplane replaces one of the `n`, so that the weights stay positive and their sum falls: a step of the
//!   simplex method for the place where the ray leaves the hull.
//! - No point is beyond: the hyperplane is a facet's and separates `q` from all points.
//!
//! All of it is plain floating point and may fail. Nothing of it is believed: callers prove what they use by the [`residual`] of the
//! weights, and keep a point for which that is not small.

use scalars::rounding::{UNIT_ROUNDOFF, sum_up, up};

use crate::Matrix;

/// Pivots below this share of the extents: the points are flat in that direction.
const FLAT: f64 = 1e-12;

/// Points beyond a hyperplane by less than this share of its distance from the center are on it.
const ON: f64 = 1e-13;

/// Points that are compared before one of them is gone to.
const ASKED_AT_ONCE: usize = 16;

/// Where the ray through a point leaves the hull.
pub(super) enum Place {
    /// In the hull: weights of the columns, together one.
    Inside(Vec<(usize, f64)>),
    /// Outside: the normal `a` of a facet that separates it, in the coordinates of the walk.
    Outside(Vec<f64>),
    /// Not found.
    Lost,
}

/// Some columns of a matrix, of which a part is known to span the hull.
pub(super) struct Walk {
    /// Number `n` of coordinates in use, the dimension of the hull.
    rank: usize,
    /// All columns relative to the center, in units of the extents: `n` numbers each.
    relative: Vec<f64>,
    /// `n + 1` independent columns; the center is their mean.
    basis: Vec<usize>,
    /// The inverse of the first `n` of them as columns.
    start: Vec<f64>,
    /// The columns that span the hull.
    pub(super) kept: Vec<usize>,
    /// The coordinates in use, and a unit for every coordinate.
    pub(super) coordinates: Vec<usize>,
    pub(super) units: Vec<f64>,
    /// The center in the coordinates of the columns, all of them.
    pub(super) center: Vec<f64>,
    facet: Vec<usize>,
    inverse: Vec<f64>,
    weights: Vec<f64>,
}

impl Walk {
    /// Starts from `n + 1` independent columns that are vertices of the hull; `None` beyond the range of floats.
    pub(super) fn new(columns: &Matrix) -> Option<Self> {
        let (n, m) = (columns.rows(), columns.cols());
        let mut units = vec![1.0; n];
        let mut middle = vec![0.0; n];
        for k in 0..n {
            let (lo, hi) =
                columns.columns().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v[k]), hi.max(v[k])));
            middle[k] = 0.5 * lo + 0.5 * hi;
            let half = 0.5 * hi - 0.5 * lo;
            if half > 0.0 {
                units[k] = half;
            }
            if !(half.is_finite() && (1.0 / units[k]).is_finite()) {
                return None;
            }
        }
        let table: Vec<f64> =
            columns.columns().flat_map(|v| (0..n).map(|k| (v[k] - middle[k]) / units[k]).collect::<Vec<_>>()).collect();
        let (basis, coordinates) = independent(&table, n, m);
        let rank = coordinates.len();
        let share = 1.0 / basis.len() as f64;
        let mean = |k: usize| basis.iter().map(|&j| table[j * n + k]).sum::<f64>() * share;
        let center: Vec<f64> = (0..n).map(|k| middle[k] + units[k] * mean(k)).collect();
        let origin: Vec<f64> = coordinates.iter().map(|&k| mean(k)).collect();
        let relative = (0..m)
            .flat_map(|j| coordinates.iter().zip(&origin).map(|(&k, c)| table[j * n + k] - c).collect::<Vec<_>>())
            .collect();
        let mut walk = Self {
            rank,
            relative,
            start: Vec::new(),
            kept: basis.clone(),
            basis,
            coordinates,
            units,
            center,
            facet: Vec::new(),
            inverse: Vec::new(),
            weights: vec![0.0; rank],
        };
        walk.facet = walk.basis[..rank].to_vec();
        if !walk.invert() {
            return None;
        }
        walk.start = core::mem::take(&mut walk.inverse);
        Some(walk)
    }

    /// Dimension of the hull.
    pub(super) fn rank(&self) -> usize {
        self.rank
    }

    /// A column relative to the center.
    pub(super) fn relative(&self, j: usize) -> &[f64] {
        &self.relative[j * self.rank..(j + 1) * self.rank]
    }

    /// Places a point, given relative to the center, for hulls that are `share` larger.
    pub(super) fn place(&mut self, q: &[f64], share: f64) -> Place {
        match self.follow(q, Some(1.0 + share)) {
            Some(None) => Place::Inside(self.combination()),
            Some(Some(normal)) => Place::Outside(normal),
            None => Place::Lost,
        }
    }

    /// How far the hull reaches from the center along `d`, as the largest `t` with `t d` in it, and weights of the columns for `share t d`.
    pub(super) fn shoot(&mut self, d: &[f64], share: f64) -> Option<(f64, Vec<(usize, f64)>)> {
        self.follow(d, None)??;
        let total: f64 = self.weights.iter().sum();
        self.weights.iter_mut().for_each(|w| *w *= share / total);
        Some((1.0 / total, self.combination()))
    }

    /// Walks to where the ray through `q` leaves the hull, or, given a limit, until the weights sum up to less. The normal of the facet
    /// there is `None` where the limit was met.
    #[allow(clippy::option_option)]
    fn follow(&mut self, q: &[f64], limit: Option<f64>) -> Option<Option<Vec<f64>>> {
        let n = self.rank;
        // Weights over the basis, all shifted until one of them is zero: the basis sums up to nothing.
        let mut shares: Vec<f64> = (0..n).map(|i| dot(&self.start[i * n..(i + 1) * n], q)).collect();
        shares.push(0.0);
        let least = (0..=n).min_by(|&i, &j| shares[i].total_cmp(&shares[j]))?;
        self.facet.clear();
        self.facet.extend((0..=n).filter(|&i| i != least).map(|i| self.basis[i]));
        for _ in 0..64 + 8 * self.kept.len() {
            if !self.invert() {
                return None;
            }
            for i in 0..n {
                self.weights[i] = dot(&self.inverse[i * n..(i + 1) * n], q).max(0.0);
            }
            if limit.is_some_and(|limit| self.weights.iter().sum::<f64>() <= limit) {
                return Some(None);
            }
            let normal: Vec<f64> = (0..n).map(|k| (0..n).map(|i| self.inverse[i * n + k]).sum()).collect();
            // The first points found are the most extreme; the others are asked only where these do not lead on.
            let mut beyond = (1.0 + ON, None);
            for some in self.kept.chunks(ASKED_AT_ONCE) {
                for &j in some {
                    let reach = dot(&normal, self.relative(j));
                    if reach > beyond.0 && !self.facet.contains(&j) {
                        beyond = (reach, Some(j));
                    }
                }
                if beyond.1.is_some() {
                    break;
                }
            }
            let Some(entering) = beyond.1 else { return Some(Some(normal)) };
            let mut leaving = (f64::INFINITY, None);
            for i in 0..n {
                let step = dot(&self.inverse[i * n..(i + 1) * n], self.relative(entering));
                if step > 1e-11 && self.weights[i] / step < leaving.0 {
                    leaving = (self.weights[i] / step, Some(i));
                }
            }
            self.facet[leaving.1?] = entering;
        }
        None
    }

    /// The weights of the last walk with the rest on the center; scaled to one where they are more.
    fn combination(&self) -> Vec<(usize, f64)> {
        let total: f64 = self.weights.iter().sum();
        let scale = if total > 1.0 { 1.0 / total } else { 1.0 };
        let mut weights: Vec<(usize, f64)> =
            self.facet.iter().zip(&self.weights).map(|(&j, w)| (j, w * scale)).collect();
        if total < 1.0 {
            let rest = (1.0 - total) / self.basis.len() as f64;
            for &j in &self.basis {
                match weights.iter_mut().find(|(i, _)| *i == j) {
                    Some((_, w)) => *w += rest,
                    None => weights.push((j, rest)),
                }
            }
        }
        weights
    }

    /// The inverse of the columns of the facet, by Gauss and Jordan; false if they are nearly dependent.
    fn invert(&mut self) -> bool {
        let n = self.rank;
        let mut matrix: Vec<f64> = (0..n * n).map(|at| self.relative(self.facet[at % n])[at / n]).collect();
        self.inverse.clear();
        self.inverse.resize(n * n, 0.0);
        (0..n).for_each(|i| self.inverse[i * n + i] = 1.0);
        for step in 0..n {
            let Some(pivot) =
                (step..n).max_by(|&i, &j| matrix[i * n + step].abs().total_cmp(&matrix[j * n + step].abs()))
            else {
                return false;
            };
            if matrix[pivot * n + step].abs() <= FLAT * 1e-3 {
                return false;
            }
            for k in 0..n {
                matrix.swap(step * n + k, pivot * n + k);
                self.inverse.swap(step * n + k, pivot * n + k);
            }
            let factor = 1.0 / matrix[step * n + step];
            for k in 0..n {
                matrix[step * n + k] *= factor;
                self.inverse[step * n + k] *= factor;
            }
            for i in (0..n).filter(|&i| i != step) {
                let factor = matrix[i * n + step];
                if factor != 0.0 {
                    for k in 0..n {
                        matrix[i * n + k] -= factor * matrix[step * n + k];
                        self.inverse[i * n + k] -= factor * self.inverse[step * n + k];
                    }
                }
            }
        }
        true
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Of some points those with the largest value; of several the last in lexicographic order, which is a vertex if the others are not.
pub(super) fn extreme<'a>(
    candidates: impl Iterator<Item = usize> + Clone,
    value: impl Fn(usize) -> f64,
    point: impl Fn(usize) -> &'a [f64],
) -> Option<usize> {
    let largest = candidates.clone().map(&value).fold(f64::NEG_INFINITY, f64::max);
    let level = largest - ON * largest.abs();
    candidates
        .filter(|&j| value(j) >= level)
        .max_by(|&i, &j| point(i).partial_cmp(point(j)).unwrap_or(core::cmp::Ordering::Equal))
}

/// Affinely independent columns that are vertices, and coordinates in which they are: elimination with complete pivoting.
fn independent(table: &[f64], n: usize, m: usize) -> (Vec<usize>, Vec<usize>) {
    let point = |j: usize| &table[j * n..(j + 1) * n];
    let first = extreme(0..m, |_| 0.0, point).unwrap_or(0);
    let mut left: Vec<f64> =
        (0..m).flat_map(|j| (0..n).map(move |k| table[j * n + k] - table[first * n + k])).collect();
    let (mut basis, mut coordinates) = (vec![first], Vec::new());
    while coordinates.len() < n {
        let Some(largest) = (0..left.len()).max_by(|&i, &j| left[i].abs().total_cmp(&left[j].abs())) else { break };
        if left[largest].abs() <= FLAT {
            break;
        }
        let (k, sign) = (largest % n, left[largest].signum());
        let Some(pivot) = extreme(0..m, |j| sign * left[j * n + k], point) else { break };
        let row: Vec<f64> = left[pivot * n..(pivot + 1) * n].to_vec();
        for j in 0..m {
            let factor = left[j * n + k] / row[k];
            (0..n).for_each(|i| left[j * n + i] -= factor * row[i]);
            left[j * n + k] = 0.0;
        }
        basis.push(pivot);
        coordinates.push(k);
    }
    (basis, coordinates)
}

/// By how much a point misses the convex combination of columns with the given weights, which are made to sum up to one: upper bounds,
/// coordinate by coordinate, into `lost`. False if the weights are none.
///
/// **Guarantee:** the point lies in the hull of the columns with weights, plus the box `[-lost, lost]`.
pub(super) fn residual(columns: &Matrix, x: &[f64], weights: &mut [(usize, f64)], lost: &mut [f64]) -> bool {
    let Some(largest) = (0..weights.len()).max_by(|&i, &j| weights[i].1.total_cmp(&weights[j].1)) else { return false };
    weights.swap(0, largest);
    let (anchor, others) = (weights[0].0, &mut weights[1..]);
    // The anchor has what the others leave.
    for attempt in 0.. {
        if !others.iter().all(|(_, w)| *w >= 0.0 && w.is_finite()) || attempt == 3 {
            return false;
        }
        let total = sum_up(others.iter().map(|(_, w)| *w));
        if total <= 1.0 {
            break;
        }
        others.iter_mut().for_each(|(_, w)| *w *= (1.0 - 1e-15) / total);
    }
    // Relative roundings of the terms, and of their sum.
    let roundings = (others.len() as f64 + 6.0) * UNIT_ROUNDOFF;
    for (k, lost) in lost.iter_mut().enumerate() {
        let from = columns[(k, anchor)];
        let offset = x[k] - from;
        let (mut rest, mut size) = (offset, offset.abs());
        for &(j, w) in others.iter().filter(|(_, w)| *w != 0.0) {
            let term = w * (columns[(k, j)] - from);
            rest -= term;
            size += term.abs();
        }
        // Where a term underflows it loses less than the smallest normal number.
        let floor = if size == 0.0 && others.iter().all(|(_, w)| *w == 0.0) { 0.0 } else { f64::MIN_POSITIVE };
        *lost = if size == 0.0 { floor } else { up(up(rest.abs() + roundings * size * (1.0 + 1e-9)) + floor) };
        if !lost.is_finite() {
            return false;
        }
    }
    true
}
