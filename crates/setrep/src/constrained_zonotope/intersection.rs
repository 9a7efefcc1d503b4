//! Intersection with strips, half-spaces, and with another set through a map.

use scalars::Interval;

use super::ConstrainedZonotope;
use super::rows::check_not_empty;
use crate::bounds::add_abs_row_sums;
use crate::ops::materialize::is_model_size;
use crate::{Matrix, Part, SetError, Workspace};

/// A remainder may widen a cut by this share of its width before it becomes generators.
const TOLERATED_WIDENING: f64 = 1e-6;

impl ConstrainedZonotope {
    /// Intersection with `{ x : C x in [d] }`, shapes `C: k x n`, `[d]: k` intervals, which may be unbounded on a side or both.
    ///
    /// Appends the rows `C G` with the ranges `[d] - C c +- |C| r`: no generators. `C (c + G xi) = C x - C e` makes that a superset,
    /// which also lies in `{ x in X : C x in [d] +- 2 |C| r }`; a component of `r` that would widen a cut by more than `1e-6` of
    /// its width becomes a generator first, and takes part exactly. The rounding of a row widens its range.
    ///
    /// **Guarantee:** superset of the exact intersection.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in `C`, [`SetError::EmptyInterval`], [`SetError::Overflow`]; the set is then
    /// unchanged.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{ConstrainedZonotope, Matrix, Workspace};
    /// let mut set = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0], &[1.0, -1.0]])?;
    /// set.intersect_rows(&rows, &[Interval::point(0.5), Interval::point(0.0).inflate(0.25)], &mut Workspace::new())?;
    /// assert_eq!((set.num_generators(), set.num_constraints()), (2, 2));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn intersect_rows(
        &mut self,
        rows: &Matrix,
        ranges: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_size(Part::Constraints, self.dim(), rows.cols())?;
        SetError::check_size(Part::Range, rows.rows(), ranges.len())?;
        SetError::check_finite(Part::Constraints, rows.rows(), rows.as_slice())?;
        ranges.iter().enumerate().try_for_each(|(row, range)| check_not_empty(row, range))?;
        self.cut(rows, ranges, |i| ranges[i].width(), None, workspace)
    }

    /// Intersection with the strip `{ x : a'x in [d] }`: [`intersect_rows`](Self::intersect_rows) with one row.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows).
    pub fn intersect_strip(
        &mut self,
        direction: &[f64],
        range: Interval,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_size(Part::Direction, self.dim(), direction.len())?;
        let row = Matrix::from_column_slice(1, direction.len(), direction)?;
        self.intersect_rows(&row, &[range], workspace)
    }

    /// Intersection with the half-space `{ x : a'x <= b }`: [`intersect_rows`](Self::intersect_rows) with a one-sided row.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows); [`SetError::NonFinite`] for `b`.
    pub fn intersect_half_space(
        &mut self,
        normal: &[f64],
        offset: f64,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        SetError::check_finite(Part::Range, 1, &[offset])?;
        let range = Interval::new(f64::NEG_INFINITY, offset).unwrap_or(Interval::ENTIRE);
        self.intersect_strip(normal, range, workspace)
    }

    /// Generalised intersection `{ x in X : R x in Y }`, shapes `R: p x n`, `Y` in dimension `p`.
    ///
    /// For `Y = <d, H, s; B, [b]>` the columns are `(xi, eta)`, the rows `A`, `B` and `[R G  -H]` with the ranges
    /// `d - R c +- (s + |R| r)`. As in [`intersect_rows`](Self::intersect_rows), components of `r` of model size become generators
    /// first; `s` need not.
    ///
    /// **Guarantee:** superset of the exact intersection.
    /// **Source:** Scott, Raimondo, Marseglia, Braatz 2016, Proposition 1 (in paper 003, equation (12), a block row is missing).
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in `R`, [`SetError::Overflow`]; the set is then unchanged.
    pub fn intersect(&mut self, map: &Matrix, other: &Self, workspace: &mut Workspace) -> Result<(), SetError> {
        SetError::check_size(Part::Map, self.dim(), map.cols())?;
        SetError::check_size(Part::Map, other.dim(), map.rows())?;
        SetError::check_finite(Part::Map, map.rows(), map.as_slice())?;
        let (mut ranges, mut extents) =
            (core::mem::take(&mut workspace.offsets), core::mem::take(&mut workspace.remainder));
        ranges.clear();
        ranges.extend(other.center().iter().zip(other.remainder()).map(|(&d, &s)| Interval::point(d).inflate(s)));
        extents.clear();
        extents.resize(other.dim(), 0.0);
        add_abs_row_sums(other.generators().as_slice(), &mut extents);
        let width = |i: usize| 2.0 * (extents[i] + other.remainder()[i]);
        let result = self.cut(map, &ranges, width, Some(other), workspace);
        (workspace.offsets, workspace.remainder) = (ranges, extents);
        result
    }

    /// Appends the rows `[C G  -H]` in `[d] - C c +- |C| r`, and before them the generators and constraints of `other`, whose
    /// generators are `H`. `width` is the width of a cut by which `r` is judged.
    fn cut(
        &mut self,
        rows: &Matrix,
        ranges: &[Interval],
        width: impl Fn(usize) -> f64,
        other: Option<&Self>,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let columns = self.num_generators();
        self.materialize_for(rows, width, workspace);
        if let Err(error) = self.form_rows(rows, ranges, other, workspace) {
            self.dematerialize(columns);
            return Err(error);
        }
        let (columns, count) = (self.num_generators(), rows.rows());
        if let Some(other) = other {
            self.body.generators.push_zero_cols(other.num_generators());
            self.append_constraints(other);
        }
        let first = self.ranges.len();
        self.constraints.push_zero_rows(count);
        for (i, row) in workspace.matrix.chunks_exact(columns.max(1)).enumerate() {
            for (j, &x) in row.iter().enumerate() {
                self.constraints.col_mut(j)[first + i] = x;
            }
        }
        if let Some(other) = other {
            for j in 0..other.num_generators() {
                let target = &mut self.constraints.col_mut(columns + j)[first..];
                target.iter_mut().zip(other.generators().col(j)).for_each(|(x, h)| *x = -h);
            }
        }
        self.ranges.extend_from_slice(&workspace.ranges);
        Ok(())
    }

    /// Computes the rows `C G` (row by row, `workspace.matrix`) and their ranges (`workspace.ranges`).
    fn form_rows(
        &self,
        rows: &Matrix,
        ranges: &[Interval],
        other: Option<&Self>,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let columns = self.num_generators();
        let Workspace { matrix, ranges: formed, objective: coefficients, .. } = workspace;
        matrix.clear();
        matrix.resize(rows.rows() * columns, 0.0);
        formed.clear();
        for (i, range) in ranges.iter().enumerate() {
            coefficients.clear();
            coefficients.extend((0..rows.cols()).map(|k| rows.col(k)[i]));
            let row = &mut matrix[i * columns..(i + 1) * columns];
            let (mut norm, mut entries) = (0.0, 0);
            if let Some(other) = other {
                entries = other.num_generators();
                norm = (0..entries).map(|j| other.generators().col(j)[i].abs()).sum();
            }
            let range = self.form_row(coefficients, *range, row, norm, entries);
            formed.push(range.ok_or(SetError::Overflow { row: i })?);
        }
        Ok(())
    }

    /// Turns the components of the remainder that would widen one of the cuts visibly into generators.
    fn materialize_for(&mut self, rows: &Matrix, width: impl Fn(usize) -> f64, workspace: &mut Workspace) {
        let extents = &mut workspace.row_sums;
        extents.clear();
        extents.resize(self.dim(), 0.0);
        add_abs_row_sums(self.generators().as_slice(), extents);
        let reach = |i: usize| -> f64 {
            (0..extents.len()).map(|k| rows.col(k)[i].abs() * (extents[k] + self.remainder()[k])).sum()
        };
        let tolerances = &mut workspace.scales;
        tolerances.clear();
        tolerances.extend((0..rows.rows()).map(|i| TOLERATED_WIDENING * width(i).min(reach(i))));
        for k in 0..self.dim() {
            let r = self.remainder()[k];
            let widens = || rows.col(k).iter().zip(tolerances.iter()).any(|(c, tolerance)| c.abs() * r > *tolerance);
            if is_model_size(r, extents[k], self.center()[k]) && widens() {
                self.body.generators.push_axis(k, r);
                self.body.remainder[k] = 0.0;
            }
        }
        self.pad_constraints();
    }

    /// Turns the generators from `columns` on, each along an axis, back into the remainder.
    fn dematerialize(&mut self, columns: usize) {
        for j in columns..self.num_generators() {
            for (r, g) in self.body.remainder.iter_mut().zip(self.body.generators.col(j)) {
                *r += g;
            }
        }
        self.body.generators.truncate_cols(columns);
        self.constraints.truncate_cols(columns);
    }
}
