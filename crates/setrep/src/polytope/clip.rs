//! A hull of points cut by half-spaces, vertices to vertices.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::cone::Cone;
use super::exact::{quotient, scale_by_power};
use super::facets::{Facets, Quality};
use super::rows::{FacetRows, Rows};
use super::{HPolytope, MAX_FACES, VPolytope};
use crate::bounds::add_lengths;
use crate::{Matrix, Part, SetError};

/// New vertices enclosed less tightly than this share of the set's extent in a coordinate are computed in integers.
const FINE: f64 = 64.0 * f64::EPSILON;

impl VPolytope {
    /// Intersection with half-spaces, `{ x in X : H x <= h }`, in vertex form; at most [`MAX_FACES`] faces at every stage.
    ///
    /// Vertices that fulfil the half-spaces stay as they are; each edge of `conv V` that one of them cuts gives a new vertex, rounded, and
    /// the largest rounding error joins the remainder. With a remainder `r` the half-spaces are moved out by `|H| r` first:
    /// `(P + [-r, r]) & {H x <= h}` lies in `(P & {H x <= h + |H| r}) + [-r, r]`.
    ///
    /// The edges come from the exact facets of the hull, so a vertex where many of them meet stays one vertex; the way through
    /// [`to_h_polytope`](Self::to_h_polytope) rounds the normals and splits it. Flat sets go that way.
    ///
    /// **Guarantee:** superset of the exact intersection, exact but for the remainder if `r = 0`. Redundant columns are dropped.
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::EmptySet`], proven; [`SetError::OverBudget`]; [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{HPolytope, Matrix, VPolytope};
    /// let triangle = VPolytope::new(Matrix::from_columns(&[&[0.0, 0.0], &[1.0, 0.0], &[0.0, 1.0]])?)?;
    /// let left = HPolytope::new(Matrix::from_rows(&[&[1.0, 0.0]])?, &[0.5])?;
    /// assert_eq!(triangle.intersection(&left)?.num_vertices(), 4);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn intersection(&self, half_spaces: &HPolytope) -> Result<Self, SetError> {
        self.intersection_within(half_spaces, MAX_FACES)
    }

    /// [`intersection`](Self::intersection) with a limit on the number of faces at every stage of the construction.
    ///
    /// # Errors
    /// As [`intersection`](Self::intersection).
    pub fn intersection_within(&self, half_spaces: &HPolytope, max_faces: usize) -> Result<Self, SetError> {
        let n = self.dim();
        SetError::check_size(Part::Normals, n, half_spaces.dim())?;
        let facets = Facets::enumerate(&self.vertices, vec![0.0; n], max_faces, Quality::Incidence)?;
        if facets.coordinates.len() < n {
            let all = self.to_h_polytope_within(max_faces)?.intersection(half_spaces)?;
            return all.to_v_polytope_within(max_faces);
        }
        let mut cuts = Vec::with_capacity((n + 1) * half_spaces.num_half_spaces());
        for (i, &offset) in half_spaces.offsets.iter().enumerate() {
            let reach =
                half_spaces.normal(i).zip(&self.remainder).map(|(a, &r)| mul_up(a.abs(), r)).fold(0.0, add_lengths);
            let moved = if reach == 0.0 { offset } else { add_up(offset, reach) };
            if !moved.is_finite() {
                return Err(SetError::Overflow { row: i });
            }
            cuts.push(moved);
            cuts.extend(half_spaces.normal(i).map(|a| -a));
        }
        let extreme = facets.extreme_members();
        let facets = FacetRows { points: facets.rows, incidence: facets.incidence, columns: facets.points };
        let rows = Rows::of_facets(&facets, &cuts);
        let mut cone = Cone::cut(&rows, &facets, &extreme, max_faces)?;
        if cone.live.is_empty() {
            return Err(SetError::EmptySet);
        }
        self.locate(&rows, &facets, &extreme, &mut cone)
    }

    /// The vertices that are left and the new ones, with their remainder.
    fn locate(
        &self,
        rows: &Rows<'_>,
        facets: &FacetRows,
        extreme: &[usize],
        cone: &mut Cone<'_>,
    ) -> Result<Self, SetError> {
        let n = self.dim();
        let hull = self.interval_hull();
        let exponents: Vec<i64> = (0..n).map(|k| -i64::from(facets.points.column_exponent(k + 1))).collect();
        let mut vertices = Matrix::zeros(n, 0);
        let mut lost = vec![0.0_f64; n];
        for ray in core::mem::take(&mut cone.live) {
            let ray = ray as usize;
            // A slot may have been used again: the integers tell.
            let kept = extreme.get(ray).map(|&k| facets.columns[k]).filter(|&column| {
                cone.rays.integers(ray).is_some_and(|integers| *integers == *facets.points.integers(column).entries)
            });
            if let Some(column) = kept {
                vertices.push_col(self.vertices.col(column))?;
                continue;
            }
            let (mut mids, mut radii) = enclosure(cone.rays.center(ray), cone.rays.error(ray), &exponents);
            if !radii.iter().zip(hull.iter()).all(|(&r, side)| r <= FINE * side.mag()) {
                cone.rays.make_exact(rows, &cone.slots, ray);
                if let Some(y) = cone.rays.integers(ray) {
                    (mids, radii) = (0..n).map(|k| quotient(&y[k + 1], &y[0], exponents[k])).unzip();
                }
            }
            for k in 0..n {
                if !(mids[k].is_finite() && radii[k].is_finite()) {
                    return Err(SetError::Overflow { row: k });
                }
                lost[k] = lost[k].max(radii[k]);
            }
            vertices.push_col(&mids)?;
        }
        let remainder: Vec<f64> = self.remainder.iter().zip(&lost).map(|(&r, &lost)| add_lengths(r, lost)).collect();
        Self::with_remainder(vertices, &remainder)
    }
}

/// Midpoints and radii of `y_k / y_0 2^(e_k)` for a ray within `error` of its floats.
fn enclosure(center: &[f64], error: f64, exponents: &[i64]) -> (Vec<f64>, Vec<f64>) {
    let height = Interval::point(center[0]).inflate(error);
    center[1..]
        .iter()
        .zip(exponents)
        .map(|(&y, &e)| {
            let ratio = Interval::point(y).inflate(error) / height;
            let (mid, rad) = (scale_by_power(ratio.mid(), e), scale_by_power(ratio.rad(), e));
            // Two roundings where the results are subnormal.
            (mid, if rad == 0.0 && (mid.is_normal() || y == 0.0) { 0.0 } else { rad + 2.0 * scalars::rounding::ETA })
        })
        .unzip()
}
