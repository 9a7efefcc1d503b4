//! The long-step ratio test: which nonbasic variables flip to their other bound, and which one enters.
//!
//! A basic variable violates a bound by `miss`. Along its row the dual objective is piecewise linear: its slope starts at
//! `miss`, and at the breakpoint `|d_j| / |t_j|` of a column that can repair the row it falls by `|t_j| (upper_j - lower_j)`.
//! The column at which it falls to zero enters; those before it flip. Source: Maros, *A generalized dual phase-2 simplex
//! algorithm*, 2003.

use crate::real::Real;
use crate::tableau::basis::Columns;
use crate::tableau::{Flip, Violation};

/// Scratch of the ratio test.
#[derive(Clone, Debug, Default)]
pub(crate) struct RatioTest<T> {
    candidates: Vec<Candidate<T>>,
    /// The columns that flip, in the order of their breakpoints.
    pub(crate) flips: Vec<Flip<T>>,
}

/// A column that can repair the row.
#[derive(Clone, Copy, Debug, Default)]
struct Candidate<T> {
    column: u32,
    /// `|t_j|`.
    entry: T,
    /// Breakpoint `|d_j| / |t_j|`.
    ratio: T,
}

/// Result of a ratio test.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entering<T> {
    /// The column that enters, unless no column can repair the row at all.
    pub(crate) column: Option<usize>,
    /// What is left of the violation when all columns have flipped: positive means that the row contradicts the others.
    pub(crate) rest: T,
    /// Whether there is a column and its entry is no rounding error beside the others of the row.
    pub(crate) stable: bool,
}

impl<T: Real> RatioTest<T> {
    pub(crate) fn resize(&mut self, variables: usize, stride: usize) {
        self.candidates.resize(stride, Candidate::default());
        self.flips.clear();
        self.flips.reserve(variables);
    }

    /// Runs the test on the tableau's row of the violated variable; leaves the flips in [`RatioTest::flips`].
    pub(crate) fn run(&mut self, row: &[T], columns: &Columns<T>, violation: Violation<T>) -> Entering<T> {
        self.flips.clear();
        let count = self.collect(row, columns, violation.sign);
        let candidates = &mut self.candidates[..count];
        // Selection sort up to the breakpoint where the slope vanishes: few columns flip as a rule.
        let mut rest = violation.amount;
        let mut passed = 0;
        while passed < count && rest > T::ZERO {
            rest = rest - pass(candidates, passed, columns);
            passed += 1;
        }
        // The last one enters.
        let Some(last) = passed.checked_sub(1) else {
            return Entering { column: None, rest, stable: false };
        };
        let mut entering = last;
        let mut stable = candidates[last].entry >= T::from(T::SURE_PIVOT);
        if !stable {
            // Its entry is too small to divide by: the last one before it that is not, or the first one after it.
            let largest = row.iter().fold(T::ONE, |m, t| if t.abs() > m { t.abs() } else { m });
            let small = T::from(T::SMALL_PIVOT) * largest;
            let sound = |c: &Candidate<T>| c.entry >= small;
            while passed < count && !candidates[..passed].iter().any(sound) {
                rest = rest - pass(candidates, passed, columns);
                passed += 1;
            }
            let before = &candidates[..passed];
            stable = before.iter().any(sound);
            let widest = |a: &usize, b: &usize| before[*a].entry.to_f64().total_cmp(&before[*b].entry.to_f64());
            let widest = (0..passed).max_by(widest).unwrap_or(last);
            entering = before.iter().rposition(sound).unwrap_or(widest);
        }
        for c in &candidates[..entering] {
            let j = c.column as usize;
            self.flips.push((c.column, columns.side[j] * (columns.lower[j] - columns.upper[j])));
        }
        Entering { column: Some(candidates[entering].column as usize), rest, stable }
    }

    /// Lists the columns that can repair the row; returns their number.
    fn collect(&mut self, row: &[T], columns: &Columns<T>, sign: T) -> usize {
        let zero = T::from(T::ZERO_PIVOT);
        let mut count = 0;
        for (j, (t, side)) in row.iter().zip(&columns.side).enumerate() {
            let entry = sign * *t * *side;
            let slot = &mut self.candidates[count];
            slot.column = j as u32;
            slot.entry = entry;
            // No branch: a column that does not help is overwritten by the next one.
            count += usize::from(entry > zero);
        }
        for c in &mut self.candidates[..count] {
            c.ratio = columns.cost[c.column as usize].abs().over(c.entry);
        }
        count
    }
}

/// Moves the candidate of the next breakpoint (of equal ones, that of the largest entry) to index `passed`; returns the
/// fall of the slope there.
fn pass<T: Real>(candidates: &mut [Candidate<T>], passed: usize, columns: &Columns<T>) -> T {
    let mut best = passed;
    let mut least = candidates[passed];
    for (k, c) in candidates.iter().enumerate().skip(passed + 1) {
        if c.ratio < least.ratio || (c.ratio == least.ratio && c.entry > least.entry) {
            best = k;
            least = *c;
        }
    }
    candidates.swap(passed, best);
    let j = least.column as usize;
    least.entry * (columns.upper[j] - columns.lower[j])
}
