//! What can be wrong with the input of a set operation, and where.

use core::fmt;

/// The argument or component that an error speaks of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Part {
    /// The center `c` of a set.
    Center,
    /// The generator matrix `G`.
    Generators,
    /// The box remainder `r`.
    Remainder,
    /// The radii of a box or of an interval matrix.
    Radius,
    /// A matrix that maps a set, or the midpoint of an interval matrix.
    Map,
    /// A direction of a support function.
    Direction,
    /// A translation vector.
    Translation,
    /// A scale factor.
    Factor,
    /// An interval vector or interval matrix.
    Interval,
    /// A matrix built from rows or columns.
    Matrix,
    /// A point whose membership is asked.
    Point,
    /// A slice that receives a result.
    Output,
    /// The vertex matrix `V` of a polytope.
    Vertices,
    /// The normals `H` of the half-spaces of a polytope.
    Normals,
    /// The offsets `h` of the half-spaces of a polytope.
    Offsets,
    /// The constraint matrix `A`, or rows that cut a set.
    Constraints,
    /// The ranges `[b]` of constraints.
    Range,
    /// The members of a bundle.
    Members,
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Center => "center",
            Self::Generators => "generator matrix",
            Self::Remainder => "box remainder",
            Self::Radius => "radius",
            Self::Map => "map",
            Self::Direction => "direction",
            Self::Translation => "translation",
            Self::Factor => "factor",
            Self::Interval => "interval",
            Self::Matrix => "matrix",
            Self::Point => "point",
            Self::Output => "output",
            Self::Vertices => "vertex matrix",
            Self::Normals => "half-space normals",
            Self::Offsets => "half-space offsets",
            Self::Constraints => "constraint matrix",
            Self::Range => "range",
            Self::Members => "members of the bundle",
        })
    }
}

/// Why an operation on sets was refused. The operands are unchanged.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SetError {
    /// Two sizes that must agree do not.
    #[error("{part}: size {found} where {expected} is needed")]
    Dimension {
        /// The argument with the wrong size.
        part: Part,
        /// The size that was needed.
        expected: usize,
        /// The size that was given.
        found: usize,
    },
    /// A set in zero dimensions, or a matrix without rows.
    #[error("{part}: needs at least one dimension")]
    ZeroDimension {
        /// The argument without dimensions.
        part: Part,
    },
    /// An entry is NaN or infinite.
    #[error("{part}: entry ({row}, {col}) is {value}, not a finite number")]
    NonFinite {
        /// The argument that holds the entry.
        part: Part,
        /// Row of the entry.
        row: usize,
        /// Column of the entry (0 for vectors).
        col: usize,
        /// The entry.
        value: f64,
    },
    /// An entry that is a length is negative.
    #[error("{part}: entry ({row}, {col}) is {value}, below zero")]
    Negative {
        /// The argument that holds the entry.
        part: Part,
        /// Row of the entry.
        row: usize,
        /// Column of the entry (0 for vectors).
        col: usize,
        /// The entry.
        value: f64,
    },
    /// An interval is empty or unbounded where a bounded one is needed.
    #[error("{part}: interval ({row}, {col}) is empty or unbounded")]
    UnboundedInterval {
        /// The argument that holds the interval.
        part: Part,
        /// Row of the interval.
        row: usize,
        /// Column of the interval (0 for vectors).
        col: usize,
    },
    /// An interval is empty where one with points is needed.
    #[error("{part}: interval {row} is empty")]
    EmptyInterval {
        /// The argument that holds the interval.
        part: Part,
        /// Index of the interval.
        row: usize,
    },
    /// A set with more generators or constraints than its linear programs are made for (2^24).
    #[error("{size} generators or constraints are too many")]
    TooLarge {
        /// The number of them.
        size: usize,
    },
    /// The result has no finite bound in `f64`.
    #[error("result overflows in row {row}")]
    Overflow {
        /// Row whose bound is not finite.
        row: usize,
    },
    /// A reduction was asked for fewer generators than a box of the space has.
    #[error("cannot reduce to {max_generators} generators in dimension {dim}: at least {dim} are needed")]
    TooFewGenerators {
        /// The requested number of generators.
        max_generators: usize,
        /// The dimension of the set.
        dim: usize,
    },
    /// An exact enumeration would visit more subsets of generators than its stated limit.
    #[error("{subsets} generator subsets exceed the limit of {limit}")]
    TooManySubsets {
        /// Number of subsets (saturating).
        subsets: u64,
        /// The limit.
        limit: u64,
    },
    /// An exact enumeration was asked of a set in more dimensions than its tables cover.
    #[error("{dim} dimensions exceed the limit of {limit} of an exact enumeration")]
    TooManyDimensions {
        /// Dimension of the set.
        dim: usize,
        /// The limit.
        limit: usize,
    },
    /// An operation of the plane was asked of a set elsewhere.
    #[error("a planar operation on a set of dimension {dim}")]
    NotPlanar {
        /// The dimension of the set.
        dim: usize,
    },
    /// A coordinate that the space does not have.
    #[error("no coordinate {index} in dimension {dim}")]
    NoSuchCoordinate {
        /// The index asked for.
        index: usize,
        /// The dimension of the space.
        dim: usize,
    },
    /// The set is proven to be empty where a nonempty one is needed.
    #[error("the set is empty")]
    EmptySet,
    /// The set is unbounded where a bounded one is needed, proven unless the operation says otherwise.
    #[error("the set is unbounded")]
    Unbounded,
    /// A conversion met more faces of a polytope than its limit.
    #[error("{count} faces exceed the limit of {limit}")]
    OverBudget {
        /// Number of faces when the conversion stopped.
        count: usize,
        /// The limit.
        limit: usize,
    },
}

impl SetError {
    /// `Ok` if `found == expected`.
    pub(crate) fn check_size(part: Part, expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self::Dimension { part, expected, found }) }
    }

    /// `Ok` if every entry of a column-major array with `rows` rows is finite.
    pub(crate) fn check_finite(part: Part, rows: usize, data: &[f64]) -> Result<(), Self> {
        match data.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(k) => Err(Self::NonFinite { part, row: k % rows.max(1), col: k / rows.max(1), value: data[k] }),
        }
    }

    /// `Ok` if every entry of a column-major array is finite and not below zero.
    pub(crate) fn check_lengths(part: Part, rows: usize, data: &[f64]) -> Result<(), Self> {
        Self::check_finite(part, rows, data)?;
        match data.iter().position(|&x| x < 0.0) {
            None => Ok(()),
            Some(k) => Err(Self::Negative { part, row: k % rows.max(1), col: k / rows.max(1), value: data[k] }),
        }
    }
}
