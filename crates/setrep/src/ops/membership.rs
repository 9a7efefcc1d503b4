//! Membership of a point: proven inside, proven outside, or undecided.

use core::ops::ControlFlow;

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use crate::bounds::gamma;
use crate::wedge::{Wedge, normal_from_minors, subset_count};
use crate::{Part, SetError, Zonotope};

/// Most facet normals, `C(ng + n, n - 1)`, that [`Zonotope::membership`] and [`Zonotope::gauge_approx`] enumerate.
pub const FACET_LIMIT: u64 = 1_000_000;

/// Most interval products that one query spends on facets which floating point does not decide: about a second.
const EXACT_WORK: u64 = 100_000_000;

/// Magnitudes below this leave the fast filter, whose error bounds do not count underflow.
const SAFE_MAGNITUDE: f64 = 1e-250;

/// Whether a point lies in a set, as far as it could be proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Membership {
    /// The point lies in the set.
    ProvenInside,
    /// The point does not lie in the set.
    ProvenOutside,
    /// Neither could be proven: the point is within rounding of the boundary, or known only to a box that crosses it.
    Undecided,
}

impl Zonotope {
    /// Whether a point, known to lie in a box `P`, lies in the set: inside if `P` is a subset, outside if `P` is disjoint from it.
    ///
    /// Three tests in order of cost: the interval hull; a witness `xi` found in floating point whose residual `p - c - G xi` a proven
    /// correction takes up; and all facets, `|l'(p - c)| <= sum_j |l'g_j| + |l|'r` for every normal `l` of `n - 1` columns of `[G I]`,
    /// in floating point with a rigorous error bound and in interval arithmetic where that does not decide. The columns of `I` make
    /// the facets complete for flat sets and for the box remainder.
    ///
    /// **Guarantee:** both proofs hold for the exact set and every point of `P`. Points nearer to the boundary than rounding are
    /// [`Undecided`](Membership::Undecided); so are points that only the facets could decide when there are more than
    /// [`FACET_LIMIT`] of them or 14 dimensions, or (`n >= 4`) beside facets whose generators are linearly dependent. Facets too close
    /// for floating point go to interval arithmetic up to `10^8` products a query and count as undecided beyond it.
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side.
    ///
    /// ```
    /// # use setrep::{IntervalVector, Membership, Zonotope};
    /// let square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// assert_eq!(square.membership(&IntervalVector::point(&[0.9, -0.9]))?, Membership::ProvenInside);
    /// assert_eq!(square.membership(&IntervalVector::point(&[0.9, -1.1]))?, Membership::ProvenOutside);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn membership(&self, point: &[Interval]) -> Result<Membership, SetError> {
        SetError::check_size(Part::Point, self.dim(), point.len())?;
        if let Some(row) = point.iter().position(|x| x.is_empty() || !x.is_bounded()) {
            return Err(SetError::UnboundedInterval { part: Part::Point, row, col: 0 });
        }
        let query = Query::new(self, point);
        if query.outside_hull() {
            return Ok(Membership::ProvenOutside);
        }
        if self.has_witness(&query) {
            return Ok(Membership::ProvenInside);
        }
        let n = self.dim();
        let directions = distinct_directions(self);
        if subset_count(n, directions.len() / n, n - 1) > FACET_LIMIT {
            return Ok(Membership::Undecided);
        }
        Ok(self.test_facets(&query, &directions))
    }

    /// The facet test over all normals of `n - 1` of the directions.
    fn test_facets(&self, query: &Query, directions: &[f64]) -> Membership {
        let n = self.dim();
        let norms: Vec<f64> = directions.chunks_exact(n).map(|g| g.iter().map(|x| x.abs()).sum()).collect();
        let mut exact = Wedge::<Interval>::new(n, n - 1);
        let (mut normal, mut enclosure) = (vec![0.0; n], vec![Interval::ZERO; n]);
        // An exterior product of n - 1 columns costs about n 2^(n-1) products; the dimension is at most 14 here.
        let mut exact_facets = EXACT_WORK / ((n as u64) << (n - 1));
        let mut verdict = Membership::ProvenInside;
        Wedge::<f64>::new(n, n - 1).for_each(directions, &mut |subset, minors| {
            normal_from_minors(minors, &mut normal);
            let mut side = self.side_by_floats(query, &normal, product_error(subset, &norms));
            if side == Membership::Undecided && exact_facets > 0 {
                exact_facets -= 1;
                normal_from_minors(exact.of(directions, subset), &mut enclosure);
                side = self.side_by_intervals(query, &enclosure);
            }
            match side {
                Membership::ProvenInside => ControlFlow::Continue(()),
                Membership::Undecided => {
                    verdict = side;
                    ControlFlow::Continue(())
                }
                Membership::ProvenOutside => {
                    verdict = side;
                    ControlFlow::Break(())
                }
            }
        });
        verdict
    }

    /// `|l'q|` against `sum_j |l'g_j| + |l|'r` for the exact normal, whose components differ from `normal` by at most `error`.
    fn side_by_floats(&self, query: &Query, normal: &[f64], error: f64) -> Membership {
        let (mut lever, mut radius, mut slack, mut magnitude) = (0.0, 0.0, 0.0, 0.0);
        for (k, l) in normal.iter().enumerate() {
            lever += l * query.mid[k];
            radius += l.abs() * self.remainder[k];
            slack += l.abs() * query.rad[k];
            magnitude += l.abs() * query.reach[k];
        }
        for column in self.generators.columns() {
            let dot: f64 = normal.iter().zip(column).map(|(l, g)| l * g).sum();
            radius += dot.abs();
        }
        let roundings = 2 * (self.dim() + self.num_generators() + 6);
        // What the rounding of this evaluation, of the normal, and the box around the point can change.
        let rounding = mul_up(gamma(roundings), magnitude);
        let doubt = add_up(add_up(rounding, mul_up(error, query.total_reach)), mul_up(slack, 1.0 + 1e-9));
        let distance = lever.abs() - radius;
        // Below the safe magnitude underflow is not covered; NaN fails both comparisons.
        if magnitude < SAFE_MAGNITUDE {
            Membership::Undecided
        } else if distance < -(doubt + 2.0 * rounding) {
            Membership::ProvenInside
        } else if distance > doubt + 2.0 * rounding {
            Membership::ProvenOutside
        } else {
            Membership::Undecided
        }
    }

    /// The same in interval arithmetic, for every normal in the enclosure.
    fn side_by_intervals(&self, query: &Query, normal: &[Interval]) -> Membership {
        let mut lever = Interval::ZERO;
        let mut radius = Interval::ZERO;
        for (k, l) in normal.iter().enumerate() {
            lever += *l * query.offset[k];
            radius += l.abs().scale(self.remainder[k]);
        }
        for column in self.generators.columns() {
            let dot = normal.iter().zip(column).fold(Interval::ZERO, |sum, (l, &g)| sum + l.scale(g));
            radius += dot.abs();
        }
        let lever = lever.abs();
        if lever.hi() <= radius.lo() {
            Membership::ProvenInside
        } else if lever.lo() > radius.hi() {
            Membership::ProvenOutside
        } else {
            Membership::Undecided
        }
    }
}

