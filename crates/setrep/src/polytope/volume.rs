//! Volumes, by a triangulation that needs no coordinates.
//!
//! A face is the union of the pyramids from its first vertex over those of its own faces (one dimension less) that miss this vertex;
//! down to simplices. Which vertices lie on which face is known exactly, so the simplices cover the set exactly once, and rounding
//! enters only through `|det| / n!` of each, which is computed in interval arithmetic.
//!
//! **Source:** Cohen, Hickey, *Two algorithms for determining volumes of convex polyhedra* (1979); Bueler, Enge, Fukuda, *Exact volume
//! computation for polytopes* (2000), section 3.

use scalars::Interval;

use super::facets::{Facets, Quality, exact_shift};
use super::incidence::{BitSets, contains, count, is_subset, iter};
use super::vertices::Vertices;
use super::{HPolytope, MAX_FACES, VPolytope};
use crate::SetError;

/// Simplices of a triangulation before a volume is refused.
const MAX_SIMPLICES: usize = 20_000_000;

/// Determinants of edge vectors, one row at a time, shared by all simplices that begin with the same vertices.
struct Triangulation<'a> {
    dim: usize,
    vertices: &'a [Vec<Interval>],
    origin: usize,
    /// Reduced rows with their pivot columns, and the product of the pivots up to each.
    rows: Vec<(Vec<Interval>, Option<usize>, Interval)>,
    sum: Interval,
    simplices: usize,
}

impl Triangulation<'_> {
    /// Adds the edge from the origin to a vertex.
    fn push(&mut self, vertex: usize) {
        let mut row: Vec<Interval> =
            self.vertices[vertex].iter().zip(&self.vertices[self.origin]).map(|(x, o)| *x - *o).collect();
        let (mut product, mut certain) = (Interval::ONE, true);
        for (reduced, pivot, so_far) in &self.rows {
            product = *so_far;
            let Some(pivot) = *pivot else {
                certain = false;
                continue;
            };
            let factor = row[pivot] / reduced[pivot];
            for (x, r) in row.iter_mut().zip(reduced) {
                *x -= factor * *r;
            }
            row[pivot] = Interval::ZERO;
        }
        let best = (0..self.dim).max_by(|&i, &j| row[i].mig().total_cmp(&row[j].mig())).unwrap_or(0);
        if certain && row[best].mig() > 0.0 {
            product *= row[best];
            self.rows.push((row, Some(best), product));
        } else {
            // No pivot is known to differ from zero: Hadamard's bound of what is left, |det| <= product of the 1-norms.
            let norm = row.iter().fold(Interval::ZERO, |sum, x| sum + x.abs());
            let bound = norm.mag() + f64::MIN_POSITIVE;
            product *= Interval::point(bound).hull(Interval::point(-bound));
            self.rows.push((row, None, product));
        }
    }

    /// Sums up a face: its vertices, its facets (as vertex sets), its dimension.
    fn face(&mut self, set: &[u64], facets: &[Vec<u64>], dim: usize) -> Result<(), SetError> {
        let depth = self.rows.len();
        if count(set) as usize == dim + 1 {
            for vertex in iter(set) {
                self.push(vertex);
            }
            if let Some((_, _, det)) = self.rows.last() {
                self.sum += det.abs();
            }
            self.simplices += 1;
            self.rows.truncate(depth);
            return if self.simplices > MAX_SIMPLICES {
                Err(SetError::OverBudget { count: self.simplices, limit: MAX_SIMPLICES })
            } else {
                Ok(())
            };
        }
        let Some(apex) = iter(set).next() else { return Ok(()) };
        self.push(apex);
        self.pyramids(apex, facets, dim)?;
        self.rows.truncate(depth);
        Ok(())
    }

    /// The pyramids over the facets that miss the apex.
    fn pyramids(&mut self, apex: usize, facets: &[Vec<u64>], dim: usize) -> Result<(), SetError> {
        for (i, facet) in facets.iter().enumerate().filter(|(_, facet)| !contains(facet, apex)) {
            let ridges = if count(facet) as usize == dim { Vec::new() } else { ridges_of(i, facets, dim) };
            self.face(facet, &ridges, dim - 1)?;
        }
        Ok(())
    }
}

/// The facets of facet `i`: the largest of its intersections with the others.
fn ridges_of(i: usize, facets: &[Vec<u64>], dim: usize) -> Vec<Vec<u64>> {
    let meet = |other: &Vec<u64>| other.iter().zip(&facets[i]).map(|(a, b)| a & b).collect::<Vec<u64>>();
    let mut ridges: Vec<Vec<u64>> =
        facets.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, other)| meet(other)).collect();
    ridges.retain(|ridge| count(ridge) as usize + 1 >= dim);
    ridges.sort_unstable_by_key(|ridge| core::cmp::Reverse(count(ridge)));
    let mut largest: Vec<Vec<u64>> = Vec::new();
    for ridge in ridges {
        if !largest.iter().any(|other| is_subset(&ridge, other)) {
            largest.push(ridge);
        }
    }
    largest
}

