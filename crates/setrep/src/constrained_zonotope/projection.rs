//! Projection on coordinates, and slices through given values of some.

use scalars::Interval;

use super::ConstrainedZonotope;
use crate::{Matrix, SetError, Workspace};

impl ConstrainedZonotope {
    /// Projection `{ (x_k : k in coordinates) : x in X }`, in the order given.
    ///
    /// **Guarantee:** exact for distinct coordinates; a superset if one is repeated.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`] for no coordinates, [`SetError::NoSuchCoordinate`].
    pub fn project(&self, coordinates: &[usize]) -> Result<Self, SetError> {
        self.linear_map(&selection(coordinates, self.dim())?)
    }

    /// Slice: the other coordinates, in order, of the members whose `coordinates` lie in `ranges`; points fix them.
    ///
    /// An [intersection](Self::intersect_rows), then a [projection](Self::project).
    ///
    /// **Guarantee:** superset of the exact slice, by rounding only if the remainder is zero along the coordinates or the ranges are
    /// wide beside it.
    ///
    /// # Errors
    /// [`SetError::Dimension`] unless there is one range a coordinate, [`SetError::NoSuchCoordinate`], [`SetError::EmptyInterval`],
    /// [`SetError::ZeroDimension`] if no coordinate is left, [`SetError::Overflow`].
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{ConstrainedZonotope, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut triangle = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// triangle.intersect_half_space(&[1.0, 1.0], 0.0, &mut workspace)?;
    /// let slice = triangle.slice(&[0], &[Interval::point(0.5)], &mut workspace)?;
    /// let hull = slice.interval_hull(&mut workspace)?;
    /// assert!(hull.len() == 1 && hull[0].contains(-0.5) && hull[0].width() < 0.5 + 1e-13);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn slice(
        &self,
        coordinates: &[usize],
        ranges: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<Self, SetError> {
        let rest: Vec<usize> = (0..self.dim()).filter(|k| !coordinates.contains(k)).collect();
        let kept = selection(&rest, self.dim())?;
        let mut slice = self.clone();
        if !coordinates.is_empty() {
            slice.intersect_rows(&selection(coordinates, self.dim())?, ranges, workspace)?;
        }
        slice.linear_map_in_place(&kept, workspace)?;
        Ok(slice)
    }
}

/// The matrix that selects coordinates.
pub(crate) fn selection(coordinates: &[usize], dim: usize) -> Result<Matrix, SetError> {
    let mut map = Matrix::zeros(coordinates.len(), dim);
    for (i, &k) in coordinates.iter().enumerate() {
        if k >= dim {
            return Err(SetError::NoSuchCoordinate { index: k, dim });
        }
        map[(i, k)] = 1.0;
    }
    if coordinates.is_empty() {
        return Err(SetError::ZeroDimension { part: crate::Part::Map });
    }
    Ok(map)
}
