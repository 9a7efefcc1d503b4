//! From vertices to half-spaces.

use super::cone::{Cone, Span, span};
use super::exact::{decompose, scale_by_power};
use super::incidence::{BitSets, is_subset, iter};
use super::planar::hull_order;
use super::rows::Rows;
use super::solve::Solver;
use super::{HPolytope, MAX_FACES, VPolytope};
use crate::{Matrix, SetError};

/// Verified facets with a larger error are computed in integers.
const FINE: f64 = 1e-13;

/// Entries of normals below this share of the largest are rounding errors of zeros.
const NOISE: f64 = 4.0 * f64::EPSILON;

/// What the inequalities of the facets are needed for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Quality {
    /// Not at all: the combinatorics are enough.
    Incidence,
    /// As normals, whose rounding the offsets will cover.
    Float,
    /// As enclosures of the exact facets.
    Verified,
}

/// Inequalities `y_0 + y'(x_J - s) >= 0` of the facets of a hull, in the coordinates `J` of its affine frame.
pub(super) struct Facets {
    /// The coordinates `J`, one for each dimension of the hull: the affine hull is a graph over them.
    pub(super) coordinates: Vec<usize>,
    /// The shift `s`, in all coordinates.
    pub(super) shift: Vec<f64>,
    /// `(y_0, y)` for each facet, near a multiple of the exact one; none for [`Quality::Incidence`].
    pub(super) inequalities: Vec<Vec<f64>>,
    /// For [`Quality::Verified`] a bound of the error of the entries, in the scale of [`scales`](Self::scales).
    pub(super) errors: Vec<f64>,
    /// Powers of two: entry `k` of an inequality is off by at most `error * scales[k]`.
    pub(super) scales: Vec<f64>,
    /// The columns of `V` at each facet, as members of `points`.
    pub(super) incidence: BitSets,
    /// The columns of `V` that the incidence speaks of; all vertices are among them.
    pub(super) points: Vec<usize>,
    /// `dim J + 1` affinely independent columns.
    pub(super) basis: Vec<usize>,
    /// The constraints `(1, v_J - s_J)`, one a column.
    pub(super) rows: Rows<'static>,
}

impl Facets {
    /// The facets of the convex hull of the columns, with exact combinatorics, seen from the origin `s = shift`: zero or
    /// [`exact_shift`].
    pub(super) fn enumerate(
        vertices: &Matrix,
        shift: Vec<f64>,
        max_facets: usize,
        quality: Quality,
    ) -> Result<Self, SetError> {
        let n = vertices.rows();
        let lifted =
            |v: &[f64]| core::iter::once(1.0).chain(v.iter().zip(&shift).map(|(x, s)| x - s)).collect::<Vec<f64>>();
        let all = Rows::new(n + 1, vertices.columns().flat_map(lifted).collect());
        let (rows, coordinates, basis) = match span(&all, None) {
            Span::Full(basis) => (all, (0..n).collect(), basis),
            Span::Columns(columns) => {
                // The first column is a pivot: every row begins with 1.
                let rows = all.select_columns(&columns);
                let coordinates = columns[1..].iter().map(|k| k - 1).collect();
                match span(&rows, None) {
                    Span::Full(basis) => (rows, coordinates, basis),
                    // Not reached: the chosen columns are independent.
                    Span::Columns(_) => return Err(SetError::EmptySet),
                }
            }
        };
        let scales: Vec<f64> =
            (0..rows.dim()).map(|k| scale_by_power(1.0, i64::from(rows.column_exponent(k)))).collect();
        let (mut inequalities, mut errors, mut points) = (Vec::new(), Vec::new(), basis.clone());
        let mut incidence = BitSets::new(0, 0);
        if rows.dim() > 1 {
            let mut cone = Cone::enumerate(&rows, &basis, max_facets)?;
            points = cone.slots.iter().map(|&row| row as usize).collect();
            incidence = BitSets::new(cone.live.len(), points.len());
            let live = core::mem::take(&mut cone.live);
            for (i, &ray) in live.iter().enumerate() {
                let ray = ray as usize;
                for point in iter(cone.rays.tight.get(ray)) {
                    incidence.insert(i, point);
                }
                let float =
                    if quality == Quality::Float { cone.rays.approximate(&rows, &cone.slots, ray) } else { None };
                if quality != Quality::Incidence && float.is_none() {
                    cone.rays.solve(&rows, &cone.slots, ray);
                    if cone.rays.error(ray) >= FINE {
                        cone.rays.make_exact(&rows, &cone.slots, ray);
                    }
                }
                let y = float.as_deref().unwrap_or(cone.rays.center(ray));
                inequalities.push(y.iter().zip(&scales).map(|(y, s)| y * s).collect());
                errors.push(cone.rays.error(ray));
            }
        }
        Ok(Self { coordinates, shift, inequalities, errors, scales, incidence, points, basis, rows })
    }