/// A point relative to the center of a set, and the magnitudes that rounding errors are measured by.
#[derive(Debug)]
pub(crate) struct Query {
    /// Encloses `p - c`.
    pub(crate) offset: Vec<Interval>,
    /// Midpoint and radius of the box.
    pub(crate) mid: Vec<f64>,
    pub(crate) rad: Vec<f64>,
    /// Bounds of `|p - c| + sum_j |G_kj| + r_k`, and their sum.
    reach: Vec<f64>,
    total_reach: f64,
    /// Bounds of the half-widths of the hull.
    pub(crate) hull: Vec<f64>,
}

impl Query {
    fn new(set: &Zonotope, point: &[Interval]) -> Self {
        let offset: Vec<Interval> = point.iter().zip(&set.center).map(|(p, &c)| p.add_f64(-c)).collect();
        let mid: Vec<f64> = offset.iter().map(Interval::mid).collect();
        let rad = offset.iter().map(Interval::rad).collect();
        let mut hull = vec![0.0; set.dim()];
        set.hull_radii(&mut hull);
        let reach: Vec<f64> = offset.iter().zip(&hull).map(|(x, &h)| add_up(x.mag(), h)).collect();
        let total_reach = reach.iter().copied().fold(0.0, add_up);
        Self { offset, mid, rad, reach, total_reach, hull }
    }

