//! Exchanges: one basic variable leaves, one nonbasic variable enters.

use super::{Flip, Tableau, Violation, add_multiple};
use crate::real::Real;

/// Dividing by less than this costs digits: the vertex is compared with the data from then on.
const DELICATE: f64 = 1e-3;

impl<T: Real> Tableau<T> {
    /// One dual simplex step: `flips`, then the violated variable goes to its bound and the variable of column `q` enters.
    pub(crate) fn step(&mut self, violation: Violation<T>, q: usize, flips: &[Flip<T>]) {
        let r = violation.row;
        let mut value = self.rows.value[r];
        for &(j, change) in flips {
            value += self.matrix[r * self.stride + j as usize] * change;
            self.columns.flip(j as usize);
        }
        let target = if violation.sign > T::ZERO { self.rows.upper[r] } else { self.rows.lower[r] };
        let change = (target - value).over(self.matrix[r * self.stride + q]);
        let entering = self.columns.value[q] + change;
        self.columns.value[q] = target;
        self.columns.side[q] = violation.sign;
        self.exchange(r, q, change, flips);
        self.rows.value[r] = entering;
    }

    /// Exchanges the basic variable of row `r` with the nonbasic one of column `q`, whose value changes by `change`.
    pub(super) fn exchange(&mut self, r: usize, q: usize, change: T, flips: &[Flip<T>]) {
        let stride = self.stride;
        let pivot_row = &mut self.pivot_row[..stride];
        pivot_row.copy_from_slice(&self.matrix[r * stride..][..stride]);
        self.delicate |= pivot_row[q].abs() < T::from(DELICATE);
        let inverse = pivot_row[q].recip();
        pivot_row[q] = T::ZERO;
        // The pivot row is treated as the others are, and overwritten afterwards.
        let weight = self.weights.get(r).map_or(T::ZERO, |weight| *weight * inverse * inverse);
        let elimination = Elimination { pivot_row, inverse, column: q, change, flips, weight };
        elimination.run(&mut self.matrix, &mut self.rows.value, &mut self.weights);
        let quotient = self.columns.cost[q] * inverse;
        add_multiple(-quotient, pivot_row, &mut self.columns.cost);
        self.columns.cost[q] = quotient;
        let row = &mut self.matrix[r * stride..][..stride];
        for (entry, p) in row.iter_mut().zip(&*pivot_row) {
            *entry = -inverse * *p;
        }
        row[q] = inverse;
        if let Some(own) = self.weights.get_mut(r) {
            *own = if weight > T::ONE { weight } else { T::ONE };
        }
        core::mem::swap(&mut self.rows.variable[r], &mut self.columns.variable[q]);
        core::mem::swap(&mut self.rows.lower[r], &mut self.columns.lower[q]);
        core::mem::swap(&mut self.rows.upper[r], &mut self.columns.upper[q]);
        if self.columns.lower[q] == self.columns.upper[q] {
            self.columns.side[q] = T::ZERO;
        }
        self.age += 1;
    }
}

/// The elimination of the pivot column from the rows, and the move of their basic variables.
struct Elimination<'a, T> {
    /// The pivot row, with 0 in the pivot column.
    pivot_row: &'a [T],
    /// Reciprocal of the pivot.
    inverse: T,
    column: usize,
    change: T,
    flips: &'a [Flip<T>],
    /// The weight of the pivot row over the square of the pivot.
    weight: T,
}

impl<T: Real> Elimination<'_, T> {
    /// Short rows are worth a loop of known length.
    fn run(&self, matrix: &mut [T], values: &mut [T], weights: &mut [T]) {
        match self.pivot_row.len() {
            4 => self.run_sized::<4>(matrix, values),
            8 => self.run_sized::<8>(matrix, values),
            12 => self.run_sized::<12>(matrix, values),
            16 => self.run_sized::<16>(matrix, values),
            stride => {
                for (row, weight) in matrix.chunks_exact(stride).zip(weights) {
                    let least = row[self.column] * row[self.column] * self.weight;
                    *weight = if least > *weight { least } else { *weight };
                }
                for (row, value) in matrix.chunks_exact_mut(stride).zip(values) {
                    self.update(row, self.pivot_row, value);
                }
            }
        }
    }

    fn run_sized<const S: usize>(&self, matrix: &mut [T], values: &mut [T]) {
        let mut pivot_row = [T::ZERO; S];
        pivot_row.copy_from_slice(self.pivot_row);
        for (row, value) in matrix.as_chunks_mut::<S>().0.iter_mut().zip(values) {
            self.update(row, &pivot_row, value);
        }
    }

    #[inline(always)]
    fn update(&self, row: &mut [T], pivot_row: &[T], value: &mut T) {
        for &(j, change) in self.flips {
            *value += row[j as usize] * change;
        }
        let entry = row[self.column];
        if entry != T::ZERO {
            *value += entry * self.change;
            let quotient = entry * self.inverse;
            add_multiple(-quotient, pivot_row, row);
            row[self.column] = quotient;
        }
    }
}
