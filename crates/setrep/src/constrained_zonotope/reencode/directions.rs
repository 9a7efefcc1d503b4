//! Directions in which a set is kept tight from one re-encoding to the next.

use crate::cholesky::{factorise, solve};
use crate::{ConstrainedZonotope, Matrix, Part, SetError, Workspace};

/// Weight that keeps singular maps invertible, beside rows of length 1.
const WEIGHT: f64 = 1e-13;

/// A list of directions `d` of `R^n`: candidates for [`ConstrainedZonotope::reencode`](crate::ConstrainedZonotope::reencode), which
/// leaves those that it used.
///
/// They are hints: a bad direction costs tightness, never validity. A filter keeps one list beside its set, carries it through its
/// maps by [`transport`](Self::transport), and appends the rows of its measurements.
///
/// ```
/// # use setrep::{Directions, Matrix, Workspace};
/// let mut directions = Directions::new(2);
/// directions.push(&[1.0, 0.0])?;
/// // y = R x with x_1 = (y_1 + y_2) / 2.
/// let map = Matrix::from_rows(&[&[1.0, -1.0], &[1.0, 1.0]])?;
/// directions.transport(&map, &mut Workspace::new())?;
/// let carried = directions.iter().next().unwrap_or(&[]);
/// assert!((carried[0] - 0.5).abs() < 1e-12 && (carried[1] - 0.5).abs() < 1e-12);
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct Directions {
    dim: usize,
    /// Direction after direction.
    entries: Vec<f64>,
}

impl Directions {
    /// No directions, in dimension `n`.
    #[must_use]
    pub fn new(dim: usize) -> Self {
        Self { dim, entries: Vec::new() }
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// Number of directions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len() / self.dim.max(1)
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The directions in order, each of length `n`.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[f64]> + Clone {
        self.entries.chunks_exact(self.dim.max(1))
    }

    /// Forgets all directions, and keeps their memory.
    pub fn clear(&mut self) {
        self.entries.clear();
    }

    /// Forgets all directions and keeps their memory, for a space of dimension `n`.
    pub fn reset(&mut self, dim: usize) {
        self.dim = dim;
        self.entries.clear();
    }

    /// Appends the directions of another list.
    ///
    /// # Errors
    /// [`SetError::Dimension`].
    pub fn append(&mut self, other: &Self) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim, other.dim)?;
        self.entries.extend_from_slice(&other.entries);
        Ok(())
    }

    /// Becomes the chosen of the `candidates`, which follow each other.
    pub(super) fn assign(&mut self, candidates: &[f64], chosen: &[usize]) {
        self.entries.clear();
        for &k in chosen {
            self.entries.extend_from_slice(&candidates[k * self.dim..(k + 1) * self.dim]);
        }
    }

    /// Appends a direction.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`].
    pub fn push(&mut self, direction: &[f64]) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim, direction.len())?;
        SetError::check_finite(Part::Direction, direction.len(), direction)?;
        self.entries.extend_from_slice(direction);
        Ok(())
    }

    /// Appends the rows of `C: k x n`.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`].
    pub fn push_rows(&mut self, rows: &Matrix) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim, rows.cols())?;
        SetError::check_finite(Part::Direction, rows.rows(), rows.as_slice())?;
        for i in 0..rows.rows() {
            self.entries.extend((0..rows.cols()).map(|k| rows.col(k)[i]));
        }
        Ok(())
    }

    /// Appends a direction for every constraint of a set: the `d` of least squares with `d'G` near `A_i`, whose half-spaces bound the
    /// set where the constraint does. Approximate.
    ///
    /// # Errors
    /// [`SetError::Dimension`].
    pub fn push_constraints(&mut self, set: &ConstrainedZonotope, workspace: &mut Workspace) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim, set.dim())?;
        let mut rows = Self::new(set.num_generators());
        rows.push_rows(set.constraints())?;
        // G = 0 x 0 has no rows to carry.
        if !rows.is_empty() {
            rows.transport(set.generators(), workspace)?;
            self.entries.append(&mut rows.entries);
        }
        Ok(())
    }

    /// Carries the directions through `y = R x`, `R: p x n`: `d'x = e'y` with `R'e = d`, so `e = R'^-1 d`, or the `e` of least squares
    /// if there is none. Approximate. Allocates nothing within capacity.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::ZeroDimension`], [`SetError::NonFinite`] in `R`; the directions are then unchanged.
    pub fn transport(&mut self, map: &Matrix, workspace: &mut Workspace) -> Result<(), SetError> {
        let (p, n) = (map.rows(), self.dim);
        SetError::check_size(Part::Map, n, map.cols())?;
        if p == 0 {
            return Err(SetError::ZeroDimension { part: Part::Map });
        }
        SetError::check_finite(Part::Map, p, map.as_slice())?;
        let Workspace { frame: scaled, eigen: factor, scales, coordinates: carried, objective: solution, .. } =
            workspace;
        // (S R)(S R)' z = S R d and e = S z, with rows of S R of length 1.
        scales.clear();
        scales.resize(p, 0.0);
        for column in map.columns() {
            scales.iter_mut().zip(column).for_each(|(largest, a)| *largest = largest.max(a.abs()));
        }
        scales.iter_mut().for_each(|s| *s = if *s > f64::MIN_POSITIVE { 1.0 / *s } else { 0.0 });
        scaled.clear();
        for column in map.columns() {
            scaled.extend(column.iter().zip(scales.iter()).map(|(a, s)| a * s));
        }
        factor.clear();
        factor.resize(p * p, 0.0);
        for column in scaled.chunks_exact(p) {
            for k in 0..p {
                for i in k..p {
                    factor[k * p + i] += column[i] * column[k];
                }
            }
        }
        (0..p).for_each(|i| factor[i * p + i] += WEIGHT);
        factorise(factor, p);
        carried.clear();
        for direction in self.entries.chunks_exact(n.max(1)) {
            solution.clear();
            solution.resize(p, 0.0);
            for (column, d) in scaled.chunks_exact(p).zip(direction) {
                solution.iter_mut().zip(column).for_each(|(sum, a)| *sum += a * d);
            }
            solve(factor, p, solution);
            solution.iter_mut().zip(scales.iter()).for_each(|(x, s)| *x *= s);
            // A direction that overflows is none.
            if solution.iter().all(|x| x.is_finite()) {
                carried.extend_from_slice(solution);
            }
        }
        self.dim = p;
        core::mem::swap(&mut self.entries, carried);
        Ok(())
    }
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for Directions {
    fn clone(&self) -> Self {
        Self { dim: self.dim, entries: self.entries.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        self.dim = source.dim;
        self.entries.clone_from(&source.entries);
    }
}

/// What is stored of directions; reading them back checks that they are whole and finite.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    dim: usize,
    entries: Vec<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for Directions {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        let mut directions = Self::new(parts.dim);
        let whole = parts.entries.chunks(parts.dim.max(1));
        whole.into_iter().try_for_each(|direction| directions.push(direction))?;
        Ok(directions)
    }
}
