//! The rays of a cone: floating-point enclosures that carry a proven error, exact integers where these cannot decide.
//!
//! A ray is a direction. For some positive multiple `y*` of the exact ray, `|y*_k - c_k| <= e` for every `k`, with `|c|` near 1.
//! The sign of `a'y*` is decided by the first of
//! 1. the float `a'c` when it exceeds `|a|_1 (e + rounding)`;
//! 2. the same after the ray has been solved for anew from its tight constraints, with a verified error;
//! 3. an error-free dot product, for rays that are floats exactly (axis-aligned facets, integer data);
//! 4. integers of any size.

use core::cmp::Ordering;

use num_bigint::BigInt;
use scalars::rounding::UNIT_ROUNDOFF;

use super::error_free::exact_sum;
use super::exact::{dot, ray_of, scaled, sign};
use super::incidence::{BitSets, iter};
use super::rows::{IntegerRow, Rows};
use super::solve::{Solver, pivots};
use crate::bounds::power_of_two_below;

/// Underflow in products and scaled rows stays below this.
const TINY: f64 = 1e-290;

/// Rays born with a larger error are solved for at once.
const COARSE: f64 = 1e-6;

/// `a'y*` of a row and a ray: `sign` is exact, `|a'y* - mid| <= err`.
#[derive(Clone, Copy)]
pub(super) struct Value {
    pub(super) sign: Ordering,
    pub(super) mid: f64,
    pub(super) err: f64,
}

/// Storage of rays, slots reused.
pub(super) struct Rays {
    dim: usize,
    centers: Vec<f64>,
    errors: Vec<f64>,
    solved: Vec<bool>,
    exact: Vec<Option<IntegerRow>>,
    /// The inserted constraints (by slot) that are tight at each ray.
    pub(super) tight: BitSets,
    solver: Solver,
}

impl Rays {
    pub(super) fn new(dim: usize, constraints: usize) -> Self {
        Self {
            dim,
            centers: Vec::new(),
            errors: Vec::new(),
            solved: Vec::new(),
            exact: Vec::new(),
            tight: BitSets::new(0, constraints),
            solver: Solver::default(),
        }
    }

    /// A new slot that holds nothing.
    pub(super) fn push(&mut self) -> usize {
        self.centers.resize(self.centers.len() + self.dim, 0.0);
        self.errors.push(f64::INFINITY);
        self.solved.push(false);
        self.exact.push(None);
        self.tight.push_empty()
    }

    /// Empties a slot for a new ray.
    pub(super) fn clear(&mut self, ray: usize) {
        self.errors[ray] = f64::INFINITY;
        self.solved[ray] = false;
        self.exact[ray] = None;
        self.tight.get_mut(ray).fill(0);
    }

    /// The floats of a ray.
    #[inline]
    pub(super) fn center(&self, ray: usize) -> &[f64] {
        &self.centers[ray * self.dim..(ray + 1) * self.dim]
    }

    /// The proven error of the floats, the same for each entry.
    #[inline]
    pub(super) fn error(&self, ray: usize) -> f64 {
        self.errors[ray]
    }

    /// The integers of a ray, if they were needed.
    pub(super) fn integers(&self, ray: usize) -> Option<&[BigInt]> {
        self.exact[ray].as_ref().map(|exact| &*exact.entries)
    }

    /// The filter's value of a row at a ray, `None` where it does not decide.
    #[inline]
    pub(super) fn estimate(&self, rows: &Rows<'_>, ray: usize, row: usize) -> Option<Value> {
        let mid: f64 = rows.row(row).iter().zip(self.center(ray)).map(|(a, y)| a * y).sum();
        // |y| <= 2; dim + 2 roundings of products with |a|_1.
        let rounding = 2.0 * (self.dim as f64 + 3.0) * UNIT_ROUNDOFF;
        let err = rows.norm(row) * (self.errors[ray] + rounding) + TINY;
        if mid > err {
            Some(Value { sign: Ordering::Greater, mid, err })
        } else if mid < -err {
            Some(Value { sign: Ordering::Less, mid, err })
        } else {
            None
        }
    }

    /// The value of a row at a ray, sign exact. `slots` maps constraints of the tight sets to rows; they span the space.
    #[inline]
    pub(super) fn value(&mut self, rows: &Rows<'_>, slots: &[u32], ray: usize, row: usize) -> Value {
        match self.estimate(rows, ray, row) {
            Some(value) => value,
            None => self.value_exactly(rows, slots, ray, row),
        }
    }

