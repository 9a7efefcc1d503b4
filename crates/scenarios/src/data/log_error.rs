//! What can be wrong in a log.

/// A log that is not what its format says; lines and columns count from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LogError {
    /// A line has too few or too many cells.
    #[error("line {line}: {found} columns, expected {expected}")]
    Columns {
        /// Line in the file.
        line: usize,
        /// Cells found.
        found: usize,
        /// Cells of the format.
        expected: usize,
    },
    /// The header names other columns than the format.
    #[error("line {line}, column {column}: header is \"{found}\", expected \"{expected}\"")]
    Header {
        /// Line in the file.
        line: usize,
        /// Column.
        column: usize,
        /// Name found.
        found: String,
        /// Name of the format.
        expected: &'static str,
    },
    /// A cell is not a finite number.
    #[error("line {line}, column {column} ({name}): \"{found}\" is not a finite number")]
    Number {
        /// Line in the file.
        line: usize,
        /// Column.
        column: usize,
        /// Name of the column.
        name: &'static str,
        /// The cell.
        found: String,
    },
    /// A number is outside what the quantity can be, so the columns are likely not those of the format.
    #[error("line {line}, column {column} ({name}): {value} is outside {low}..{high}")]
    Implausible {
        /// Line in the file.
        line: usize,
        /// Column.
        column: usize,
        /// Name of the column.
        name: &'static str,
        /// The number.
        value: f64,
        /// Least plausible value.
        low: f64,
        /// Greatest plausible value.
        high: f64,
    },
    /// Time does not increase.
    #[error("line {line}: time {time_s} s does not follow {previous_s} s")]
    Time {
        /// Line in the file.
        line: usize,
        /// Time on that line.
        time_s: f64,
        /// Time on the line before.
        previous_s: f64,
    },
    /// There are fewer lines of data than can be used.
    #[error("{found} samples, at least {needed} are needed")]
    TooShort {
        /// Samples found.
        found: usize,
        /// Samples needed.
        needed: usize,
    },
}