    /// The members of `points` that are vertices: no other point lies on all the facets of one.
    pub(super) fn extreme_members(&self) -> Vec<usize> {
        if self.incidence.len() == 0 {
            return (0..self.points.len()).collect();
        }
        let facets_of = self.incidence.transpose(self.points.len());
        let is_extreme = |&i: &usize| {
            // Points within the hull lie on no facet; a rival lies on every facet of `i`, so on its first.
            let Some(first) = iter(facets_of.get(i)).next() else { return false };
            iter(self.incidence.get(first)).all(|k| k == i || !is_subset(facets_of.get(i), facets_of.get(k)))
        };
        (0..self.points.len()).filter(is_extreme).collect()
    }

    /// The columns of `V` that are vertices, increasing.
    pub(super) fn extreme_points(&self) -> Vec<usize> {
        let mut extreme: Vec<usize> = self.extreme_members().into_iter().map(|k| self.points[k]).collect();
        extreme.sort_unstable();
        extreme
    }

    /// The outward normals in `R^n`, scaled to a largest entry in `[1, 2)`.
    fn normals(&self, n: usize) -> Vec<Vec<f64>> {
        self.inequalities
            .iter()
            .map(|y| {
                let mut normal = vec![0.0; n];
                // In the scaled coordinates, where every entry weighs the same.
                let size = |i: usize| (y[i] / self.scales[i]).abs();
                let largest = (1..y.len()).map(size).fold(0.0, f64::max);
                for (i, &k) in self.coordinates.iter().enumerate() {
                    // Any normal is valid; zeros make box facets parallel to the axes.
                    normal[k] = if size(i + 1) <= NOISE * largest { 0.0 } else { -y[i + 1] };
                }
                normalise(&mut normal);
                normal
            })
            .collect()
    }

    /// Normals of hyperplanes that meet in the affine hull, up to rounding: `x_l - m'x_J` for each coordinate `l` outside `J`.
    fn equations(&self, vertices: &Matrix) -> Vec<Vec<f64>> {
        let n = vertices.rows();
        let k = self.coordinates.len();
        let mut matrix = Vec::with_capacity((k + 1) * (k + 1));
        for &j in &self.basis {
            matrix.push(1.0);
            matrix.extend(self.coordinates.iter().map(|&c| vertices[(c, j)] - self.shift[c]));
        }
        let mut solver = Solver::default();
        let mut equations = Vec::with_capacity(n - k);
        for l in (0..n).filter(|l| !self.coordinates.contains(l)) {
            let values: Vec<f64> = self.basis.iter().map(|&j| vertices[(l, j)] - self.shift[l]).collect();
            let mut normal = vec![0.0; n];
            normal[l] = 1.0;
            // Where the solve fails the coordinate axis still bounds the set, only less tightly.
            if solver.solve(k + 1, &matrix, &values) {
                for (&c, &m) in self.coordinates.iter().zip(&solver.solution[1..]) {
                    normal[c] = -m;
                }
            }
            normalise(&mut normal);
            equations.push(normal);
        }
        equations
    }
}

/// Scales a nonzero vector by a power of two to a largest entry in `[1, 2)`, one along an axis to length 1.
fn normalise(normal: &mut [f64]) {
    if normal.iter().filter(|x| **x != 0.0).count() == 1 {
        for x in normal.iter_mut().filter(|x| **x != 0.0) {
            *x = x.signum();
        }
        return;
    }
    let largest = normal.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if largest > 0.0 && largest.is_finite() {
        let (mantissa, exponent) = decompose(largest);
        let k = i64::from(exponent) + 63 - i64::from(mantissa.unsigned_abs().leading_zeros());
        for x in normal {
            *x = scale_by_power(*x, -k);
        }
    }
}

/// A point to measure coordinates from, such that the differences are exact floats: in each coordinate the first vertex's if all are
/// within a factor of two of each other (Sterbenz' lemma), else zero. It keeps far-away sets well conditioned.
pub(super) fn exact_shift(vertices: &Matrix) -> Vec<f64> {
    (0..vertices.rows())
        .map(|k| {
            let values = || vertices.columns().map(|v| v[k]);
            let (lo, hi) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
            if (lo > 0.0 && hi / 2.0 <= lo) || (hi < 0.0 && lo / 2.0 >= hi) { vertices[(k, 0)] } else { 0.0 }
        })
        .collect()
}

