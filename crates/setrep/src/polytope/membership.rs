//! Membership of points in the convex hull of points.

use scalars::Interval;

use super::cone::{Cone, Span, span};
use super::h_polytope::check_bounded;
use super::rows::Rows;
use super::{MAX_FACES, VPolytope};
use crate::{Membership, Part, SetError};

/// Corners of a box of points that are tested one by one.
const MAX_CORNERS: usize = 4096;

impl VPolytope {
    /// Whether a point, known to lie in a box `P`, lies in the set: inside if `P` is a subset, outside if a facet separates it.
    ///
    /// The corners of `P` are compared with the facets of `conv V`, whose signs there are exact. For many queries of one set,
    /// [`to_h_polytope`](Self::to_h_polytope) once and ask that: this enumerates the facets each time.
    ///
    /// **Guarantee:** both proofs hold for the exact set. For `r = 0` a point without width is always decided; otherwise points
    /// outside `conv V` are [`Undecided`](Membership::Undecided) until a half-space of the outward rounded set misses them.
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::UnboundedInterval`]; as [`to_h_polytope`](Self::to_h_polytope).
    pub fn membership(&self, point: &[Interval]) -> Result<Membership, SetError> {
        SetError::check_size(Part::Point, self.dim(), point.len())?;
        check_bounded(Part::Point, point)?;
        let wide = point.iter().filter(|side| side.lo() < side.hi()).count();
        if wide < MAX_CORNERS.ilog2() as usize {
            match self.compare_corners(&Self::from_intervals(point)?)? {
                Membership::Undecided => {}
                Membership::ProvenOutside if !self.is_exact() => {}
                verdict => return Ok(verdict),
            }
        }
        match self.to_h_polytope()?.membership(point)? {
            Membership::ProvenOutside => Ok(Membership::ProvenOutside),
            _ => Ok(Membership::Undecided),
        }
    }

    /// Whether the corners of a box lie in `conv V`: all of them, or none by one facet or one equation of the affine hull.
    fn compare_corners(&self, corners: &Self) -> Result<Membership, SetError> {
        let (n, count) = (self.dim(), self.num_vertices());
        let lift = |set: &Self| {
            set.vertices.columns().flat_map(|v| core::iter::once(1.0).chain(v.iter().copied())).collect::<Vec<f64>>()
        };
        let mut rows = Rows::new(n + 1, lift(self));
        let both = [lift(self), lift(corners)].concat();
        let mut queries = Rows::new(n + 1, both.clone());
        if let Span::Columns(columns) = span(&rows, None) {
            // A corner outside the affine hull raises the rank.
            let extended = match span(&queries, None) {
                Span::Full(_) => n + 1,
                Span::Columns(columns) => columns.len(),
            };
            if extended > columns.len() {
                let outside = corners.num_vertices() == 1;
                return Ok(if outside { Membership::ProvenOutside } else { Membership::Undecided });
            }
            rows = rows.select_columns(&columns);
            queries = queries.select_columns(&columns);
        }
        if rows.dim() == 1 {
            return Ok(Membership::ProvenInside);
        }
        let Span::Full(basis) = span(&rows, None) else { return Ok(Membership::Undecided) };
        let mut hull = Cone::enumerate_first(&queries, &basis, count, MAX_FACES)?;
        let mut verdict = Membership::ProvenInside;
        for ray in core::mem::take(&mut hull.live) {
            let signs =
                (count..queries.len()).map(|corner| hull.rays.value(&queries, &hull.slots, ray as usize, corner).sign);
            let below = signs.filter(|sign| sign.is_lt()).count();
            if below == corners.num_vertices() {
                return Ok(Membership::ProvenOutside);
            }
            if below > 0 {
                verdict = Membership::Undecided;
            }
        }
        Ok(verdict)
    }
}
