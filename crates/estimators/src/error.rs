//! What can go wrong in a filter, with the numbers that say where.

use lie_groups::GroupError;
use nonlin_bounds::BoundError;
use scalars::Interval;
use setrep::SetError;
use thiserror::Error;

use crate::Inconsistency;

/// Error of a filter or a gain. A filter that returns one is left as it was before the call.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum EstimatorError {
    /// A number is NaN or infinite.
    #[error("{what}: entry {index} is {value}, not a finite number")]
    NotFinite {
        /// The argument or the result the entry belongs to.
        what: &'static str,
        /// Position of the entry, column by column for a matrix.
        index: usize,
        /// The entry.
        value: f64,
    },
    /// A vector, a matrix or a set has the wrong size.
    #[error("{what}: size {found}, expected {expected}")]
    Size {
        /// The argument of the wrong size.
        what: &'static str,
        /// The size it must have.
        expected: usize,
        /// The size it has.
        found: usize,
    },
    /// A range that no value can have.
    #[error("{what}: range {index} is empty")]
    EmptyRange {
        /// The argument.
        what: &'static str,
        /// Position of the range.
        index: usize,
    },
    /// A measurement of a step that is no longer remembered, or not yet reached.
    #[error("step {step} is not between {oldest}, the oldest that is remembered, and {newest}")]
    OutOfReach {
        /// The step of the measurement.
        step: u64,
        /// The oldest step that a measurement can come for.
        oldest: u64,
        /// The step under way.
        newest: u64,
    },
    /// Measurements, invariants and bounds contradict each other, with proof. The filter keeps its predicted set.
    #[error("{0}")]
    Inconsistent(Box<Inconsistency>),
    /// A noise set or an initial error set has a center other than 0: move it into the input, the output or the estimate.
    #[error("{what}: center entry {index} is {value}, not 0")]
    NotCentered {
        /// The set.
        what: &'static str,
        /// Position of the entry.
        index: usize,
        /// The entry.
        value: f64,
    },
    /// `S = C P C' + Q_v` has no inverse: some combination of outputs has neither noise nor spread.
    #[error("S = C P C' + Q_v of {outputs} outputs is singular: pivot ratio {pivot_ratio:e}, need at least {limit:e}")]
    SingularInnovation {
        /// Number of outputs, the size of `S`.
        outputs: usize,
        /// Smallest squared Cholesky pivot over the diagonal entry it came from; 0 if the factorisation broke down.
        pivot_ratio: f64,
        /// Smallest ratio accepted.
        limit: f64,
    },
    /// The pair `(A, C)` is not observable, so no gain moves all eigenvalues of `A - L C`.
    #[error("the pair (A, C) is not observable: rank {rank} of {states}")]
    NotObservable {
        /// Numerical rank of the observability matrix.
        rank: usize,
        /// Number of states.
        states: usize,
    },
    /// A list of poles has the wrong length.
    #[error("{found} poles for {expected} states")]
    PoleCount {
        /// Number of states.
        expected: usize,
        /// Number of poles.
        found: usize,
    },
    /// A complex pole comes without its conjugate.
    #[error("pole {re} + {im} i has no conjugate in the list")]
    PoleNotConjugate {
        /// Real part.
        re: f64,
        /// Imaginary part.
        im: f64,
    },
    /// A pole is repeated more often than independent outputs can place it without a Jordan block.
    #[error("pole {re} + {im} i is repeated {multiplicity} times, at most rank C = {rank} times can be placed")]
    PoleMultiplicity {
        /// Real part.
        re: f64,
        /// Imaginary part.
        im: f64,
        /// Number of times it is in the list.
        multiplicity: usize,
        /// Rank of `C`.
        rank: usize,
    },
    /// The poles cannot be placed to useful accuracy: the eigenvectors available are nearly dependent.
    #[error("poles placed to within {error:e} only, tolerance {tolerance:e}")]
    PlacementInaccurate {
        /// Bound on the distance of an eigenvalue of `A - L C` to the nearest pole.
        error: f64,
        /// Largest error accepted.
        tolerance: f64,
    },
    /// A covariance is not positive semidefinite, or has lost that by a negative weight.
    #[error("{what} is not positive semidefinite: pivot {index} is {value:e}")]
    NotPositive {
        /// The covariance.
        what: &'static str,
        /// Position of the pivot; outputs come before states where both are meant.
        index: usize,
        /// The squared pivot that was left.
        value: f64,
    },
    /// A covariance is not symmetric.
    #[error("{what}: entries ({row}, {col}) and ({col}, {row}) differ")]
    NotSymmetric {
        /// The covariance.
        what: &'static str,
        /// Row of the entry.
        row: usize,
        /// Its column.
        col: usize,
    },
    /// Weights that give no sigma points in this dimension.
    #[error("these weights put the sigma points at a squared distance of {squared_spread}, need a finite positive one")]
    NoSigmaPoints {
        /// Squared distance of the points from the mean, in standard deviations.
        squared_spread: f64,
    },
    /// A measurement that is linear in the embedding of a planar group only where the scale is known to be 1.
    #[error("needs the scale 1, which is only known to lie in {scale}")]
    ScaleUnknown {
        /// What is known of the scale.
        scale: Interval,
    },
    /// A matrix factorisation or an iteration did not converge.
    #[error("{what} did not converge")]
    NoConvergence {
        /// What did not.
        what: &'static str,
    },
    /// Placed poles are those of `A - L C` over a whole step; an update alone does not know `A`.
    #[error("pole placement needs the input of the step: use step, not update alone")]
    GainNeedsInput,
    /// A function could not be enclosed.
    #[error(transparent)]
    Bound(#[from] BoundError),
    /// A set operation refused its input.
    #[error(transparent)]
    Set(#[from] SetError),
    /// A group operation failed.
    #[error(transparent)]
    Group(#[from] GroupError),
}

/// `Ok` if all entries are finite.
pub(crate) fn check_finite(what: &'static str, entries: &[f64]) -> Result<(), EstimatorError> {
    match entries.iter().position(|v| !v.is_finite()) {
        None => Ok(()),
        Some(index) => Err(EstimatorError::NotFinite { what, index, value: entries[index] }),
    }
}

/// `Ok` if the sizes agree.
pub(crate) fn check_size(what: &'static str, expected: usize, found: usize) -> Result<(), EstimatorError> {
    if expected == found { Ok(()) } else { Err(EstimatorError::Size { what, expected, found }) }
}
