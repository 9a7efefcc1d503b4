//! What can be wrong with the data of a problem.

use core::fmt;

/// Bad input: every variant says what is wrong and where.
///
/// A solve on accepted data has no error: at a pivot limit or in numerical doubt its bound is looser, never missing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LpError {
    /// A slice has the wrong length: a row or an objective needs one entry a variable, a range one a row.
    Length {
        /// Entries needed.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// A matrix entry is NaN or infinite.
    Entry {
        /// Row of the entry.
        row: usize,
        /// Column of the entry.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// The sum of the absolute entries of a row overflows.
    RowOverflow {
        /// The row.
        row: usize,
    },
    /// A range `[lower, upper]` has a NaN, `lower > upper`, or both ends at the same infinity.
    Range {
        /// Row of the range.
        row: usize,
        /// Its lower end.
        lower: f64,
        /// Its upper end.
        upper: f64,
    },
    /// A coefficient of the objective is NaN or infinite.
    Objective {
        /// Index of the coefficient.
        column: usize,
        /// The coefficient.
        value: f64,
    },
    /// The sum of the absolute coefficients of the objective overflows.
    ObjectiveOverflow,
    /// A row index is out of range.
    RowIndex {
        /// The index.
        row: usize,
        /// Number of rows.
        rows: usize,
    },
    /// More variables or rows than the error bounds are derived for (2^24).
    TooLarge {
        /// The number asked for.
        size: usize,
    },
}

impl fmt::Display for LpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Length { expected, found } => {
                write!(f, "expected {expected} entries, found {found}")
            }
            Self::Entry { row, column, value } => {
                write!(
                    f,
                    "entry ({row}, {column}) of the matrix is {value}, not a finite number"
                )
            }
            Self::RowOverflow { row } => {
                write!(f, "the sum of the absolute entries of row {row} overflows")
            }
            Self::Range { row, lower, upper } => {
                write!(f, "row {row} has no range: [{lower}, {upper}]")
            }
            Self::Objective { column, value } => {
                write!(
                    f,
                    "coefficient {column} of the objective is {value}, not a finite number"
                )
            }
            Self::ObjectiveOverflow => write!(
                f,
                "the sum of the absolute coefficients of the objective overflows"
            ),
            Self::RowIndex { row, rows } => {
                write!(f, "row {row} does not exist: the problem has {rows} rows")
            }
            Self::TooLarge { size } => write!(
                f,
                "{size} variables or rows are too many: the limit is 2^24"
            ),
        }
    }
}

impl core::error::Error for LpError {}