    #[cold]
    fn value_exactly(&mut self, rows: &Rows<'_>, slots: &[u32], ray: usize, row: usize) -> Value {
        if !self.solved[ray] {
            self.solve(rows, slots, ray);
            if let Some(value) = self.estimate(rows, ray, row) {
                return value;
            }
        }
        let is_float = self.errors[ray] == 0.0 && !rows.has_underflow();
        let products = rows.row(row).iter().copied().zip(self.center(ray).iter().copied());
        if let Some(mid) = is_float.then(|| exact_sum(products)).flatten() {
            let sign = mid.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
            return Value { sign, mid, err: mid.abs() * 8.0 * UNIT_ROUNDOFF };
        }
        self.make_exact(rows, slots, ray);
        let Some(exact) = &self.exact[ray] else {
            // Not reached: the tight constraints of an extreme ray have rank dim - 1.
            return Value { sign: Ordering::Equal, mid: 0.0, err: f64::INFINITY };
        };
        let integers = rows.integers(row);
        let value = dot(&integers.entries, &exact.entries);
        let mid = scaled(&value, integers.shift + exact.shift).0;
        Value { sign: sign(&value), mid, err: mid.abs() * 4.0 * UNIT_ROUNDOFF + if mid == 0.0 { 0.0 } else { TINY } }
    }

    /// Solves for a ray from its tight constraints; keeps the tighter enclosure.
    pub(super) fn solve(&mut self, rows: &Rows<'_>, slots: &[u32], ray: usize) {
        self.solved[ray] = true;
        if rows.has_underflow() {
            return;
        }
        let n = self.dim;
        let tight: Vec<usize> = iter(self.tight.get(ray)).map(|slot| slots[slot] as usize).collect();
        let matrix: Vec<f64> = tight.iter().flat_map(|&row| rows.row(row)).copied().collect();
        let Some((row_order, col_order)) = pivots(&mut matrix.clone(), n, n - 1) else { return };
        let free = col_order[n - 1];
        let mut square = Vec::with_capacity((n - 1) * (n - 1));
        let mut rhs = Vec::with_capacity(n - 1);
        for &i in &row_order[..n - 1] {
            let row = &matrix[i * n..(i + 1) * n];
            square.extend(col_order[..n - 1].iter().map(|&k| row[k]));
            rhs.push(-row[free]);
        }
        if !self.solver.solve(n - 1, &square, &rhs) {
            return;
        }
        let mut y = vec![0.0; n];
        y[free] = 1.0;
        for (&k, &x) in col_order.iter().zip(&self.solver.solution) {
            y[k] = x;
        }
        let largest = y.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let factor = power_of_two_near(1.0 / largest);
        let error = self.solver.radius.iter().fold(0.0_f64, |m, &r| m.max(r)) * factor;
        if error.is_nan() || error >= self.errors[ray] {
            return;
        }
        for x in &mut y {
            *x *= factor;
        }
        let before = (self.errors[ray], self.center(ray).to_vec());
        self.set(ray, &y, if error == 0.0 { 0.0 } else { error + TINY });
        // Some constraint is not tight, hence positive: it tells the ray from its opposite.
        let mut loose = (0..slots.len()).filter(|&slot| !self.tight.contains(ray, slot));
        match loose.find_map(|slot| self.estimate(rows, ray, slots[slot] as usize)) {
            Some(Value { sign: Ordering::Less, .. }) => {
                for x in &mut self.centers[ray * n..(ray + 1) * n] {
                    *x = -*x;
                }
            }
            Some(_) => {}
            None => self.set(ray, &before.1, before.0),
        }
    }

    /// A ray to floating-point accuracy, without a bound of the error; `None` beside pivots that are too small.
    ///
    /// What is already known to full accuracy is returned as it is; else the tight constraints are eliminated once.
    pub(super) fn approximate(&self, rows: &Rows<'_>, slots: &[u32], ray: usize) -> Option<Vec<f64>> {
        let n = self.dim;
        if self.errors[ray] < 16.0 * UNIT_ROUNDOFF {
            return Some(self.center(ray).to_vec());
        }
        let mut matrix: Vec<f64> =
            iter(self.tight.get(ray)).flat_map(|slot| rows.row(slots[slot] as usize)).copied().collect();
        let (row_order, col_order) = pivots(&mut matrix, n, n - 1)?;
        let mut y = vec![0.0; n];
        y[col_order[n - 1]] = 1.0;
        for step in (0..n - 1).rev() {
            let row = &matrix[row_order[step] * n..(row_order[step] + 1) * n];
            let sum: f64 = col_order[step + 1..].iter().map(|&k| row[k] * y[k]).sum();
            y[col_order[step]] = -sum / row[col_order[step]];
        }
        // The enclosure tells the ray from its opposite.
        let along: f64 = y.iter().zip(self.center(ray)).map(|(a, b)| a * b).sum();
        if !(self.errors[ray] < 0.1 && along.abs() > 0.0) {
            return None;
        }
        let factor = along.signum() / y.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        Some(y.iter().map(|x| x * factor).collect())
    }

