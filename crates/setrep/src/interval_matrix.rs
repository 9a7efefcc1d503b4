//! Interval matrices by midpoint and radius.

use faer::{Accum, MatMut, MatRef, Par, linalg::matmul::matmul};
use scalars::Interval;

use crate::bounds::{add_lengths, gamma, product_sum_bound};
use crate::{IntervalVector, Matrix, Part, SetError};

/// A matrix of intervals `M +- R = { A : |A - M| <= R entrywise }`, shapes `M, R: rows x cols`, `R >= 0`.
///
/// Midpoint and radius make a product three ordinary matrix products; the result is at most 1.5 times as wide as the tightest one
/// (Rump 1999).
///
/// ```
/// # use setrep::{IntervalMatrix, Matrix};
/// let a = IntervalMatrix::new(Matrix::identity(2), Matrix::zeros(2, 2))?;
/// let square = a.mul(&a)?;
/// assert!(square.get(0, 0).is_some_and(|x| x.contains(1.0)));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct IntervalMatrix {
    mid: Matrix,
    rad: Matrix,
}

impl IntervalMatrix {
    /// The interval matrix `mid +- rad`.
    ///
    /// # Errors
    /// Shapes that differ, entries that are not finite, negative radii.
    pub fn new(mid: Matrix, rad: Matrix) -> Result<Self, SetError> {
        SetError::check_size(Part::Radius, mid.rows(), rad.rows())?;
        SetError::check_size(Part::Radius, mid.cols(), rad.cols())?;
        SetError::check_finite(Part::Map, mid.rows(), mid.as_slice())?;
        SetError::check_lengths(Part::Radius, rad.rows(), rad.as_slice())?;
        Ok(Self { mid, rad })
    }

    /// The interval matrix of one real matrix, without width.
    ///
    /// # Errors
    /// [`SetError::NonFinite`].
    pub fn point(mid: Matrix) -> Result<Self, SetError> {
        let rad = Matrix::zeros(mid.rows(), mid.cols());
        Self::new(mid, rad)
    }

    /// From intervals in column-major order.
    ///
    /// **Guarantee:** every entry contains the interval given; wider by the rounding of midpoint and radius.
    ///
    /// # Errors
    /// [`SetError::Dimension`], an interval that is empty or unbounded.
    pub fn from_intervals(rows: usize, cols: usize, entries: &[Interval]) -> Result<Self, SetError> {
        if let Some(k) = entries.iter().position(|x| x.is_empty() || !x.is_bounded()) {
            return Err(SetError::UnboundedInterval {
                part: Part::Interval,
                row: k % rows.max(1),
                col: k / rows.max(1),
            });
        }
        let mid: Vec<f64> = entries.iter().map(Interval::mid).collect();
        let rad: Vec<f64> = entries.iter().map(Interval::rad).collect();
        Self::new(Matrix::from_column_slice(rows, cols, &mid)?, Matrix::from_column_slice(rows, cols, &rad)?)
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.mid.rows()
    }

    /// Number of columns.
    #[must_use]
    pub fn cols(&self) -> usize {
        self.mid.cols()
    }

    /// The midpoints `M`.
    #[must_use]
    pub fn mid(&self) -> &Matrix {
        &self.mid
    }

    /// The radii `R`.
    #[must_use]
    pub fn rad(&self) -> &Matrix {
        &self.rad
    }

