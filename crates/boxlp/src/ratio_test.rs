//! The long-step ratio test: which nonbasic variables flip to their other bound, and which one enters.
//!
//! A basic variable violates a bound by `miss`. Along its row the dual objective is piecewise linear: its slope starts at
//! `miss`, and at the breakpoint `|d_j| / |t_j|` of a column that can repair the row it falls by `|t_j| (upper_j - lower_j)`.
//! The column at which it falls to zero enters; those before it flip. Source: Maros, *A generalized dual phase-2 simplex
//! algorithm*, 2003.

use crate::tableau::{Columns, Flip, Violation};

/// A column enters with an entry below this share of the row's largest only if there is no other.
const SMALL_PIVOT: f64 = 1e-7;

/// Entries below this are rounding errors: their column neither flips nor enters.
const ZERO_PIVOT: f64 = 1e-13;

/// Scratch of the ratio test.
#[derive(Clone, Debug, Default)]
pub(crate) struct RatioTest {
    candidates: Vec<Candidate>,
    /// The columns that flip, in the order of their breakpoints.
    pub(crate) flips: Vec<Flip>,
}

/// A column that can repair the row.
#[derive(Clone, Copy, Debug, Default)]
struct Candidate {
    column: u32,
    /// `|t_j|`.
    entry: f64,
    /// Breakpoint `|d_j| / |t_j|`.
    ratio: f64,
}

/// Result of a ratio test.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entering {
    /// The column that enters, unless no column can repair the row at all.
    pub(crate) column: Option<usize>,
    /// What is left of the violation when all columns have flipped: positive means that the row contradicts the others.
    pub(crate) rest: f64,
    /// Whether there is a column and its entry is no rounding error beside the others of the row.
    pub(crate) stable: bool,
}

impl RatioTest {
    pub(crate) fn resize(&mut self, variables: usize, stride: usize) {
        self.candidates.resize(stride, Candidate::default());
        self.flips.clear();
        self.flips.reserve(variables);
    }

    /// Runs the test on the tableau's row of the violated variable; leaves the flips in [`RatioTest::flips`].
    pub(crate) fn run(&mut self, row: &[f64], columns: &Columns, violation: Violation) -> Entering {
        let mut count = 0;
        // The basic variable itself has the entry 1.
        let mut largest = 1.0;
        for (j, (&t, &side)) in row.iter().zip(&columns.side).enumerate() {
            let entry = violation.sign * t * side;
            self.candidates[count] = Candidate {
                column: j as u32,
                entry,
                ratio: 0.0,
            };
            count += usize::from(entry > ZERO_PIVOT);
            let modulus = t.abs();
            largest = if modulus > largest { modulus } else { largest };
        }
        let candidates = &mut self.candidates[..count];
        for c in candidates.iter_mut() {
            c.ratio = columns.cost[c.column as usize].abs() / c.entry;
        }
        // Selection sort up to the breakpoint where the slope vanishes: few columns flip as a rule.
        let mut rest = violation.amount;
        let mut passed = 0;
        while passed < count && (rest > 0.0 || candidates[passed - 1].entry < SMALL_PIVOT * largest)
        {
            let mut best = passed;
            for k in passed + 1..count {
                let (c, b) = (&candidates[k], &candidates[best]);
                if c.ratio < b.ratio || (c.ratio == b.ratio && c.entry > b.entry) {
                    best = k;
                }
            }
            candidates.swap(passed, best);
            let c = &candidates[passed];
            let j = c.column as usize;
            rest -= c.entry * (columns.upper[j] - columns.lower[j]);
            passed += 1;
        }
        let passed = &candidates[..passed];
        // The last one enters; if its entry is too small to divide by, the last one before it that is not.
        let sound = passed
            .iter()
            .rposition(|c| c.entry >= SMALL_PIVOT * largest);
        let widest =
            || (0..passed.len()).max_by(|&a, &b| passed[a].entry.total_cmp(&passed[b].entry));
        let entering = sound.or_else(widest);
        self.flips.clear();
        for c in &passed[..entering.unwrap_or(0)] {
            let j = c.column as usize;
            self.flips.push((
                c.column,
                columns.side[j] * (columns.lower[j] - columns.upper[j]),
            ));
        }
        Entering {
            column: entering.map(|k| passed[k].column as usize),
            rest,
            stable: sound.is_some(),
        }
    }
}
