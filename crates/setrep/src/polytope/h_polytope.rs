//! Polytopes as intersections of half-spaces.

use core::cmp::Ordering;

use scalars::Interval;

use super::exact::sign_of_sum;
use crate::{Matrix, Membership, Part, SetError};

/// A polytope in half-space form, `{ x in R^n : H x <= h }`, shapes `H: m x n`, `h: m`.
///
/// The rows may be redundant and the set may be empty, flat or unbounded; what needs more says so by a typed error. The set is the
/// exact one of the stored numbers: nothing is normalised.
///
/// ```
/// # use setrep::{HPolytope, Matrix};
/// let h = Matrix::from_rows(&[&[-1.0, 0.0], &[0.0, -1.0], &[1.0, 1.0]])?;
/// let triangle = HPolytope::new(h, &[0.0, 0.0, 1.0])?;
/// assert_eq!(triangle.to_v_polytope()?.num_vertices(), 3);
/// assert!(triangle.volume()?.contains(0.5));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct HPolytope {
    pub(super) normals: Matrix,
    pub(super) offsets: Vec<f64>,
}

impl HPolytope {
    /// `{ x : H x <= h }`; without rows it is the whole space.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`], [`SetError::Dimension`], [`SetError::NonFinite`].
    pub fn new(normals: Matrix, offsets: &[f64]) -> Result<Self, SetError> {
        if normals.cols() == 0 {
            return Err(SetError::ZeroDimension { part: Part::Normals });
        }
        SetError::check_size(Part::Offsets, normals.rows(), offsets.len())?;
        SetError::check_finite(Part::Normals, normals.rows(), normals.as_slice())?;
        SetError::check_finite(Part::Offsets, offsets.len(), offsets)?;
        Ok(Self { normals, offsets: offsets.to_vec() })
    }

    /// The box of the given sides: `2n` half-spaces, exact.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side.
    pub fn from_intervals(sides: &[Interval]) -> Result<Self, SetError> {
        check_bounded(Part::Interval, sides)?;
        let n = sides.len();
        let mut normals = Matrix::zeros(2 * n, n);
        let mut offsets = Vec::with_capacity(2 * n);
        for (k, side) in sides.iter().enumerate() {
            normals[(2 * k, k)] = 1.0;
            normals[(2 * k + 1, k)] = -1.0;
            offsets.extend([side.hi(), -side.lo()]);
        }
        Self::new(normals, &offsets)
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.normals.cols()
    }

    /// Number `m` of half-spaces.
    #[must_use]
    pub fn num_half_spaces(&self) -> usize {
        self.offsets.len()
    }

    /// `H`, shape `m x n`.
    #[must_use]
    pub fn normals(&self) -> &Matrix {
        &self.normals
    }

    /// `h`, shape `m`.
    #[must_use]
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// Row `i` of `H`.
    pub(super) fn normal(&self, i: usize) -> impl Iterator<Item = f64> + Clone + '_ {
        (0..self.dim()).map(move |k| self.normals[(i, k)])
    }

    /// Intersection: the half-spaces of both, `{ x : H x <= h, K x <= k }`.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the sets live in different spaces.
    pub fn intersection(&self, other: &Self) -> Result<Self, SetError> {
        SetError::check_size(Part::Normals, self.dim(), other.dim())?;
        let (m, k) = (self.num_half_spaces(), other.num_half_spaces());
        let mut normals = Matrix::zeros(m + k, self.dim());
        for j in 0..self.dim() {
            normals.col_mut(j)[..m].copy_from_slice(self.normals.col(j));
            normals.col_mut(j)[m..].copy_from_slice(other.normals.col(j));
        }
        Ok(Self { normals, offsets: [&*self.offsets, &*other.offsets].concat() })
    }

    /// The half-spaces with the given indices.
    pub(super) fn select(&self, rows: &[usize]) -> Self {
        let mut normals = Matrix::zeros(rows.len(), self.dim());
        for j in 0..self.dim() {
            for (x, &i) in normals.col_mut(j).iter_mut().zip(rows) {
                *x = self.normals[(i, j)];
            }
        }
        Self { normals, offsets: rows.iter().map(|&i| self.offsets[i]).collect() }
    }

    /// Whether a point, known to lie in a box `P`, lies in the set: inside if `P` is a subset, outside if a half-space misses `P`.
    ///
    /// **Guarantee:** the signs of `a'x - b` at the corners that matter are exact, so a box without width is always decided.
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side.
    ///
    /// ```
    /// # use setrep::{HPolytope, IntervalVector, Membership};
    /// let square = HPolytope::from_intervals(&IntervalVector::from_center(&[0.0, 0.0], &[1.0, 1.0])?)?;
    /// assert_eq!(square.membership(&IntervalVector::point(&[1.0, 0.0]))?, Membership::ProvenInside);
    /// assert_eq!(square.membership(&IntervalVector::point(&[1.1, 0.0]))?, Membership::ProvenOutside);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn membership(&self, point: &[Interval]) -> Result<Membership, SetError> {
        SetError::check_size(Part::Point, self.dim(), point.len())?;
        check_bounded(Part::Point, point)?;
        let mut verdict = Membership::ProvenInside;
        for (i, &offset) in self.offsets.iter().enumerate() {
            let end = |a: f64, side: &Interval, upper: bool| if (a > 0.0) == upper { side.hi() } else { side.lo() };
            let side = |upper| {
                let terms = self.normal(i).zip(point).map(move |(a, side)| (a, end(a, side, upper)));
                sign_of_sum(terms.chain(core::iter::once((offset, -1.0))))
            };
            if side(true) == Ordering::Greater {
                if side(false) == Ordering::Greater {
                    return Ok(Membership::ProvenOutside);
                }
                verdict = Membership::Undecided;
            }
        }
        Ok(verdict)
    }
}

/// `Ok` if every side is nonempty and bounded.
pub(super) fn check_bounded(part: Part, sides: &[Interval]) -> Result<(), SetError> {
    match sides.iter().position(|side| side.is_empty() || !side.is_bounded()) {
        None => Ok(()),
        Some(row) => Err(SetError::UnboundedInterval { part, row, col: 0 }),
    }
}

/// What is stored of a polytope; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    normals: Matrix,
    offsets: Vec<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for HPolytope {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        Self::new(parts.normals, &parts.offsets)
    }
}
