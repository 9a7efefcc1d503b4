//! Strips and half-spaces: what one measurement with bounded noise leaves.

use scalars::Interval;

use crate::{ConstrainedZonotope, HPolytope, Matrix, Membership, Part, SetError, Workspace, Zonotope};

/// A strip `{ x in R^n : a'x in [d] }`; one-sided if `[d]` is unbounded.
///
/// ```
/// # use scalars::Interval;
/// # use setrep::{Strip, Workspace, Zonotope};
/// // The measurement 2 x_1 + x_2 = 1, known to 1/4.
/// let strip = Strip::new(&[2.0, 1.0], Interval::point(1.0).inflate(0.25))?;
/// let prior = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
/// let mut workspace = Workspace::new();
/// let hull = prior.intersection(&[strip], &mut workspace)?.interval_hull(&mut workspace)?;
/// assert!(hull[0].contains(-0.125) && !hull[0].contains(-0.126));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "StripParts"))]
pub struct Strip {
    direction: Vec<f64>,
    range: Interval,
}

/// A half-space `{ x in R^n : a'x <= b }`.
///
/// ```
/// # use setrep::{HPolytope, HalfSpace};
/// let sides = [HalfSpace::new(&[-1.0, 0.0], 0.0)?, HalfSpace::new(&[0.0, -1.0], 0.0)?, HalfSpace::new(&[1.0, 1.0], 1.0)?];
/// let triangle = HPolytope::from_half_spaces(&sides)?;
/// assert_eq!((triangle.num_half_spaces(), triangle.half_space(2)), (3, Some(sides[2].clone())));
/// # Ok::<(), setrep::SetError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "HalfSpaceParts"))]
pub struct HalfSpace {
    normal: Vec<f64>,
    offset: f64,
}

impl Strip {
    /// `{ x : a'x in [d] }`. A direction of zeros gives the whole space or the empty set.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`], [`SetError::NonFinite`] in the direction, [`SetError::EmptyInterval`].
    pub fn new(direction: &[f64], range: Interval) -> Result<Self, SetError> {
        check_normal(direction)?;
        if range.is_empty() {
            return Err(SetError::EmptyInterval { part: Part::Range, row: 0 });
        }
        Ok(Self { direction: direction.to_vec(), range })
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.direction.len()
    }

    /// The direction `a`.
    #[must_use]
    pub fn direction(&self) -> &[f64] {
        &self.direction
    }

    /// The range `[d]`.
    #[must_use]
    pub fn range(&self) -> Interval {
        self.range
    }

    /// Whether a point, known to lie in a box, lies in the strip; see [`HPolytope::membership`].
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side.
    pub fn membership(&self, point: &[Interval]) -> Result<Membership, SetError> {
        HPolytope::from_strips(self.dim(), core::slice::from_ref(self))?.membership(point)
    }
}

impl HalfSpace {
    /// `{ x : a'x <= b }`. A normal of zeros gives the whole space or the empty set.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`]; [`SetError::NonFinite`] in the normal or the offset.
    pub fn new(normal: &[f64], offset: f64) -> Result<Self, SetError> {
        check_normal(normal)?;
        SetError::check_finite(Part::Offsets, 1, &[offset])?;
        Ok(Self { normal: normal.to_vec(), offset })
    }

    /// Dimension `n` of the space.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.normal.len()
    }

    /// The normal `a`, pointing outward.
    #[must_use]
    pub fn normal(&self) -> &[f64] {
        &self.normal
    }

    /// The offset `b`.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Whether a point, known to lie in a box, lies in the half-space; see [`HPolytope::membership`].
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side.
    pub fn membership(&self, point: &[Interval]) -> Result<Membership, SetError> {
        HPolytope::from_half_spaces(core::slice::from_ref(self))?.membership(point)
    }
}

fn check_normal(normal: &[f64]) -> Result<(), SetError> {
    if normal.is_empty() {
        return Err(SetError::ZeroDimension { part: Part::Direction });
    }
    SetError::check_finite(Part::Direction, normal.len(), normal)
}

/// `a'x <= b` is `a'x in [-inf, b]`, exactly.
impl From<HalfSpace> for Strip {
    fn from(half_space: HalfSpace) -> Self {
        // The offset is finite, so the interval exists.
        let range = Interval::new(f64::NEG_INFINITY, half_space.offset).unwrap_or(Interval::ENTIRE);
        Self { direction: half_space.normal, range }
    }
}

impl HPolytope {
    /// The intersection of half-spaces, at least one, exact.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`] without half-spaces; [`SetError::Dimension`] if they live in different spaces.
    pub fn from_half_spaces(half_spaces: &[HalfSpace]) -> Result<Self, SetError> {
        let n = half_spaces.first().map_or(0, HalfSpace::dim);
        Self::from_rows(n, half_spaces.iter().map(|side| (side.normal.as_slice(), 1.0, side.offset)))
    }