    /// Computes a ray in integers from its tight constraints, and its floats from these.
    pub(super) fn make_exact(&mut self, rows: &Rows<'_>, slots: &[u32], ray: usize) {
        if self.exact[ray].is_some() {
            return;
        }
        let row = |slot: usize| &*rows.integers(slots[slot] as usize).entries;
        let tight = iter(self.tight.get(ray)).map(row);
        let loose = (0..slots.len()).filter(|&slot| !self.tight.contains(ray, slot)).map(row);
        let Some(entries) = ray_of(self.dim, tight, loose) else { return };
        let shift = entries.iter().map(BigInt::bits).max().unwrap_or(1) as i64 - 1;
        let parts: Vec<(f64, bool)> = entries.iter().map(|x| scaled(x, shift)).collect();
        let error = if parts.iter().all(|part| part.1) { 0.0 } else { 4.0 * UNIT_ROUNDOFF + TINY };
        let center: Vec<f64> = parts.iter().map(|part| part.0).collect();
        self.set(ray, &center, error);
        self.solved[ray] = true;
        self.exact[ray] = Some(IntegerRow { entries, shift });
    }

    /// Sets a ray to a row of another system, which is known exactly.
    pub(super) fn set_exact(&mut self, ray: usize, dual: &Rows<'_>, row: usize) {
        let integers = dual.integers(row);
        // Floats that may have lost digits to underflow are off by less than TINY.
        self.set(ray, dual.row(row), if dual.has_underflow() { TINY } else { 0.0 });
        self.solved[ray] = true;
        self.exact[ray] = Some(IntegerRow { entries: integers.entries.clone(), shift: integers.shift });
    }

    /// Sets the enclosure of a ray; `|center|` is at most 2.
    fn set(&mut self, ray: usize, center: &[f64], error: f64) {
        self.centers[ray * self.dim..(ray + 1) * self.dim].copy_from_slice(center);
        self.errors[ray] = error;
    }

    /// Encloses the positive combination `s_p y_n - s_n y_p`, on which the row that gave `s_p > 0 > s_n` is tight.
    pub(super) fn combine(&mut self, ray: usize, (p, at_p): (usize, Value), (n, at_n): (usize, Value)) {
        let (weight_n, weight_p) = (at_p.mid.abs(), at_n.mid.abs());
        let (error_p, error_n) = (self.errors[p], self.errors[n]);
        let mut largest = 0.0_f64;
        for k in 0..self.dim {
            let x = weight_n * self.centers[n * self.dim + k] + weight_p * self.centers[p * self.dim + k];
            self.centers[ray * self.dim + k] = x;
            largest = largest.max(x.abs());
        }
        // |s y - w c| <= w e + |s - w| (|c| + e), and three roundings of terms of at most 2 w.
        let error = weight_n * error_n
            + at_p.err * (2.0 + error_n)
            + weight_p * error_p
            + at_n.err * (2.0 + error_p)
            + 8.0 * UNIT_ROUNDOFF * (weight_n + weight_p);
        let factor = power_of_two_near(1.0 / largest);
        for x in &mut self.centers[ray * self.dim..(ray + 1) * self.dim] {
            *x *= factor;
        }
        let error = error * factor * (1.0 + 1e-12) + TINY;
        // NaN and everything too coarse: nothing is known.
        self.errors[ray] = if error < 1.0 { error } else { f64::INFINITY };
    }

    /// Whether the enclosure of a ray is too coarse to pass on.
    pub(super) fn is_coarse(&self, ray: usize) -> bool {
        self.errors[ray] > COARSE && !self.solved[ray]
    }
}

/// A power of two within a factor 2 of `x`, at most `x`; NaN where there is none.
fn power_of_two_near(x: f64) -> f64 {
    if x.is_normal() { power_of_two_below(x) } else { f64::NAN }
}
