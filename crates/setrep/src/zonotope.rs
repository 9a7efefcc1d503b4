//! The zonotope with a box remainder.

use scalars::Interval;

use crate::{Matrix, Part, SetError};

/// A zonotope `<c, G, r> = { c + G xi + e : |xi_j| <= 1, |e_i| <= r_i }`, shapes `c: n`, `G: n x ng`, `r: n`.
///
/// The **box remainder** `r` is a buffer: rounding of every operation and axis-aligned noise go there and cost no generator. It is
/// not a place to keep uncertainty over many steps, for a map turns it into `|R| r`; the maps therefore turn a remainder of
/// model size into generators first (see [`linear_map_in_place`](Self::linear_map_in_place)), and
/// [`materialize`](Self::materialize) does so on demand.
///
/// Invariants: `n >= 1`, every entry finite, `r >= 0`. An operation that would break them is an error and leaves its operands as
/// they were.
///
/// ```
/// use setrep::{Matrix, Zonotope};
///
/// let generators = Matrix::from_columns(&[&[1.0, 0.0], &[0.5, 0.5], &[0.0, 2.0]])?;
/// let set = Zonotope::new(&[10.0, 20.0], &generators)?;
/// assert_eq!((set.dim(), set.num_generators()), (2, 3));
/// assert!(set.interval_hull()[1].contains(22.5));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "Parts"))]
pub struct Zonotope {
    pub(crate) center: Vec<f64>,
    pub(crate) generators: Matrix,
    pub(crate) remainder: Vec<f64>,
}

impl Zonotope {
    /// The zonotope `{ c + G xi : |xi| <= 1 }`.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// No dimension, sizes that differ, entries that are not finite.
    pub fn new(center: &[f64], generators: &Matrix) -> Result<Self, SetError> {
        Self::with_remainder(center, generators, &vec![0.0; center.len()])
    }

    /// The zonotope `<c, G, r>`.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// No dimension, sizes that differ, entries that are not finite, a negative remainder.
    pub fn with_remainder(center: &[f64], generators: &Matrix, remainder: &[f64]) -> Result<Self, SetError> {
        let n = center.len();
        if n == 0 {
            return Err(SetError::ZeroDimension { part: Part::Center });
        }
        SetError::check_size(Part::Generators, n, generators.rows())?;
        SetError::check_size(Part::Remainder, n, remainder.len())?;
        SetError::check_finite(Part::Center, n, center)?;
        SetError::check_finite(Part::Generators, n, generators.as_slice())?;
        SetError::check_lengths(Part::Remainder, n, remainder)?;
        Ok(Self { center: center.to_vec(), generators: generators.clone(), remainder: remainder.to_vec() })
    }

    /// The box `center +- radii`, kept in the remainder: no generators.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// No dimension, sizes that differ, entries that are not finite, negative radii.
    pub fn from_box(center: &[f64], radii: &[f64]) -> Result<Self, SetError> {
        SetError::check_size(Part::Radius, center.len(), radii.len())?;
        SetError::check_lengths(Part::Radius, radii.len(), radii)?;
        Self::with_remainder(center, &Matrix::zeros(center.len(), 0), radii)
    }

    /// The box of an interval vector, kept in the remainder: no generators.
    ///
    /// **Guarantee:** superset of the box; only the rounding of midpoints and radii is added.
    ///
    /// # Errors
    /// No dimension, an interval that is empty or unbounded.
    pub fn from_intervals(sides: &[Interval]) -> Result<Self, SetError> {
        if let Some(row) = sides.iter().position(|side| side.is_empty() || !side.is_bounded()) {
            return Err(SetError::UnboundedInterval { part: Part::Interval, row, col: 0 });
        }
        let center: Vec<f64> = sides.iter().map(Interval::mid).collect();
        let radii: Vec<f64> = sides.iter().map(Interval::rad).collect();
        Self::from_box(&center, &radii)
    }

    /// The set of one point.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// No dimension, entries that are not finite.
    pub fn point(x: &[f64]) -> Result<Self, SetError> {
        Self::with_remainder(x, &Matrix::zeros(x.len(), 0), &vec![0.0; x.len()])
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.center.len()
    }

    /// Number `ng` of generators (columns of `G`); the box remainder is not counted.
    #[must_use]
    pub fn num_generators(&self) -> usize {
        self.generators.cols()
    }

    /// The center `c`.
    #[must_use]
    pub fn center(&self) -> &[f64] {
        &self.center
    }

    /// The generator matrix `G`.
    #[must_use]
    pub fn generators(&self) -> &Matrix {
        &self.generators
    }

    /// The box remainder `r`.
    #[must_use]
    pub fn remainder(&self) -> &[f64] {
        &self.remainder
    }

    /// Makes room for `columns` more generators, so that appending them allocates nothing.
    pub fn reserve_generators(&mut self, columns: usize) {
        self.generators.reserve_cols(columns);
    }
}

/// Reuses the storage of the target in `clone_from`.
impl Clone for Zonotope {
    fn clone(&self) -> Self {
        Self { center: self.center.clone(), generators: self.generators.clone(), remainder: self.remainder.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        self.center.clone_from(&source.center);
        self.generators.clone_from(&source.generators);
        self.remainder.clone_from(&source.remainder);
    }
}

/// What is stored of a zonotope; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Parts {
    center: Vec<f64>,
    generators: Matrix,
    remainder: Vec<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parts> for Zonotope {
    type Error = SetError;

    fn try_from(parts: Parts) -> Result<Self, SetError> {
        Self::with_remainder(&parts.center, &parts.generators, &parts.remainder)
    }
}