impl VPolytope {
    /// The set in half-space form, irredundant; at most [`MAX_FACES`] facets at every stage.
    ///
    /// The normals are the facets' rounded to floats, and each offset is the support function in its normal, rounded up. A flat
    /// set gets the facets within its affine hull and a pair of opposite half-spaces for each missing dimension.
    ///
    /// **Guarantee:** superset: each half-space contains the set whatever its normal. The facets are exactly those of the hull of
    /// the columns: none is missing, none is redundant but by the rounding of its normal.
    ///
    /// # Errors
    /// [`SetError::OverBudget`]; [`SetError::Overflow`] beyond the range of floats.
    pub fn to_h_polytope(&self) -> Result<HPolytope, SetError> {
        self.to_h_polytope_within(MAX_FACES)
    }

    /// [`to_h_polytope`](Self::to_h_polytope) with a limit on the number of facets at every stage of the construction.
    ///
    /// # Errors
    /// As [`to_h_polytope`](Self::to_h_polytope).
    pub fn to_h_polytope_within(&self, max_facets: usize) -> Result<HPolytope, SetError> {
        let n = self.dim();
        let order = if n == 2 { hull_order(&self.vertices) } else { Vec::new() };
        if order.len() > 2 {
            if order.len() > max_facets {
                return Err(SetError::OverBudget { count: order.len(), limit: max_facets });
            }
            let next = |i: usize| order[(i + 1) % order.len()];
            let normals: Vec<Vec<f64>> = (0..order.len()).map(|i| self.edge_normal(order[i], next(i))).collect();
            return self.bounded_by(&normals, &order);
        }
        let facets = Facets::enumerate(&self.vertices, exact_shift(&self.vertices), max_facets, Quality::Float)?;
        let mut normals = facets.normals(n);
        for normal in facets.equations(&self.vertices) {
            normals.push(normal.iter().map(|x| -x).collect());
            normals.push(normal);
        }
        self.bounded_by(&normals, &facets.extreme_points())
    }

    /// The outward normal of an edge of a polygon, counterclockwise.
    fn edge_normal(&self, from: usize, to: usize) -> Vec<f64> {
        let (p, q) = (self.vertices.col(from), self.vertices.col(to));
        // Halves of differences cannot overflow; their rounding is in the offset.
        let mut normal = vec![0.5 * q[1] - 0.5 * p[1], 0.5 * p[0] - 0.5 * q[0]];
        if normal.iter().all(|x| x.abs() < f64::MIN_POSITIVE) {
            normal = vec![q[1] - p[1], p[0] - q[0]];
        }
        normalise(&mut normal);
        normal
    }

    /// Half-spaces with the given normals that support the hull of some columns, plus the remainder.
    fn bounded_by(&self, normals: &[Vec<f64>], columns: &[usize]) -> Result<HPolytope, SetError> {
        let mut matrix = Matrix::zeros(normals.len(), self.dim());
        let mut offsets = Vec::with_capacity(normals.len());
        for (i, normal) in normals.iter().enumerate() {
            let offset = self.support_over(normal, columns.iter().copied());
            if !(offset.is_finite() && normal.iter().all(|x| x.is_finite())) {
                return Err(SetError::Overflow { row: i });
            }
            for (k, &x) in normal.iter().enumerate() {
                matrix[(i, k)] = x;
            }
            offsets.push(offset);
        }
        HPolytope::new(matrix, &offsets)
    }

    /// The same set without the columns that are no vertices: duplicates and points inside the hull of the others.
    ///
    /// **Guarantee:** exact.
    ///
    /// # Errors
    /// [`SetError::OverBudget`].
    pub fn remove_redundant(&self) -> Result<Self, SetError> {
        let mut extreme = if self.dim() == 2 { hull_order(&self.vertices) } else { Vec::new() };
        if extreme.is_empty() {
            extreme = Facets::enumerate(&self.vertices, exact_shift(&self.vertices), MAX_FACES, Quality::Incidence)?
                .extreme_points();
        }
        let mut vertices = Matrix::zeros(self.dim(), 0);
        for j in extreme {
            vertices.push_col(self.vertices.col(j))?;
        }
        Self::with_remainder(vertices, &self.remainder)
    }
}
