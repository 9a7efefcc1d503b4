//! What can go wrong on a group.

use thiserror::Error;

/// Why an operation on a group has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum GroupError {
    /// The rotation angle can be a half turn, where the principal logarithm jumps from `pi` to `-pi`.
    #[error("the rotation angle [{theta_lo_rad}, {theta_hi_rad}] rad can reach a half turn: no single logarithm")]
    HalfTurn {
        /// Lower bound of the angle in radians.
        theta_lo_rad: f64,
        /// Upper bound of the angle in radians.
        theta_hi_rad: f64,
    },

    /// The rotation angle can be a full turn, where the exponential is not locally invertible and `Jl^-1` has a pole.
    #[error(
        "the rotation angle [{theta_lo_rad}, {theta_hi_rad}] rad reaches a full turn: the Jacobian has no inverse there"
    )]
    FullTurn {
        /// Lower bound of the angle in radians.
        theta_lo_rad: f64,
        /// Upper bound of the angle in radians.
        theta_hi_rad: f64,
    },

    /// An input coordinate is NaN, infinite, or (over intervals) unbounded or empty.
    #[error("coordinate {index} is not finite")]
    NotFinite {
        /// Which coordinate, in the order of the argument.
        index: usize,
    },

    /// The cosine and sine given are no rotation: both zero, or a box that misses the unit circle.
    #[error("cos and sin given lie off the unit circle")]
    NotARotation,

    /// A scale that is not positive: only those have a logarithm.
    #[error("scale [{scale_lo}, {scale_hi}] is not positive")]
    NotAScale {
        /// Lower bound of the scale.
        scale_lo: f64,
        /// Upper bound of the scale.
        scale_hi: f64,
    },

    /// No mean: no elements, weights that do not fit, or elements too far apart for the iteration to converge.
    #[error("no mean after {iterations} iterations, the last step was {step}")]
    NoMean {
        /// Iterations done.
        iterations: usize,
        /// Length of the last step.
        step: f64,
    },

    /// A matrix has the wrong shape.
    #[error("matrix is {found_rows} x {found_cols}, expected {expected} x {expected}")]
    Shape {
        /// Rows and columns of the group's matrices.
        expected: usize,
        /// Rows given.
        found_rows: usize,
        /// Columns given.
        found_cols: usize,
    },

    /// A matrix is not in the Lie algebra: `hat(vee(M))` differs from `M`.
    #[error("matrix is not in the Lie algebra: entry ({row}, {col}) breaks its pattern")]
    NotInAlgebra {
        /// Row of the first offending entry.
        row: usize,
        /// Column of the first offending entry.
        col: usize,
    },
}
