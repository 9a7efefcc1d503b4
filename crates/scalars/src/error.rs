//! What can go wrong when a scalar is built from outside data.

/// Errors of the crate: a value could not be built from the data given.
///
/// Arithmetic itself never fails: a function undefined on a whole box gives [`Interval::EMPTY`](crate::Interval::EMPTY).
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ScalarError {
    /// The bounds are not those of a nonempty closed interval of real numbers.
    #[error("[{lo}, {hi}] is not a nonempty interval of real numbers")]
    InvalidBounds {
        /// Lower bound as given.
        lo: f64,
        /// Upper bound as given.
        hi: f64,
    },
    /// The text is neither a number nor an interval literal.
    #[error("malformed interval literal at byte {position}")]
    MalformedLiteral {
        /// Offset in bytes of the part that could not be read.
        position: usize,
    },
}
