//! Polytopes as convex hulls of points.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::MAX_FACES;
use super::error_free::{dot_compensated, dot_plain};
use super::h_polytope::check_bounded;
use super::solve::dot_upper;
use crate::{IntervalVector, Matrix, Part, SetError};

/// A polytope in vertex form with a box remainder, `conv { v_1, .., v_m } + [-r, r]`, shapes `V: n x m`, `r: n`.
///
/// The vertices are the columns of `V`; they may repeat, and some may lie inside the hull. The textbook form is `r = 0`; operations
/// that round add what they lost to `r`, as those of [`Zonotope`](crate::Zonotope) do.
///
/// ```
/// # use setrep::{Matrix, VPolytope};
/// let triangle = VPolytope::new(Matrix::from_columns(&[&[0.0, 0.0], &[1.0, 0.0], &[0.0, 1.0]])?)?;
/// assert_eq!(triangle.to_h_polytope()?.num_half_spaces(), 3);
/// assert_eq!(triangle.support(&[1.0, 1.0])?, 1.0);
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct VPolytope {
    pub(super) vertices: Matrix,
    pub(super) remainder: Vec<f64>,
}

impl VPolytope {
    /// The convex hull of the columns.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`]; [`SetError::EmptySet`] without columns; [`SetError::NonFinite`].
    pub fn new(vertices: Matrix) -> Result<Self, SetError> {
        let remainder = vec![0.0; vertices.rows()];
        Self::with_remainder(vertices, &remainder)
    }

    /// The convex hull of the columns plus the box `[-r, r]`.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`SetError::Dimension`], [`SetError::NonFinite`], [`SetError::Negative`] for the remainder.
    pub fn with_remainder(vertices: Matrix, remainder: &[f64]) -> Result<Self, SetError> {
        if vertices.rows() == 0 {
            return Err(SetError::ZeroDimension { part: Part::Vertices });
        }
        if vertices.cols() == 0 {
            return Err(SetError::EmptySet);
        }
        SetError::check_finite(Part::Vertices, vertices.rows(), vertices.as_slice())?;
        SetError::check_size(Part::Remainder, vertices.rows(), remainder.len())?;
        SetError::check_lengths(Part::Remainder, remainder.len(), remainder)?;
        Ok(Self { vertices, remainder: remainder.to_vec() })
    }

    /// The box of the given sides: one vertex a corner, exact. Sides without width double no corner.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`]; [`SetError::UnboundedInterval`]; [`SetError::OverBudget`] beyond [`MAX_FACES`] corners.
    pub fn from_intervals(sides: &[Interval]) -> Result<Self, SetError> {
        check_bounded(Part::Interval, sides)?;
        let wide = sides.iter().filter(|side| side.lo() < side.hi()).count();
        let corners = 1_usize.checked_shl(wide as u32).unwrap_or(usize::MAX);
        if corners > MAX_FACES {
            return Err(SetError::OverBudget { count: corners, limit: MAX_FACES });
        }
        let mut vertices = Matrix::zeros(sides.len(), corners);
        for j in 0..corners {
            let mut bits = j;
            for (x, side) in vertices.col_mut(j).iter_mut().zip(sides) {
                *x = side.lo();
                if side.lo() < side.hi() {
                    if bits & 1 == 1 {
                        *x = side.hi();
                    }
                    bits >>= 1;
                }
            }
        }
        Self::new(vertices)
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.vertices.rows()
    }

    /// Number `m` of columns of `V`.
    #[must_use]
    pub fn num_vertices(&self) -> usize {
        self.vertices.cols()
    }

    /// `V`, shape `n x m`.
    #[must_use]
    pub fn vertices(&self) -> &Matrix {
        &self.vertices
    }

    /// The box remainder `r`, shape `n`.
    #[must_use]
    pub fn remainder(&self) -> &[f64] {
        &self.remainder
    }

    /// Whether `r = 0`.
    pub(super) fn is_exact(&self) -> bool {
        self.remainder.iter().all(|&r| r == 0.0)
    }

