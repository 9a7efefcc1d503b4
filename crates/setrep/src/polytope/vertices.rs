//! From half-spaces to vertices.

use scalars::rounding::{ETA, up};

use super::cone::{Cone, Span, span};
use super::exact::{quotient, scale_by_power};
use super::incidence::{BitSets, is_subset, iter};
use super::rows::Rows;
use super::solve::{Solver, pivots};
use super::{HPolytope, MAX_FACES, VPolytope};
use crate::{IntervalVector, Matrix, SetError};

/// Vertices enclosed less tightly than this share of the set's extent in a coordinate are computed in integers.
const FINE: f64 = 4.0 * f64::EPSILON;

/// The vertices of a bounded, nonempty `{ x : H x <= h }`, with exact combinatorics.
pub(super) struct Vertices {
    /// Midpoints of the enclosures, one column a vertex.
    pub(super) mids: Matrix,
    /// Radii of the enclosures.
    pub(super) radii: Matrix,
    /// The rows at each vertex, as members of `rows`.
    pub(super) incidence: BitSets,
    /// The rows of `H` that the incidence speaks of, by member (`None` is no row of `H`). The others are redundant.
    pub(super) rows: Vec<Option<usize>>,
}

/// The cone over `{ x : H x <= h }`: row 0 is `t >= 0`, row `i + 1` is `h_i t - H_i x >= 0`.
fn homogenise(polytope: &HPolytope) -> Rows<'static> {
    let n = polytope.dim();
    let mut source = Vec::with_capacity((n + 1) * (polytope.num_half_spaces() + 1));
    source.push(1.0);
    source.resize(n + 1, 0.0);
    for (i, &offset) in polytope.offsets.iter().enumerate() {
        source.push(offset);
        source.extend(polytope.normal(i).map(|a| -a));
    }
    Rows::new(n + 1, source)
}

/// Whether the cone of `t >= 0` and rows that do not span has a ray with `t > 0`.
fn reaches_up(rows: &Rows<'_>, columns: &[usize], max_rays: usize) -> Result<bool, SetError> {
    let rows = rows.select_columns(columns);
    if rows.dim() == 1 {
        return Ok((0..rows.len()).all(|i| rows.row(i)[0] >= 0.0));
    }
    match span(&rows, Some(0)) {
        Span::Full(basis) => {
            let mut cone = Cone::enumerate(&rows, &basis, max_rays)?;
            let live = core::mem::take(&mut cone.live);
            Ok(live.iter().any(|&ray| cone.rays.value(&rows, &cone.slots, ray as usize, 0).sign.is_gt()))
        }
        // Not reached: the chosen columns are independent.
        Span::Columns(_) => Ok(true),
    }
}

impl Vertices {
    /// Enumerates the vertices.
    ///
    /// # Errors
    /// [`SetError::EmptySet`], [`SetError::Unbounded`], [`SetError::OverBudget`], [`SetError::Overflow`].
    pub(super) fn enumerate(polytope: &HPolytope, max_vertices: usize) -> Result<Self, SetError> {
        let rows = homogenise(polytope);
        let basis = match span(&rows, Some(0)) {
            Span::Full(basis) => basis,
            // The set holds a whole line through each of its points.
            Span::Columns(columns) => {
                return Err(if reaches_up(&rows, &columns, max_vertices)? {
                    SetError::Unbounded
                } else {
                    SetError::EmptySet
                });
            }
        };
        let mut cone = Cone::enumerate(&rows, &basis, max_vertices)?;
        let live = core::mem::take(&mut cone.live);
        let heights: Vec<_> =
            live.iter().map(|&ray| cone.rays.value(&rows, &cone.slots, ray as usize, 0).sign).collect();
        if heights.iter().all(|height| height.is_le()) {
            return Err(SetError::EmptySet);
        }
        if heights.iter().any(|height| height.is_eq()) {
            return Err(SetError::Unbounded);
        }
        let mut vertices = Self {
            mids: Matrix::zeros(polytope.dim(), live.len()),
            radii: Matrix::zeros(polytope.dim(), live.len()),
            incidence: BitSets::new(live.len(), cone.slots.len()),
            rows: cone.slots.iter().map(|&row| (row as usize).checked_sub(1)).collect(),
        };
        for (j, &ray) in live.iter().enumerate() {
            for slot in iter(cone.rays.tight.get(ray as usize)) {
                vertices.incidence.insert(j, slot);
            }
        }
        vertices.locate(&rows, &mut cone, &live)?;
        Ok(vertices)
    }

    /// Encloses each vertex: by a verified solve of `n` of its equations, in integers where that is not tight.
    fn locate(&mut self, rows: &Rows<'_>, cone: &mut Cone<'_>, live: &[u32]) -> Result<(), SetError> {
        let n = self.mids.rows();
        let mut solver = Solver::default();
        let mut extent = vec![0.0_f64; n];
        let mut loose = Vec::new();
        for j in 0..live.len() {
            if self.solve(j, rows, cone, &mut solver) {
                for (extent, x) in extent.iter_mut().zip(self.mids.col(j)) {
                    *extent = extent.max(x.abs());
                }
            } else {
                self.radii.col_mut(j).fill(f64::INFINITY);
            }
        }
        for j in 0..live.len() {
            if self.radii.col(j).iter().zip(&extent).any(|(&r, &x)| r > FINE * x) {
                loose.push(j);
            }
        }
        for j in loose {
            let ray = live[j] as usize;
            cone.rays.make_exact(rows, &cone.slots, ray);
            let Some(y) = cone.rays.integers(ray) else { return Err(SetError::Overflow { row: 0 }) };
            for k in 0..n {
                let exponent = rows.column_exponent(k + 1) - rows.column_exponent(0);
                (self.mids[(k, j)], self.radii[(k, j)]) = quotient(&y[k + 1], &y[0], i64::from(exponent));
            }
        }
        for k in 0..n {
            for j in 0..live.len() {
                if !(self.mids[(k, j)].is_finite() && self.radii[(k, j)].is_finite()) {
                    return Err(SetError::Overflow { row: k });
                }
            }
        }
        Ok(())
    }