    /// Whether the point is proven outside the interval hull.
    fn outside_hull(&self) -> bool {
        self.offset.iter().zip(&self.hull).any(|(x, &h)| x.mig() > h)
    }
}

/// Bounds the error of every component of a computed exterior product: a sum of signed products of one entry of each column, at most
/// `k (k + 1) / 2` roundings deep, whose absolute values sum to at most the product of the 1-norms. Infinite where a prefix is so
/// small that underflow would count.
fn product_error(subset: &[usize], norms: &[f64]) -> f64 {
    let (mut product, mut least) = (1.0, 1.0_f64);
    for &j in subset {
        product *= norms[j];
        least = least.min(product);
    }
    let k = subset.len();
    // Twice the depth absorbs the rounding of the norms and of their product.
    let relative = if k < 2 { 0.0 } else { gamma(k * (k + 1)) };
    if least < SAFE_MAGNITUDE { f64::INFINITY } else { mul_up(relative, product) }
}

/// The columns of `[G I]` that are not zero and not exactly parallel to an earlier one, column-major.
///
/// Parallel columns span no facet, and their exterior product would be an interval around zero that proves nothing.
pub(crate) fn distinct_directions(set: &Zonotope) -> Vec<f64> {
    let n = set.dim();
    let axes = crate::Matrix::identity(n);
    let mut directions: Vec<f64> = Vec::with_capacity((set.num_generators() + n) * n);
    for column in axes.columns().chain(set.generators.columns()) {
        let zero = column.iter().all(|&x| x == 0.0);
        if !zero && !directions.chunks_exact(n).any(|other| parallel(column, other)) {
            directions.extend_from_slice(column);
        }
    }
    directions
}

/// Whether two nonzero columns are exactly parallel (`false` if underflow leaves a doubt).
fn parallel(a: &[f64], b: &[f64]) -> bool {
    let mut pivot = 0;
    for k in 1..a.len() {
        if a[k].abs() > a[pivot].abs() {
            pivot = k;
        }
    }
    (0..a.len()).all(|k| k == pivot || same_product(a[pivot], b[k], a[k], b[pivot]))
}

/// Whether `a b = c d` exactly: both the rounded products and their rounding errors agree.
fn same_product(a: f64, b: f64, c: f64, d: f64) -> bool {
    let (left, right) = (a * b, c * d);
    if left != right {
        return false;
    }
    let exact_zeros = (a == 0.0 || b == 0.0) && (c == 0.0 || d == 0.0);
    exact_zeros || (left.is_finite() && left.abs() > SAFE_MAGNITUDE && a.mul_add(b, -left) == c.mul_add(d, -right))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns a few ulps apart: the computed minors are mostly rounding, and the bound covers it.
    #[test]
    fn product_error_bounds_the_rounding_of_normals() {
        for n in 2..6 {
            let column = |j: usize| {
                (0..n).map(move |i| (1.0 + 0.37 * i as f64).sin() * (1.0 + (i * j % 5) as f64 * f64::EPSILON))
            };
            let columns: Vec<f64> = (0..n).flat_map(column).collect();
            let norms: Vec<f64> = columns.chunks_exact(n).map(|g| g.iter().map(|x| x.abs()).sum()).collect();
            let subset: Vec<usize> = (0..n - 1).collect();
            let computed = Wedge::<f64>::new(n, n - 1).of(&columns, &subset).to_vec();
            let mut exact = Wedge::<Interval>::new(n, n - 1);
            let error = product_error(&subset, &norms);
            for (minor, enclosure) in computed.iter().zip(exact.of(&columns, &subset)) {
                assert!(enclosure.add_f64(-minor).mig() <= error, "{minor} against {enclosure}, error {error}");
            }
        }
    }
}
