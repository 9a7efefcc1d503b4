//! Images under a matrix and under an interval matrix.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::ConstrainedZonotope;
use crate::{IntervalMatrix, Matrix, Part, SetError, Workspace};

impl ConstrainedZonotope {
    /// Image of the set under the matrix `R: p x n`: `<R c, R G, |R| r; A, [b]>`, after a remainder of model size has become
    /// generators (see [`Zonotope::linear_map_in_place`](crate::Zonotope::linear_map_in_place)).
    ///
    /// **Guarantee:** superset of the exact image.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Proposition 1.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in `R`, [`SetError::Overflow`].
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
        self.body.linear_map_in_place(map, workspace)?;
        self.pad_constraints();
        Ok(())
    }

    /// Image of the part of the set in `hull` under every member of the interval matrix `[J] = M +- R`, shape `p x n`: the
    /// CZ-inclusion.
    ///
    /// `J x = M x + (J - M) x` and `|(J - M) x| <= R mag(H)` for `x` in the box `H`, so the image lies in
    /// `<M c, M G, |M| r + R mag(H); A, [b]>`. With `H` the interval hull of the set the bound is never above that of the paper, which
    /// goes through the set without its constraints. Translate the set so that `H` is about the origin where the model allows it.
    ///
    /// **Guarantee:** superset of `{ J x : J in [J], x in X and H }`; of the whole image if `H` contains the set.
    /// **Source:** paper 003, Theorem 1, with the hull in place of its bound.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{ConstrainedZonotope, IntervalMatrix, Matrix, Workspace};
    /// let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let map = IntervalMatrix::new(Matrix::identity(2), Matrix::from_rows(&[&[0.0, 0.5], &[0.0, 0.0]])?)?;
    /// let hull = [Interval::point(0.0).inflate(1.0); 2];
    /// set.interval_map_in_place(&map, &hull, &mut Workspace::new())?;
    /// assert!(set.unconstrained().interval_hull()[0].contains(1.5));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn interval_map_in_place(
        &mut self,
        map: &IntervalMatrix,
        hull: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_size(Part::Interval, self.dim(), hull.len())?;
        self.body.interval_map_over(map, Some(hull), workspace)?;
        self.pad_constraints();
        Ok(())
    }

    /// The CZ-inclusion of the paper: as [`interval_map_in_place`](Self::interval_map_in_place), with
    /// `P_i = sum_k R_ik (|c_k| + sum_j |G_kj| + r_k)` of the set `<c, G, r>` that is left when all constraints are eliminated.
    ///
    /// No linear program, but never below the bound from the hull; for comparison with the paper.
    ///
    /// **Guarantee:** superset of `{ J x : J in [J], x in X }`.
    /// **Source:** paper 003, Theorem 1.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::ZeroDimension`], [`SetError::Overflow`]; the set is then unchanged.
    pub fn interval_map_by_elimination_in_place(
        &mut self,
        map: &IntervalMatrix,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_size(Part::Map, self.dim(), map.cols())?;
        let mut free = self.clone();
        free.eliminate_constraints(0, workspace)?;
        let magnitudes: Vec<f64> = free.body.interval_hull().iter().map(Interval::mag).collect();
        let mut spread = Vec::with_capacity(map.rows());
        for row in 0..map.rows() {
            let terms = magnitudes.iter().enumerate().map(|(k, &m)| mul_up(map.rad()[(row, k)], m));
            let sum = terms.fold(0.0, add_up);
            if !sum.is_finite() {
                return Err(SetError::Overflow { row });
            }
            spread.push(sum);
        }
        let mut image = self.clone();
        image.linear_map_in_place(map.mid(), workspace)?;
        image.body.shift(&vec![0.0; map.rows()], &spread)?;
        *self = image;
        Ok(())
    }
}