    /// Support function `h(d) = max_j d'v_j + |d|'r`, shape `d: n`.
    ///
    /// **Guarantee:** an upper bound within an ulp or two of the exact value; exact where no product and no sum rounds.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction.
    pub fn support(&self, direction: &[f64]) -> Result<f64, SetError> {
        SetError::check_size(Part::Direction, self.dim(), direction.len())?;
        SetError::check_finite(Part::Direction, direction.len(), direction)?;
        Ok(self.support_over(direction, 0..self.num_vertices()))
    }

    /// [`support`](Self::support) of the hull of some of the columns plus the remainder.
    pub(super) fn support_over(&self, direction: &[f64], columns: impl Iterator<Item = usize>) -> f64 {
        let columns: Vec<usize> = columns.collect();
        let plain: Vec<(f64, f64)> = columns.iter().map(|&j| dot_plain(direction, self.vertices.col(j))).collect();
        let floor = plain.iter().map(|(value, error)| value - 2.0 * error).fold(f64::NEG_INFINITY, f64::max);
        let mut largest = f64::NEG_INFINITY;
        for (&j, &(value, error)) in columns.iter().zip(&plain) {
            // Columns certainly below another one are left out; NaN is not below.
            let below = value + 2.0 * error < floor;
            if !below {
                let bound = dot_upper(direction, self.vertices.col(j));
                largest = if bound > largest || bound.is_nan() { bound } else { largest };
            }
        }
        self.remainder
            .iter()
            .zip(direction)
            .filter(|(r, _)| **r != 0.0)
            .fold(largest, |h, (&r, d)| add_up(h, mul_up(r, d.abs())))
    }

    /// The smallest box that contains the set.
    ///
    /// **Guarantee:** superset; exact for `r = 0`.
    #[must_use]
    pub fn interval_hull(&self) -> IntervalVector {
        (0..self.dim())
            .map(|k| {
                let values = self.vertices.columns().map(|v| Interval::point(v[k]));
                values.reduce(Interval::hull).unwrap_or(Interval::EMPTY).inflate(self.remainder[k])
            })
            .collect()
    }

    /// Image `{ R x : x in X }`, shape `R: p x n`; the columns stay in order.
    ///
    /// `R (conv V + [-r, r])` lies in `conv (R V) + [-|R| r, |R| r]`: exact but for rounding if `r = 0`.
    ///
    /// **Guarantee:** superset of the exact image.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::ZeroDimension`], [`SetError::NonFinite`] in the map, [`SetError::Overflow`].
    pub fn linear_map(&self, map: &Matrix) -> Result<Self, SetError> {
        SetError::check_size(Part::Map, self.dim(), map.cols())?;
        if map.rows() == 0 {
            return Err(SetError::ZeroDimension { part: Part::Map });
        }
        SetError::check_finite(Part::Map, map.rows(), map.as_slice())?;
        let mut vertices = Matrix::zeros(map.rows(), self.num_vertices());
        let mut remainder = Vec::with_capacity(map.rows());
        for i in 0..map.rows() {
            let row: Vec<f64> = (0..map.cols()).map(|k| map[(i, k)]).collect();
            let mut lost = 0.0_f64;
            for j in 0..self.num_vertices() {
                let (value, error) = dot_compensated(&row, self.vertices.col(j));
                vertices[(i, j)] = value;
                lost = if error > lost || error.is_nan() { error } else { lost };
            }
            let carried = row
                .iter()
                .zip(&self.remainder)
                .filter(|(_, r)| **r != 0.0)
                .fold(lost, |sum, (a, &r)| add_up(sum, mul_up(a.abs(), r)));
            if !carried.is_finite() {
                return Err(SetError::Overflow { row: i });
            }
            remainder.push(carried);
        }
        Self::with_remainder(vertices, &remainder)
    }
}

/// What is stored of a polytope; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    vertices: Matrix,
    remainder: Vec<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for VPolytope {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        Self::with_remainder(parts.vertices, &parts.remainder)
    }
}
