//! Intersection with strips, half-spaces and polytopes: each becomes a parallelotope around what it leaves.

use scalars::Interval;
use scalars::rounding::add_up;

use super::ZonotopeBundle;
use crate::strip::{ranges_below, rows_of};
use crate::{HPolytope, Matrix, Part, SetError, Strip, Workspace, Zonotope};

impl ZonotopeBundle {
    /// Intersection with `{ x : C x in [d] }`, shapes `C: k x n`, `[d]: k` intervals, which may be unbounded on a side or both.
    ///
    /// For each row `a` that cuts, a member is appended: the parallelotope of the points with `a'x` in `[d]`, cut to the set's supports
    /// along `a`, and `x_j` in the set's interval hull for all `j` but one. It lies in the strip and holds what the strip leaves of
    /// the set, so nothing is lost. A row that is proven not to cut appends nothing.
    ///
    /// **Guarantee:** superset of the exact intersection; the same set but for rounding.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in `C`, [`SetError::EmptyInterval`], [`SetError::TooLarge`],
    /// [`SetError::Overflow`]; the set is then unchanged.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{Matrix, Workspace, Zonotope, ZonotopeBundle};
    /// let mut set = ZonotopeBundle::from(Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?);
    /// let rows = Matrix::from_rows(&[&[1.0, 2.0], &[1.0, 1.0]])?;
    /// let mut workspace = Workspace::new();
    /// set.intersect_rows(&rows, &[Interval::point(1.0).inflate(0.5), Interval::point(0.0).inflate(9.0)], &mut workspace)?;
    /// assert_eq!(set.num_members(), 2);
    /// let hull = set.interval_hull(&mut workspace)?;
    /// assert!(hull[1].contains(-0.25) && !hull[1].contains(-0.251));
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
        if let Some(row) = ranges.iter().position(Interval::is_empty) {
            return Err(SetError::EmptyInterval { part: Part::Range, row });
        }
        let hull = self.interval_hull(workspace)?;
        if hull.iter().any(Interval::is_empty) {
            return Ok(());
        }
        if let Some(row) = hull.iter().position(|side| !side.is_bounded()) {
            return Err(SetError::Overflow { row });
        }
        let mut cuts = Vec::new();
        for (i, &range) in ranges.iter().enumerate() {
            let a: Vec<f64> = rows.columns().map(|column| column[i]).collect();
            let opposite: Vec<f64> = a.iter().map(|a| -a).collect();
            let (low, high) = (-self.support(&opposite, workspace)?, self.support(&a, workspace)?);
            // Bounds that contradict each other prove the set empty: so is what is left.
            let Ok(reach) = Interval::new(low, high) else { return Ok(()) };
            if !reach.subset_of(&range) {
                cuts.push(parallelotope(&a, near(range, reach), &hull).ok_or(SetError::Overflow { row: i })?);
            }
        }
        self.members.append(&mut cuts);
        Ok(())
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
        self.intersect_strips(&[Strip::new(direction, range)?], workspace)
    }

    /// Intersection with the half-space `{ x : a'x <= b }`: [`intersect_rows`](Self::intersect_rows) with a one-sided row.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows).
    pub fn intersect_half_space(
        &mut self,
        normal: &[f64],
        offset: f64,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        self.intersect_strips(&[crate::HalfSpace::new(normal, offset)?.into()], workspace)
    }

    /// Intersection with strips: [`intersect_rows`](Self::intersect_rows) with their directions and ranges. Half-spaces are strips by
    /// `into`.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows).
    pub fn intersect_strips(&mut self, strips: &[Strip], workspace: &mut Workspace) -> Result<(), SetError> {
        let (rows, ranges) = rows_of(strips, self.dim())?;
        self.intersect_rows(&rows, &ranges, workspace)
    }

    /// Intersection with a polytope, `{ x in X : H x <= h }`: [`intersect_rows`](Self::intersect_rows) with one-sided rows.
    ///
    /// # Errors
    /// As [`intersect_rows`](Self::intersect_rows).
    pub fn intersect_h_polytope(&mut self, polytope: &HPolytope, workspace: &mut Workspace) -> Result<(), SetError> {
        SetError::check_size(Part::Normals, self.dim(), polytope.dim())?;
        self.intersect_rows(polytope.normals(), &ranges_below(polytope.offsets()), workspace)
    }
}

/// The part of a range within reach, or its end nearest to it.
fn near(range: Interval, reach: Interval) -> Interval {
    let within = range.intersection(reach);
    if !within.is_empty() {
        return within;
    }
    Interval::point(if range.lo() > reach.hi() { range.lo() } else { range.hi() })
}

/// `{ x : a'x in [d], x_j in [h_j] for j != k }`, for the `k` that matters most to `a'x`; a point outside the hull if `a` is zero,
/// when `[d]` does not hold zero. `None` if something overflows.
///
/// `x_k = (a'x - sum_j a_j x_j) / a_k`: with midpoints and radii in place of `a'x` and `x_j`, the center and the generators.
fn parallelotope(a: &[f64], range: Interval, hull: &[Interval]) -> Option<Zonotope> {
    let n = a.len();
    let share = |k: &usize| a[*k].abs() * hull[*k].rad();
    let order = |j: &usize, k: &usize| share(j).total_cmp(&share(k)).then(a[*j].abs().total_cmp(&a[*k].abs()));
    let k = (0..n).max_by(order)?;
    let mut center: Vec<f64> = hull.iter().map(Interval::mid).collect();
    if a[k] == 0.0 {
        center[0] = add_up(hull[0].hi(), 1.0 + hull[0].mag());
        return Zonotope::point(&center).ok();
    }
    let by_pivot = |x: Interval| x / Interval::point(a[k]);
    let (mut generators, mut remainder) = (Matrix::zeros(n, 0), vec![0.0; n]);
    let mut rest = Interval::point(range.mid());
    for j in (0..n).filter(|&j| j != k) {
        rest -= Interval::point(a[j]) * Interval::point(center[j]);
        if hull[j].rad() > 0.0 {
            let entry = by_pivot(Interval::point(-a[j]) * Interval::point(hull[j].rad()));
            generators.push_axis(j, hull[j].rad());
            generators.col_mut(generators.cols() - 1)[k] = entry.mid();
            remainder[k] = add_up(remainder[k], entry.rad());
        }
    }
    let (place, width) = (by_pivot(rest), by_pivot(Interval::point(range.rad())));
    center[k] = place.mid();
    remainder[k] = add_up(remainder[k], add_up(place.rad(), width.rad()));
    if width.mid() != 0.0 {
        generators.push_axis(k, width.mid());
    }
    Zonotope::with_remainder(&center, &generators, &remainder).ok()
}