    /// The intersection of strips in `R^n`, exact: a half-space for each finite end of a range.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`]; [`SetError::Dimension`] for a strip in another space.
    pub fn from_strips(n: usize, strips: &[Strip]) -> Result<Self, SetError> {
        let ends = |strip: &'_ Strip| [(1.0, strip.range.hi()), (-1.0, -strip.range.lo())];
        let rows = strips.iter().flat_map(|strip| {
            ends(strip)
                .into_iter()
                .filter(|(_, b)| b.is_finite())
                .map(|(sign, b)| (strip.direction.as_slice(), sign, b))
        });
        Self::from_rows(n, rows)
    }

    /// Half-space `i`, if there is one.
    #[must_use]
    pub fn half_space(&self, i: usize) -> Option<HalfSpace> {
        let offset = *self.offsets().get(i)?;
        Some(HalfSpace { normal: self.normals().columns().map(|column| column[i]).collect(), offset })
    }

    /// The rows `sign a'x <= b`.
    fn from_rows<'a>(n: usize, rows: impl Iterator<Item = (&'a [f64], f64, f64)> + Clone) -> Result<Self, SetError> {
        let mut normals = Matrix::zeros(rows.clone().count(), n);
        let mut offsets = Vec::with_capacity(normals.rows());
        for (i, (normal, sign, offset)) in rows.enumerate() {
            SetError::check_size(Part::Normals, n, normal.len())?;
            normal.iter().enumerate().for_each(|(k, a)| normals[(i, k)] = sign * a);
            offsets.push(offset);
        }
        Self::new(normals, &offsets)
    }
}

impl ConstrainedZonotope {
    /// Intersection with strips, all in one go: [`intersect_rows`](Self::intersect_rows) with their directions and ranges. Half-spaces
    /// are strips by `into`.
    ///
    /// **Guarantee:** superset of the exact intersection.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows); the set is then unchanged.
    pub fn intersect_strips(&mut self, strips: &[Strip], workspace: &mut Workspace) -> Result<(), SetError> {
        let (rows, ranges) = rows_of(strips, self.dim())?;
        self.intersect_rows(&rows, &ranges, workspace)
    }

    /// Intersection with a polytope, `{ x in X : H x <= h }`: [`intersect_rows`](Self::intersect_rows) with one-sided rows.
    ///
    /// **Guarantee:** superset of the exact intersection.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows); the set is then unchanged.
    pub fn intersect_h_polytope(&mut self, polytope: &HPolytope, workspace: &mut Workspace) -> Result<(), SetError> {
        SetError::check_size(Part::Normals, self.dim(), polytope.dim())?;
        self.intersect_rows(polytope.normals(), &ranges_below(polytope.offsets()), workspace)
    }
}

/// Strips in `R^n` as rows `C x in [d]`.
pub(crate) fn rows_of(strips: &[Strip], n: usize) -> Result<(Matrix, Vec<Interval>), SetError> {
    let mut rows = Matrix::zeros(strips.len(), n);
    for (i, strip) in strips.iter().enumerate() {
        SetError::check_size(Part::Direction, n, strip.dim())?;
        strip.direction.iter().enumerate().for_each(|(k, &a)| rows[(i, k)] = a);
    }
    Ok((rows, strips.iter().map(Strip::range).collect()))
}

/// The ranges `[-inf, h_i]`.
pub(crate) fn ranges_below(offsets: &[f64]) -> Vec<Interval> {
    offsets.iter().map(|&h| Interval::new(f64::NEG_INFINITY, h).unwrap_or(Interval::ENTIRE)).collect()
}

impl Zonotope {
    /// Intersection with strips, a constrained zonotope; see [`ConstrainedZonotope::intersect_strips`].
    ///
    /// **Guarantee:** superset of the exact intersection.
    ///
    /// # Errors
    /// As [`ConstrainedZonotope::intersect_rows`].
    pub fn intersection(&self, strips: &[Strip], workspace: &mut Workspace) -> Result<ConstrainedZonotope, SetError> {
        let mut set = ConstrainedZonotope::from(self.clone());
        set.intersect_strips(strips, workspace)?;
        Ok(set)
    }
}

/// What is stored of a strip; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct StripParts {
    direction: Vec<f64>,
    range: Interval,
}

#[cfg(feature = "serde")]
impl TryFrom<StripParts> for Strip {
    type Error = SetError;

    fn try_from(parts: StripParts) -> Result<Self, SetError> {
        Self::new(&parts.direction, parts.range)
    }
}

/// What is stored of a half-space; reading it back checks the invariants.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct HalfSpaceParts {
    normal: Vec<f64>,
    offset: f64,
}

#[cfg(feature = "serde")]
impl TryFrom<HalfSpaceParts> for HalfSpace {
    type Error = SetError;

    fn try_from(parts: HalfSpaceParts) -> Result<Self, SetError> {
        Self::new(&parts.normal, parts.offset)
    }
}
