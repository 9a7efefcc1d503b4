//! Exchanges: one basic variable leaves, one nonbasic variable enters.

use super::{Flip, Tableau, Violation, add_multiple};

impl Tableau {
    /// One dual simplex step: `flips`, then the violated variable goes to its bound and the variable of column `q` enters.
    pub(crate) fn step(&mut self, violation: Violation, q: usize, flips: &[Flip]) {
        let r = violation.row;
        let mut value = self.rows.value[r];
        for &(j, change) in flips {
            value += self.matrix[r * self.stride + j as usize] * change;
            self.columns.flip(j as usize);
        }
        let target = if violation.sign > 0.0 {
            self.rows.upper[r]
        } else {
            self.rows.lower[r]
        };
        let change = (target - value) / self.matrix[r * self.stride + q];
        let entering = self.columns.value[q] + change;
        self.columns.value[q] = target;
        self.columns.side[q] = violation.sign;
        self.exchange(r, q, change, flips);
        self.rows.value[r] = entering;
    }

    /// Exchanges the basic variable of row `r` with the nonbasic one of column `q`, whose value changes by `change`.
    pub(super) fn exchange(&mut self, r: usize, q: usize, change: f64, flips: &[Flip]) {
        let stride = self.stride;
        let pivot_row = &mut self.pivot_row[..stride];
        pivot_row.copy_from_slice(&self.matrix[r * stride..][..stride]);
        let inverse = 1.0 / pivot_row[q];
        pivot_row[q] = 0.0;
        // The pivot row is treated as the others are, and overwritten afterwards.
        let elimination = Elimination {
            pivot_row,
            inverse,
            column: q,
            change,
            flips,
        };
        elimination.run(&mut self.matrix, &mut self.rows.value);
        let quotient = self.columns.cost[q] * inverse;
        add_multiple(-quotient, pivot_row, &mut self.columns.cost);
        self.columns.cost[q] = quotient;
        let row = &mut self.matrix[r * stride..][..stride];
        for (entry, p) in row.iter_mut().zip(&*pivot_row) {
            *entry = -inverse * p;
        }
        row[q] = inverse;
        core::mem::swap(&mut self.rows.variable[r], &mut self.columns.variable[q]);
        core::mem::swap(&mut self.rows.lower[r], &mut self.columns.lower[q]);
        core::mem::swap(&mut self.rows.upper[r], &mut self.columns.upper[q]);
        if self.columns.lower[q] == self.columns.upper[q] {
            self.columns.side[q] = 0.0;
        }
        self.age += 1;
    }
}

/// The elimination of the pivot column from the rows, and the move of their basic variables.
struct Elimination<'a> {
    /// The pivot row, with 0 in the pivot column.
    pivot_row: &'a [f64],
    /// Reciprocal of the pivot.
    inverse: f64,
    column: usize,
    change: f64,
    flips: &'a [Flip],
}

impl Elimination<'_> {
    /// Short rows are worth a loop of known length.
    fn run(&self, matrix: &mut [f64], values: &mut [f64]) {
        match self.pivot_row.len() {
            4 => self.run_sized::<4>(matrix, values),
            8 => self.run_sized::<8>(matrix, values),
            12 => self.run_sized::<12>(matrix, values),
            16 => self.run_sized::<16>(matrix, values),
            stride => {
                for (row, value) in matrix.chunks_exact_mut(stride).zip(values) {
                    self.update(row, self.pivot_row, value);
                }
            }
        }
    }

    fn run_sized<const S: usize>(&self, matrix: &mut [f64], values: &mut [f64]) {
        let mut pivot_row = [0.0; S];
        pivot_row.copy_from_slice(self.pivot_row);
        for (row, value) in matrix.as_chunks_mut::<S>().0.iter_mut().zip(values) {
            self.update(row, &pivot_row, value);
        }
    }

    #[inline(always)]
    fn update(&self, row: &mut [f64], pivot_row: &[f64], value: &mut f64) {
        for &(j, change) in self.flips {
            *value += row[j as usize] * change;
        }
        let entry = row[self.column];
        if entry != 0.0 {
            *value += entry * self.change;
            let quotient = entry * self.inverse;
            add_multiple(-quotient, pivot_row, row);
            row[self.column] = quotient;
        }
    }
}