/// Volume of a polytope with interior points from its facets as sets of vertices, and enclosures of the vertices.
fn volume_of(dim: usize, facets: &BitSets, chosen: &[usize], vertices: &[Vec<Interval>]) -> Result<Interval, SetError> {
    let facets: Vec<Vec<u64>> = chosen.iter().map(|&i| facets.get(i).to_vec()).collect();
    let Some(origin) = facets.iter().flat_map(|facet| iter(facet)).min() else { return Ok(Interval::ZERO) };
    let mut triangulation =
        Triangulation { dim, vertices, origin, rows: Vec::with_capacity(dim), sum: Interval::ZERO, simplices: 0 };
    triangulation.pyramids(origin, &facets, dim)?;
    let factorial = (1..=dim).fold(Interval::ONE, |product, k| product.scale(k as f64));
    Ok(triangulation.sum / factorial)
}

impl HPolytope {
    /// The volume (area for `n = 2`, length for `n = 1`) of a bounded set; zero for a flat one.
    ///
    /// **Guarantee:** an enclosure of the exact volume.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope); [`SetError::OverBudget`] for too many simplices.
    ///
    /// ```
    /// # use setrep::{HPolytope, IntervalVector};
    /// let cube = HPolytope::from_intervals(&IntervalVector::from_center(&[0.0; 3], &[1.0; 3])?)?;
    /// assert!(cube.volume()?.contains(8.0));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn volume(&self) -> Result<Interval, SetError> {
        let vertices = Vertices::enumerate(self, MAX_FACES)?;
        let (faces, full) = vertices.faces();
        if !full {
            return Ok(Interval::ZERO);
        }
        let boxes: Vec<Vec<Interval>> = vertices.boxes()?.iter().map(|sides| sides.to_vec()).collect();
        volume_of(self.dim(), &faces, &vertices.facets(&faces), &boxes)
    }
}

impl VPolytope {
    /// The volume (area for `n = 2`, length for `n = 1`); zero for a flat set without remainder.
    ///
    /// With `x` in the interior of `P = conv V` and `t = max_i |a_i|'r / (b_i - a_i'x)` over its facets `a_i'x <= b_i`, the box `[-r, r]`
    /// lies in `t (P - x)`, so `vol P <= vol (P + [-r, r]) <= (1 + t)^n vol P`. Where `r` is not small against `P`, the volume of the
    /// interval hull bounds it from above.
    ///
    /// **Guarantee:** an enclosure of the exact volume.
    ///
    /// # Errors
    /// As [`to_h_polytope`](Self::to_h_polytope); [`SetError::OverBudget`] for too many simplices.
    pub fn volume(&self) -> Result<Interval, SetError> {
        let n = self.dim();
        let quality = if self.is_exact() { Quality::Incidence } else { Quality::Verified };
        let facets = Facets::enumerate(&self.vertices, exact_shift(&self.vertices), MAX_FACES, quality)?;
        let flat = facets.coordinates.len() < n;
        let inner = if flat {
            Interval::ZERO
        } else {
            let points: Vec<Vec<Interval>> = facets
                .points
                .iter()
                .map(|&j| self.vertices.col(j).iter().map(|&x| Interval::point(x)).collect())
                .collect();
            let all: Vec<usize> = (0..facets.incidence.len()).collect();
            volume_of(n, &facets.incidence, &all, &points)?
        };
        if self.is_exact() {
            return Ok(inner);
        }
        let hull = self.interval_hull().iter().fold(Interval::ONE, |product, side| product.scale(side.width()));
        let mut upper = hull.hi();
        if flat {
            return Ok(inner.hull(Interval::point(upper)));
        }
        if let Some(t) = self.growth(&facets) {
            let factor = Interval::ONE.add_f64(t);
            upper = upper.min((0..n).fold(inner, |product, _| product * factor).hi());
        }
        Ok(inner.hull(Interval::point(upper)))
    }

    /// `t` with `[-r, r]` in `t (P - x)`, `x` the mean of the vertices; `None` where rounding hides that `x` lies inside. For facets of
    /// all coordinates: `P` is not flat.
    fn growth(&self, facets: &Facets) -> Option<f64> {
        let center = self.column_mean();
        let mut largest = 0.0_f64;
        for (y, &error) in facets.inequalities.iter().zip(&facets.errors) {
            let entry = |k: usize| Interval::point(y[k]).inflate(error * facets.scales[k]);
            let (mut slack, mut reach) = (entry(0), Interval::ZERO);
            for k in 0..self.dim() {
                let normal = entry(k + 1);
                slack += normal * (Interval::point(center[k]) - Interval::point(facets.shift[k]));
                reach += normal.abs().scale(self.remainder[k]);
            }
            let ratio = (reach / slack).hi();
            if !(slack.lo() > 0.0 && ratio.is_finite()) {
                return None;
            }
            largest = largest.max(ratio);
        }
        Some(largest)
    }

    /// The mean of the columns, rounded.
    pub(super) fn column_mean(&self) -> Vec<f64> {
        let share = 1.0 / self.num_vertices() as f64;
        let mut mean = vec![0.0; self.dim()];
        for column in self.vertices.columns() {
            for (m, x) in mean.iter_mut().zip(column) {
                *m += share * x;
            }
        }
        mean
    }
}
