//! Image under an interval matrix, `{ J x : J in [J], x in X }`.

use scalars::Interval;

use super::linear_map::{Spread, remainder_of_image};
use crate::{IntervalMatrix, Part, SetError, Workspace, Zonotope};

impl Zonotope {
    /// Image of the set under every member of the interval matrix `[J] = M +- R`, shape `p x n`.
    ///
    /// `J x = M x + (J - M) x` and `|(J - M) x| <= R mag(H)` with the interval hull `H`, so the image lies in
    /// `<M c, M G, |M| r + R mag(H)>`. Translate the set so that `H` is about the origin where the model allows it: `mag(H)` is then
    /// the half-width of the hull, and the bound at most that of the CZ-inclusion for any other reference point.
    ///
    /// **Guarantee:** superset of `{ J x }`.
    /// **Source:** paper 003, Theorem 1 (CZ-inclusion) with the hull in place of its bound.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{IntervalMatrix, Matrix, Zonotope};
    /// let set = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let map = IntervalMatrix::new(Matrix::identity(2), Matrix::from_rows(&[&[0.0, 0.5], &[0.0, 0.0]])?)?;
    /// assert!(set.interval_map(&map)?.interval_hull()[0].contains(1.5));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn interval_map(&self, map: &IntervalMatrix) -> Result<Self, SetError> {
        let mut image = self.clone();
        image.interval_map_in_place(map, &mut Workspace::new())?;
        Ok(image)
    }

    /// [`interval_map`](Self::interval_map) in place; allocates nothing within the capacity of set and workspace.
    ///
    /// # Errors
    /// As [`interval_map`](Self::interval_map); the set is then unchanged.
    pub fn interval_map_in_place(&mut self, map: &IntervalMatrix, workspace: &mut Workspace) -> Result<(), SetError> {
        self.interval_map_over(map, None, workspace)
    }

    /// [`interval_map_in_place`](Self::interval_map_in_place) of the part of the set that lies in `hull`.
    pub(crate) fn interval_map_over(
        &mut self,
        map: &IntervalMatrix,
        hull: Option<&[Interval]>,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_size(Part::Map, self.dim(), map.cols())?;
        if map.rows() == 0 {
            return Err(SetError::ZeroDimension { part: Part::Map });
        }
        self.magnitudes(map.mid(), workspace);
        let spread = Spread { rad: map.rad(), hull };
        remainder_of_image(map.mid(), Some(&spread), self.num_generators() + self.dim() + 1, workspace)?;
        self.apply(map.mid(), workspace);
        Ok(())
    }
}
