//! The constrained zonotope with ranged constraints and a box remainder; one operation family a file.

mod affine;
mod cartesian_product;
mod conversions;
mod convex_hull;
mod eliminate;
mod emptiness;
mod forms;
mod inclusion;
mod intersection;
mod maps;
mod membership;
mod minkowski_sum;
mod optimizer;
mod projection;
mod reduce;
mod redundancy;
mod reencode;
mod rescale;
mod rows;
mod score;

pub use emptiness::{Contradiction, Emptiness};
pub use inclusion::Containment;
pub use optimizer::Optimizer;
pub(crate) use optimizer::{prepared, refused};
pub(crate) use projection::selection;
pub use reduce::Complexity;
pub(crate) use reencode::Scratch as ReencodingScratch;
pub use reencode::{Directions, Reencoding, TemplateWidths};
use scalars::Interval;
pub(crate) use score::Choice;

use crate::{Matrix, Part, SetError, Zonotope};

/// A constrained zonotope `<c, G, r; A, [b]> = { c + G xi + e : |xi_j| <= 1, A xi in [b], |e_i| <= r_i }`, shapes `c: n`,
/// `G: n x ng`, `r: n`, `A: nc x ng`, `[b]: nc` intervals.
///
/// The textbook form has `r = 0` and points `b`. Ranges cost no slack generators: one row is a pair of half-spaces, and
/// measurement noise, remainders and the rounding of a row all widen `[b]`. As in a [`Zonotope`] the box remainder is a buffer for
/// rounding and axis-aligned noise; maps and intersections turn a remainder of model size into generators first.
///
/// Every operation is closed in this form and encloses the exact result. The set may be empty: operations on an empty set are
/// valid, and emptiness is only ever claimed with a proof.
///
/// Invariants: `n >= 1`, every entry finite, `r >= 0`, ranges bounded and not empty, every row sum of `|A|` finite. An operation that
/// would break them is an error and leaves its operands as they were.
///
/// ```
/// use scalars::Interval;
/// use setrep::{ConstrainedZonotope, Matrix};
///
/// // The part of the square [-1, 1]^2 with x_1 + x_2 in [-1/2, 1/2].
/// let rows = Matrix::from_rows(&[&[1.0, 1.0]])?;
/// let band = ConstrainedZonotope::new(&[0.0, 0.0], &Matrix::identity(2), &rows, &[Interval::point(0.0).inflate(0.5)])?;
/// assert_eq!((band.dim(), band.num_generators(), band.num_constraints()), (2, 2, 1));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct ConstrainedZonotope {
    /// `<c, G, r>`: the set without its constraints.
    pub(crate) body: Zonotope,
    pub(crate) constraints: Matrix,
    pub(crate) ranges: Vec<Interval>,
}

impl ConstrainedZonotope {
    /// The constrained zonotope `<c, G, 0; A, [b]>`.
    ///
    /// A range may be unbounded. Its ends are clipped to the values that the row takes, `|A_i xi| <= |A_i|_1`, which changes nothing.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// No dimension, sizes that differ, entries that are not finite, an empty range, a row whose sum overflows.
    pub fn new(
        center: &[f64],
        generators: &Matrix,
        constraints: &Matrix,
        ranges: &[Interval],
    ) -> Result<Self, SetError> {
        Self::with_constraints(&Zonotope::new(center, generators)?, constraints, ranges)
    }

