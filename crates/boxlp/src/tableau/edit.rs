//! Rows appended and dropped while the basis lives on.

use super::rebuild::Mark;
use super::{Tableau, add_multiple, scaled_range};
use crate::problem::Problem;
use crate::real::Real;

impl<T: Real> Tableau<T> {
    /// Appends the last row of `problem`: its logical becomes basic.
    pub(crate) fn append_row(&mut self, problem: &Problem) {
        let (n, stride) = (self.variables, self.stride);
        let i = problem.rows() - 1;
        let range = &problem.ranges()[i];
        let source = problem.row(i);
        let start = self.matrix.len();
        self.matrix.resize(start + stride, T::ZERO);
        let (known, new) = self.matrix.split_at_mut(start);
        for j in 0..n {
            let v = self.columns.variable[j] as usize;
            new[j] = if v < n { T::from(source[v] * range.scale) } else { T::ZERO };
        }
        for (r, row) in known.chunks_exact(stride).enumerate() {
            let v = self.rows.variable[r] as usize;
            if v < n {
                add_multiple(T::from(source[v] * range.scale), row, new);
            }
        }
        let (lower, upper) = scaled_range(range, self.margin);
        self.rows.push((n + i) as u32, lower, upper);
        self.marks.push(Mark::Settled);
    }

    /// Forgets the logicals for whose row `keep` says `false`; the others are renumbered in order.
    ///
    /// Returns `false`, with the tableau in need of a build, if a nonbasic logical cannot be exchanged into the basis.
    pub(crate) fn retain_rows(&mut self, keep: &[bool]) -> bool {
        let n = self.variables;
        for j in 0..n {
            let v = self.columns.variable[j] as usize;
            if v >= n && !keep[v - n] {
                let mut best = (T::from(T::REBUILD_PIVOT), usize::MAX);
                for r in 0..self.rows.variable.len() {
                    let a = self.row(r)[j].abs();
                    let b = self.rows.variable[r] as usize;
                    if a > best.0 && (b < n || keep[b - n]) {
                        best = (a, r);
                    }
                }
                if best.1 == usize::MAX {
                    return false;
                }
                self.exchange(best.1, j, T::ZERO, &[]);
            }
        }
        self.weights.clear();
        self.numbers.clear();
        let mut next = n as u32;
        for &kept in keep {
            self.numbers.push(next);
            next += u32::from(kept);
        }
        let mut kept = 0;
        for r in 0..self.rows.variable.len() {
            let v = self.rows.variable[r] as usize;
            if v < n || keep[v - n] {
                self.matrix.copy_within(r * self.stride..(r + 1) * self.stride, kept * self.stride);
                self.rows.move_to(r, kept);
                kept += 1;
            }
        }
        self.rows.truncate(kept);
        self.matrix.truncate(kept * self.stride);
        for v in self.rows.variable.iter_mut().chain(&mut self.columns.variable) {
            if *v as usize >= n {
                *v = self.numbers[*v as usize - n];
            }
        }
        true
    }
}