    /// Solves for vertex `j` in floating point; false where no error bound could be proven.
    fn solve(&mut self, j: usize, rows: &Rows<'_>, cone: &Cone<'_>, solver: &mut Solver) -> bool {
        let n = self.mids.rows();
        if rows.has_underflow() {
            return false;
        }
        let tight: Vec<usize> = iter(self.incidence.get(j)).map(|slot| cone.slots[slot] as usize).collect();
        let matrix: Vec<f64> = tight.iter().flat_map(|&row| &rows.row(row)[1..]).copied().collect();
        let Some((order, _)) = pivots(&mut matrix.clone(), n, n) else { return false };
        let square: Vec<f64> = order[..n].iter().flat_map(|&i| &matrix[i * n..(i + 1) * n]).copied().collect();
        let rhs: Vec<f64> = order[..n].iter().map(|&i| -rows.row(tight[i])[0]).collect();
        if !solver.solve(n, &square, &rhs) {
            return false;
        }
        for k in 0..n {
            let exponent = i64::from(rows.column_exponent(k + 1) - rows.column_exponent(0));
            let mid = scale_by_power(solver.solution[k], exponent);
            let radius = scale_by_power(solver.radius[k], exponent);
            // Scaling is exact outside the subnormal range.
            let exact = mid == 0.0 && solver.solution[k] == 0.0 || mid.is_normal();
            self.mids[(k, j)] = mid;
            self.radii[(k, j)] = if exact && solver.radius[k] == 0.0 { 0.0 } else { up(radius) + 2.0 * ETA };
        }
        true
    }

    /// The enclosure of each vertex.
    pub(super) fn boxes(&self) -> Result<Vec<IntervalVector>, SetError> {
        self.mids
            .columns()
            .zip(self.radii.columns())
            .map(|(mid, radius)| IntervalVector::from_center(mid, radius))
            .collect()
    }

    /// The vertices at each row, and whether the set has interior points.
    pub(super) fn faces(&self) -> (BitSets, bool) {
        let faces = self.incidence.transpose(self.rows.len());
        let vertices = self.mids.cols() as u32;
        let full = (0..faces.len()).all(|i| super::incidence::count(faces.get(i)) < vertices);
        (faces, full)
    }

    /// The members of `rows` that are facets of a set with interior points: their faces lie in no other.
    pub(super) fn facets(&self, faces: &BitSets) -> Vec<usize> {
        let is_facet = |&i: &usize| {
            self.rows[i].is_some()
                && (0..faces.len())
                    .all(|k| k == i || !is_subset(faces.get(i), faces.get(k)) || faces.get(i) == faces.get(k) && i < k)
        };
        (0..faces.len()).filter(is_facet).collect()
    }

    /// The vertex form: midpoints, and the largest radii as the remainder.
    fn into_v_polytope(self) -> Result<VPolytope, SetError> {
        let largest = |k: usize| (0..self.radii.cols()).map(|j| self.radii[(k, j)]).fold(0.0, f64::max);
        let remainder: Vec<f64> = (0..self.radii.rows()).map(largest).collect();
        VPolytope::with_remainder(self.mids, &remainder)
    }
}

impl HPolytope {
    /// The set in vertex form, at most [`MAX_FACES`] vertices at every stage: `conv V + [-r, r]`, each exact vertex within `r` of its
    /// column of `V`.
    ///
    /// A vertex is enclosed by a verified solve of its equations, or rounded from its exact rational value where that is not tight to
    /// some ulps; `r = 0` if every vertex is a float.
    ///
    /// **Guarantee:** superset. There is one column for each vertex of the exact set: none missing, none twice.
    ///
    /// # Errors
    /// [`SetError::EmptySet`], proven; [`SetError::Unbounded`], proven; [`SetError::OverBudget`]; [`SetError::Overflow`] for vertices
    /// beyond the range of floats.
    pub fn to_v_polytope(&self) -> Result<VPolytope, SetError> {
        self.to_v_polytope_within(MAX_FACES)
    }

    /// [`to_v_polytope`](Self::to_v_polytope) with a limit on the number of vertices at every stage of the construction.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    pub fn to_v_polytope_within(&self, max_vertices: usize) -> Result<VPolytope, SetError> {
        Vertices::enumerate(self, max_vertices)?.into_v_polytope()
    }

    /// The same set without redundant half-spaces, those proven to cut off nothing.
    ///
    /// **Guarantee:** exact. Irredundant if the set has interior points; of a flat set the rows that only repeat each other's
    /// equations may stay.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    pub fn remove_redundant(&self) -> Result<Self, SetError> {
        let vertices = Vertices::enumerate(self, MAX_FACES)?;
        let (faces, full) = vertices.faces();
        let members = if full { vertices.facets(&faces) } else { (0..vertices.rows.len()).collect() };
        let mut rows: Vec<usize> = members.into_iter().filter_map(|member| vertices.rows[member]).collect();
        rows.sort_unstable();
        Ok(self.select(&rows))
    }

    /// The smallest box that contains the set, from its vertices.
    ///
    /// **Guarantee:** superset, off by rounding only.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    pub fn interval_hull(&self) -> Result<IntervalVector, SetError> {
        Ok(self.to_v_polytope()?.interval_hull())
    }
}