    /// The textbook constrained zonotope `{ c + G xi : |xi| <= 1, A xi = b }` (CG-rep).
    ///
    /// **Guarantee:** exact. The way back is [`textbook_form`](Self::textbook_form).
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Definition 3.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Matrix};
    /// let generators = Matrix::from_rows(&[&[1.5, -1.5, 0.5], &[1.0, 0.5, -1.0]])?;
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0, 1.0]])?;
    /// let set = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &generators, &rows, &[1.0])?;
    /// assert_eq!(set.ranges()[0].width(), 0.0);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn from_cg_rep(
        center: &[f64],
        generators: &Matrix,
        constraints: &Matrix,
        right_hand_side: &[f64],
    ) -> Result<Self, SetError> {
        SetError::check_finite(Part::Range, right_hand_side.len(), right_hand_side)?;
        let ranges: Vec<Interval> = right_hand_side.iter().map(|&b| Interval::point(b)).collect();
        Self::new(center, generators, constraints, &ranges)
    }

    /// The points `c + G xi + e` of a zonotope with `A xi in [b]`.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_constraints(body: &Zonotope, constraints: &Matrix, ranges: &[Interval]) -> Result<Self, SetError> {
        let mut set = Self::from(body.clone());
        set.constrain(constraints, ranges)?;
        Ok(set)
    }

    /// Overwrites the set by `<c, G, 0; A, [b]>`, as [`new`](Self::new) makes it; allocates nothing within capacity.
    ///
    /// # Errors
    /// As [`new`](Self::new); the set is then unchanged.
    pub fn assign(
        &mut self,
        center: &[f64],
        generators: &Matrix,
        constraints: &Matrix,
        ranges: &[Interval],
    ) -> Result<(), SetError> {
        let n = center.len();
        if n == 0 {
            return Err(SetError::ZeroDimension { part: Part::Center });
        }
        SetError::check_size(Part::Generators, n, generators.rows())?;
        SetError::check_finite(Part::Center, n, center)?;
        SetError::check_finite(Part::Generators, n, generators.as_slice())?;
        Self::check_constraints(generators.cols(), constraints, ranges)?;
        self.body.center.clear();
        self.body.center.extend_from_slice(center);
        self.body.generators.clone_from(generators);
        self.body.remainder.clear();
        self.body.remainder.resize(n, 0.0);
        self.constraints.reset(0, generators.cols());
        self.ranges.clear();
        self.constrain(constraints, ranges)
    }

    /// Overwrites the set by a zonotope; allocates nothing within capacity.
    ///
    /// **Guarantee:** exact.
    pub fn assign_zonotope(&mut self, body: &Zonotope) {
        self.body.clone_from(body);
        self.constraints.reset(0, body.num_generators());
        self.ranges.clear();
    }

    /// `Ok` if these are constraints of a set with so many generators.
    fn check_constraints(columns: usize, constraints: &Matrix, ranges: &[Interval]) -> Result<(), SetError> {
        // A matrix without rows need not say how many columns it has not.
        if constraints.rows() > 0 {
            SetError::check_size(Part::Constraints, columns, constraints.cols())?;
        }
        SetError::check_size(Part::Range, constraints.rows(), ranges.len())?;
        SetError::check_finite(Part::Constraints, constraints.rows(), constraints.as_slice())?;
        for (row, range) in ranges.iter().enumerate() {
            rows::check_not_empty(row, range)?;
            let sum = constraints.columns().map(|column| column[row].abs()).sum();
            rows::finite_norm(row, sum, constraints.cols())?;
        }
        Ok(())
    }

    /// Gives a set without constraints these ones.
    fn constrain(&mut self, constraints: &Matrix, ranges: &[Interval]) -> Result<(), SetError> {
        Self::check_constraints(self.num_generators(), constraints, ranges)?;
        self.constraints.push_zero_rows(constraints.rows());
        self.constraints.as_mut_slice().copy_from_slice(constraints.as_slice());
        for (row, range) in ranges.iter().enumerate() {
            self.ranges.push(rows::clip(*range, self.row_norm(row)?));
        }
        Ok(())
    }

    /// The box `center +- radii`, kept in the remainder: no generators, no constraints.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// As [`Zonotope::from_box`].
    pub fn from_box(center: &[f64], radii: &[f64]) -> Result<Self, SetError> {
        Zonotope::from_box(center, radii).map(Self::from)
    }

    /// The box of an interval vector, kept in the remainder: no generators, no constraints.
    ///
    /// **Guarantee:** superset of the box; only the rounding of midpoints and radii is added.
    ///
    /// # Errors
    /// As [`Zonotope::from_intervals`].
    pub fn from_intervals(sides: &[Interval]) -> Result<Self, SetError> {
        Zonotope::from_intervals(sides).map(Self::from)
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.body.dim()
    }

    /// Number `ng` of generators (columns of `G` and `A`); the box remainder is not counted.
    #[must_use]
    pub fn num_generators(&self) -> usize {
        self.body.num_generators()
    }

    /// Number `nc` of constraints (rows of `A`).
    #[must_use]
    pub fn num_constraints(&self) -> usize {
        self.ranges.len()
    }

    /// The center `c`.
    #[must_use]
    pub fn center(&self) -> &[f64] {
        self.body.center()
    }

    /// The generator matrix `G`.
    #[must_use]
    pub fn generators(&self) -> &Matrix {
        self.body.generators()
    }

    /// The box remainder `r`.
    #[must_use]
    pub fn remainder(&self) -> &[f64] {
        self.body.remainder()
    }

    /// The constraint matrix `A`.
    #[must_use]
    pub fn constraints(&self) -> &Matrix {
        &self.constraints
    }

    /// The ranges `[b]`.
    #[must_use]
    pub fn ranges(&self) -> &[Interval] {
        &self.ranges
    }

    /// `<c, G, r>`, the set without its constraints: a superset.
    #[must_use]
    pub fn unconstrained(&self) -> &Zonotope {
        &self.body
    }
}

/// A zonotope is a constrained zonotope without constraints, exactly.
impl From<Zonotope> for ConstrainedZonotope {
    fn from(body: Zonotope) -> Self {
        let constraints = Matrix::zeros(0, body.num_generators());
        Self { body, constraints, ranges: Vec::new() }
    }
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for ConstrainedZonotope {
    fn clone(&self) -> Self {
        Self { body: self.body.clone(), constraints: self.constraints.clone(), ranges: self.ranges.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        self.body.clone_from(&source.body);
        self.constraints.clone_from(&source.constraints);
        self.ranges.clone_from(&source.ranges);
    }
}

/// What is stored of a constrained zonotope; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    body: Zonotope,
    constraints: Matrix,
    ranges: Vec<Interval>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for ConstrainedZonotope {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        Self::with_constraints(&parts.body, &parts.constraints, &parts.ranges)
    }
}
