//! Polygons: convex hulls by sorting, and their Minkowski sum, with exact orientation predicates.

use core::cmp::Ordering;

use scalars::rounding::UNIT_ROUNDOFF;

use super::VPolytope;
use super::exact::sign_of_sum;
use crate::bounds::{add_lengths, two_sum};
use crate::{Matrix, SetError};

/// The side of `c` with respect to the line from `a` to `b`: greater is left. Exact.
fn orientation(a: &[f64], b: &[f64], c: &[f64]) -> Ordering {
    turn((a, b), (a, c))
}

/// The sign of the cross product of two edges, `(q - p) x (s - r)`. Exact.
///
/// The filter: differences are off by `u` of themselves, products and their difference by `3u` of the products' magnitudes.
fn turn((p, q): (&[f64], &[f64]), (r, s): (&[f64], &[f64])) -> Ordering {
    let left = (q[0] - p[0]) * (s[1] - r[1]);
    let right = (q[1] - p[1]) * (s[0] - r[0]);
    let cross = left - right;
    if cross.abs() > 5.0 * UNIT_ROUNDOFF * (left.abs() + right.abs()) + 1e-290 && cross.is_finite() {
        return cross.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
    }
    sign_of_sum(
        [
            (q[0], s[1]),
            (-q[0], r[1]),
            (-p[0], s[1]),
            (p[0], r[1]),
            (-q[1], s[0]),
            (q[1], r[0]),
            (p[1], s[0]),
            (-p[1], r[0]),
        ]
        .into_iter(),
    )
}

/// The vertices of the hull of the columns of a `2 x m` matrix, counterclockwise from the lowest of the leftmost. Exact: no point on an
/// edge, no duplicate.
///
/// **Source:** Andrew, *Another efficient algorithm for convex hulls in two dimensions* (1979).
pub(super) fn hull_order(points: &Matrix) -> Vec<usize> {
    let at = |j: usize| points.col(j);
    let mut sorted: Vec<usize> = (0..points.cols()).collect();
    sorted.sort_unstable_by(|&i, &j| at(i).partial_cmp(at(j)).unwrap_or(Ordering::Equal));
    sorted.dedup_by(|i, j| at(*i) == at(*j));
    if sorted.len() < 3 {
        return sorted;
    }
    let mut hull: Vec<usize> = Vec::with_capacity(sorted.len() + 1);
    let chain = |hull: &mut Vec<usize>, floor: usize, j: usize| {
        while hull.len() > floor && orientation(at(hull[hull.len() - 2]), at(hull[hull.len() - 1]), at(j)).is_le() {
            hull.pop();
        }
        hull.push(j);
    };
    for &j in &sorted {
        chain(&mut hull, 1, j);
    }
    let lower = hull.len();
    for &j in sorted.iter().rev().skip(1) {
        chain(&mut hull, lower, j);
    }
    hull.pop();
    hull
}

impl VPolytope {
    /// The vertices of a polygon, counterclockwise, as columns: the outline of `conv V` for plots.
    ///
    /// **Guarantee:** exact for `conv V`; the box remainder is not in it.
    ///
    /// # Errors
    /// [`SetError::NotPlanar`] unless `n = 2`.
    pub fn outline_2d(&self) -> Result<Matrix, SetError> {
        if self.dim() != 2 {
            return Err(SetError::NotPlanar { dim: self.dim() });
        }
        let mut outline = Matrix::zeros(2, 0);
        for j in hull_order(&self.vertices) {
            outline.push_col(self.vertices.col(j))?;
        }
        Ok(outline)
    }

    /// Minkowski sum of two polygons, `{ x + y : x in X, y in Y }`, by merging their edges in order of direction.
    ///
    /// **Guarantee:** superset; exact where no sum of two vertices rounds, else the largest rounding error joins the remainder.
    ///
    /// # Errors
    /// [`SetError::NotPlanar`] unless both have `n = 2`; [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{Matrix, VPolytope};
    /// let triangle = VPolytope::new(Matrix::from_columns(&[&[0.0, 0.0], &[1.0, 0.0], &[0.0, 1.0]])?)?;
    /// let mirrored = triangle.linear_map(&Matrix::from_diagonal(&[-1.0, -1.0]))?;
    /// assert_eq!(triangle.minkowski_sum_2d(&mirrored)?.num_vertices(), 6);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn minkowski_sum_2d(&self, other: &Self) -> Result<Self, SetError> {
        if let Some(dim) = [self.dim(), other.dim()].into_iter().find(|&dim| dim != 2) {
            return Err(SetError::NotPlanar { dim });
        }
        let (a, b) = (hull_order(&self.vertices), hull_order(&other.vertices));
        let edges = |order: &[usize]| if order.len() > 1 { order.len() } else { 0 };
        let (edges_a, edges_b) = (edges(&a), edges(&b));
        let (mut i, mut j) = (0, 0);
        let mut vertices = Matrix::zeros(2, 0);
        let mut lost = [0.0_f64; 2];
        // Both walks start at the lowest of the leftmost vertices and turn left once around.
        loop {
            let (v, next_v) = (self.vertices.col(a[i % a.len()]), self.vertices.col(a[(i + 1) % a.len()]));
            let (w, next_w) = (other.vertices.col(b[j % b.len()]), other.vertices.col(b[(j + 1) % b.len()]));
            let mut sum = [0.0; 2];
            for k in 0..2 {
                let (value, error) = two_sum(v[k], w[k]);
                if !value.is_finite() {
                    return Err(SetError::Overflow { row: k });
                }
                sum[k] = value;
                lost[k] = lost[k].max(error.abs());
            }
            vertices.push_col(&sum)?;
            let order = match (i < edges_a, j < edges_b) {
                (true, true) => angle_order((v, next_v), (w, next_w)),
                (true, false) => Ordering::Less,
                (false, true) => Ordering::Greater,
                (false, false) => break,
            };
            i += usize::from(order.is_le());
            j += usize::from(order.is_ge());
            if i == edges_a && j == edges_b {
                break;
            }
        }
        let remainder: Vec<f64> =
            (0..2).map(|k| add_lengths(lost[k], add_lengths(self.remainder[k], other.remainder[k]))).collect();
        Self::with_remainder(vertices, &remainder)
    }
}

/// Which edge comes first in the order of directions that starts downward-right, `(-pi/2, 3 pi/2]`. Exact.
fn angle_order(first: (&[f64], &[f64]), second: (&[f64], &[f64])) -> Ordering {
    // Edges of the lower chain run to the right (or straight up at its end), those of the upper chain to the left (or down).
    let is_upper = |(p, q): (&[f64], &[f64])| q[0] < p[0] || (q[0] == p[0] && q[1] < p[1]);
    is_upper(first).cmp(&is_upper(second)).then_with(|| turn(second, first))
}
