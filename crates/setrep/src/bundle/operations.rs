//! Intersection, maps, sums and products, member by member.

use scalars::Interval;

use super::ZonotopeBundle;
use crate::constrained_zonotope::selection;
use crate::{IntervalMatrix, Matrix, Part, SetError, Workspace, Zonotope};

impl ZonotopeBundle {
    /// Intersection with a zonotope, which becomes the last member.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if it lives in another space.
    pub fn intersect(&mut self, member: &Zonotope) -> Result<(), SetError> {
        SetError::check_size(Part::Members, self.dim(), member.dim())?;
        self.members.push(member.clone());
        Ok(())
    }

    /// Intersection with another bundle, whose members are appended.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if it lives in another space.
    pub fn intersect_bundle(&mut self, other: &Self) -> Result<(), SetError> {
        SetError::check_size(Part::Members, self.dim(), other.dim())?;
        self.members.extend_from_slice(&other.members);
        Ok(())
    }

    /// Image under the matrix `R: p x n`: the images of the members.
    ///
    /// **Guarantee:** superset of the exact image, `R (X and Y)` in `R X and R Y`; equal but for rounding if `R` is injective.
    ///
    /// # Errors
    /// As [`Zonotope::linear_map`].
    pub fn linear_map(&self, map: &Matrix) -> Result<Self, SetError> {
        let mut image = self.clone();
        image.linear_map_in_place(map, &mut Workspace::new())?;
        Ok(image)
    }

    /// [`linear_map`](Self::linear_map) in place; allocates nothing within the capacity of set and workspace.
    ///
    /// # Errors
    /// As [`linear_map`](Self::linear_map); the set is then unchanged.
    pub fn linear_map_in_place(&mut self, map: &Matrix, workspace: &mut Workspace) -> Result<(), SetError> {
        self.change(workspace, |member, workspace| member.linear_map_in_place(map, workspace))
    }

    /// Image under every member of an interval matrix, zonotope by zonotope.
    ///
    /// **Guarantee:** superset of `{ J x : J in [J], x in X }`.
    ///
    /// # Errors
    /// As [`Zonotope::interval_map_in_place`]; the set is then unchanged.
    pub fn interval_map_in_place(&mut self, map: &IntervalMatrix, workspace: &mut Workspace) -> Result<(), SetError> {
        self.change(workspace, |member, workspace| member.interval_map_in_place(map, workspace))
    }

    /// Minkowski sum with a zonotope, which is added to every member.
    ///
    /// **Guarantee:** superset of the exact sum, `(X and Y) + Z` in `(X + Z) and (Y + Z)`.
    ///
    /// # Errors
    /// As [`Zonotope::minkowski_sum`].
    pub fn minkowski_sum(&self, other: &Zonotope) -> Result<Self, SetError> {
        let mut sum = self.clone();
        sum.add_assign(other, &mut Workspace::new())?;
        Ok(sum)
    }

    /// [`minkowski_sum`](Self::minkowski_sum) in place; allocates nothing within the capacity of set and workspace.
    ///
    /// # Errors
    /// As [`minkowski_sum`](Self::minkowski_sum); the set is then unchanged.
    pub fn add_assign(&mut self, other: &Zonotope, workspace: &mut Workspace) -> Result<(), SetError> {
        self.change(workspace, |member, _| member.add_assign(other))
    }

    /// Minkowski sum with a box, which is added to every member's remainder.
    ///
    /// **Guarantee:** superset of the exact sum.
    ///
    /// # Errors
    /// As [`Zonotope::add_box`]; the set is then unchanged.
    pub fn add_box(&mut self, sides: &[Interval], workspace: &mut Workspace) -> Result<(), SetError> {
        self.change(workspace, |member, _| member.add_box(sides))
    }

    /// Projection `{ (x_k : k in coordinates) : x in X }`, in the order given: the projections of the members.
    ///
    /// **Guarantee:** superset of the exact projection; `bundle.to_constrained_zonotope()?.project(..)` is exact but for rounding.
    ///
    /// # Errors
    /// [`SetError::ZeroDimension`] for no coordinates, [`SetError::NoSuchCoordinate`].
    pub fn project(&self, coordinates: &[usize]) -> Result<Self, SetError> {
        self.linear_map(&selection(coordinates, self.dim())?)
    }

    /// Translation `t + X`.
    ///
    /// **Guarantee:** superset of the exact translate, by rounding only.
    ///
    /// # Errors
    /// As [`Zonotope::translate`]; the set is then unchanged.
    pub fn translate(&mut self, translation: &[f64], workspace: &mut Workspace) -> Result<(), SetError> {
        self.change(workspace, |member, _| member.translate(translation))
    }

    /// Scaling `a X = { a x : x in X }` about the origin.
    ///
    /// **Guarantee:** superset of the exact set, by rounding only, for `a != 0`.
    ///
    /// # Errors
    /// As [`Zonotope::scale`]; the set is then unchanged.
    pub fn scale(&mut self, factor: f64, workspace: &mut Workspace) -> Result<(), SetError> {
        self.change(workspace, |member, _| member.scale(factor))
    }

    /// Cartesian product `{ (x, y) : x in X, y in Y }`: products of members, those of the shorter list repeated.
    ///
    /// **Guarantee:** exact.
    #[must_use]
    pub fn cartesian_product(&self, other: &Self) -> Self {
        let count = self.members.len().max(other.members.len());
        let pair = |k: usize| {
            let (x, y) = (&self.members[k % self.members.len()], &other.members[k % other.members.len()]);
            x.cartesian_product(y)
        };
        Self { members: (0..count).map(pair).collect() }
    }

    /// Changes all members, or none if one refuses.
    pub(super) fn change(
        &mut self,
        workspace: &mut Workspace,
        mut change: impl FnMut(&mut Zonotope, &mut Workspace) -> Result<(), SetError>,
    ) -> Result<(), SetError> {
        let mut draft = core::mem::take(&mut workspace.members);
        draft.clone_from(&self.members);
        let result = draft.iter_mut().try_for_each(|member| change(member, workspace));
        if result.is_ok() {
            core::mem::swap(&mut self.members, &mut draft);
        }
        workspace.members = draft;
        result
    }
}