    /// Entry `(i, j)` as an interval, rounded outward, if it exists.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> Option<Interval> {
        Some(Interval::point(self.mid.get(i, j)?).inflate(self.rad.get(i, j)?))
    }

    /// The sum `{ A + B }`.
    ///
    /// **Guarantee:** contains every exact sum of members.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::Overflow`].
    pub fn add(&self, other: &Self) -> Result<Self, SetError> {
        SetError::check_size(Part::Map, self.rows(), other.rows())?;
        SetError::check_size(Part::Map, self.cols(), other.cols())?;
        let mut sum = self.clone();
        for (k, (mid, rad)) in sum.mid.as_mut_slice().iter_mut().zip(sum.rad.as_mut_slice()).enumerate() {
            let (value, error) = crate::bounds::two_sum(*mid, other.mid.as_slice()[k]);
            *rad = add_lengths(add_lengths(*rad, other.rad.as_slice()[k]), error.abs());
            *mid = value;
        }
        sum.checked()
    }

    /// The product `{ A B }`, shapes `p x n` and `n x q`.
    ///
    /// `(M +- R)(N +- Q) = MN +- (|M| (gamma_n |N| + Q) + R (|N| + Q))`, the term in `gamma_n` for the rounding of `MN`.
    ///
    /// **Guarantee:** contains every exact product of members.
    /// **Source:** Rump 1999; Rump 2012 for the rounding.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::Overflow`], [`SetError::ZeroDimension`] for factors that share no dimension (`n = 0`).
    pub fn mul(&self, other: &Self) -> Result<Self, SetError> {
        let (p, n, q) = (self.rows(), self.cols(), other.cols());
        SetError::check_size(Part::Map, n, other.rows())?;
        if n == 0 {
            // Without entries nothing bounds p and q, and the product may not fit in memory.
            return Err(SetError::ZeroDimension { part: Part::Map });
        }
        let gamma = gamma(n);
        let right = other.mid.as_slice().iter().zip(other.rad.as_slice());
        let rounded: Vec<f64> = right
            .clone()
            .map(|(m, r)| add_lengths(product_sum_bound(gamma * m.abs(), usize::from(*m != 0.0), 1), *r))
            .collect();
        let magnitude: Vec<f64> = right.map(|(m, r)| add_lengths(m.abs(), *r)).collect();
        let absolute: Vec<f64> = self.mid.as_slice().iter().map(|m| m.abs()).collect();

        let (mut mid, mut rad) = (Matrix::zeros(p, q), Matrix::zeros(p, q));
        multiply_add(self.mid.as_slice(), other.mid.as_slice(), n, &mut mid, Accum::Replace);
        multiply_add(&absolute, &rounded, n, &mut rad, Accum::Replace);
        multiply_add(self.rad.as_slice(), &magnitude, n, &mut rad, Accum::Add);
        for i in 0..p {
            for j in 0..q {
                // Three products a term: |M| gamma |N| and |M| Q, R (|N| + Q), and that of MN itself.
                let active =
                    |k: &usize| magnitude[j * n + k] != 0.0 && (absolute[k * p + i] != 0.0 || self.rad[(i, *k)] != 0.0);
                let products = 3 * (0..n).filter(active).count();
                rad[(i, j)] = product_sum_bound(rad[(i, j)], products, 2 * n + 1);
            }
        }
        Self { mid, rad }.checked()
    }

    /// The product with a box, `{ A x : A in self, x in box }`.
    ///
    /// **Guarantee:** contains every exact product.
    ///
    /// # Errors
    /// As [`mul`](Self::mul), and an interval that is empty or unbounded.
    pub fn mul_vector(&self, x: &[Interval]) -> Result<IntervalVector, SetError> {
        let product = self.mul(&Self::from_intervals(x.len(), 1, x)?)?;
        Ok((0..self.rows()).filter_map(|i| product.get(i, 0)).collect())
    }

    /// `self`, if nothing overflowed.
    fn checked(self) -> Result<Self, SetError> {
        let finite = |k: &usize| self.mid.as_slice()[*k].is_finite() && self.rad.as_slice()[*k].is_finite();
        match (0..self.mid.as_slice().len()).find(|k| !finite(k)) {
            None => Ok(self),
            Some(k) => Err(SetError::Overflow { row: k % self.rows().max(1) }),
        }
    }
}

/// `target (+)= a b` through faer, `n` the inner size; all operands column-major.
fn multiply_add(a: &[f64], b: &[f64], n: usize, target: &mut Matrix, accum: Accum) {
    let (p, q) = (target.rows(), target.cols());
    matmul(
        MatMut::from_column_major_slice_mut(target.as_mut_slice(), p, q),
        accum,
        MatRef::from_column_major_slice(a, p, n),
        MatRef::from_column_major_slice(b, n, q),
        1.0,
        Par::Seq,
    );
}

impl<const R: usize, const C: usize> TryFrom<&nalgebra::SMatrix<Interval, R, C>> for IntervalMatrix {
    type Error = SetError;

    fn try_from(entries: &nalgebra::SMatrix<Interval, R, C>) -> Result<Self, SetError> {
        Self::from_intervals(R, C, entries.as_slice())
    }
}

/// What is stored of an interval matrix; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    mid: Matrix,
    rad: Matrix,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for IntervalMatrix {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        Self::new(parts.mid, parts.rad)
    }
}
