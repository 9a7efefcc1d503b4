//! [`Parallelotope`]: a set between parallel planes across its principal axes, with its vertices.

use scalars::Interval;
use scalars::rounding::{add_up, div_up, mul_up, sub_down};
use setrep::{Matrix, Reduction, SetError, Zonotope};

use crate::BoundError;

/// More dimensions than this have too many vertices (`2^n`).
pub(crate) const MAX_DIMENSION: usize = 16;

/// The parallelotope `{ x : U'(x - center) in sides }` around a set, `U` orthogonal but for rounding.
///
/// With `E = I - U'U` and `delta` the largest row sum of `|E|`, `U'^-1 = U (I - E)^-1` differs from `U` by at most
/// `error = |U| delta / (1 - delta)` in every row sum, so `x - center` lies in `U zeta +- error |zeta|` for `zeta` in the sides.
#[derive(Debug)]
pub(crate) struct Parallelotope {
    pub(crate) center: Vec<f64>,
    pub(crate) sides: Vec<Interval>,
    /// `U`, one axis a column.
    axes: Matrix,
    /// Bound of every row sum of `|U'^-1 - U|`.
    error: f64,
}

impl Parallelotope {
    /// The parallelotope around a set with the generators of `body`, `support` the support function of the set.
    pub(crate) fn around(
        body: &Zonotope,
        mut support: impl FnMut(&[f64]) -> Result<f64, SetError>,
        workspace: &mut setrep::Workspace,
    ) -> Result<Self, BoundError> {
        let n = body.dim();
        if n > MAX_DIMENSION {
            return Err(SetError::TooManyDimensions { dim: n, limit: MAX_DIMENSION }.into());
        }
        let mut principal = body.clone();
        principal.materialize();
        if principal.num_generators() > n {
            principal.reduce(Reduction::Pca, n, workspace)?;
        }
        let axes = orthonormal(principal.generators());
        let error = inverse_error(&axes).ok_or(SetError::Overflow { row: 0 })?;
        let mut extents = Vec::with_capacity(n);
        for axis in axes.columns() {
            let hi = support(axis)?;
            let opposite: Vec<f64> = axis.iter().map(|x| -x).collect();
            let extent = Interval::new(-support(&opposite)?, hi).map_err(|_| SetError::EmptySet)?;
            extents.push(extent);
        }
        let mut center = vec![0.0; n];
        for (axis, extent) in axes.columns().zip(&extents) {
            center.iter_mut().zip(axis).for_each(|(c, u)| *c += u * extent.mid());
        }
        let along = |axis: &[f64]| {
            axis.iter().zip(&center).fold(Interval::ZERO, |sum, (&u, &c)| sum + Interval::point(c).scale(u))
        };
        let sides: Vec<Interval> = axes.columns().zip(&extents).map(|(axis, extent)| *extent - along(axis)).collect();
        BoundError::check_box(crate::Operand::Hull, n, &sides)?;
        Ok(Self { center, sides, axes, error })
    }

    /// `U'^-1 zeta`: the offset from the center of the points with coordinates `zeta`.
    pub(crate) fn offset(&self, zeta: &[Interval], offset: &mut [Interval]) {
        let spread = mul_up(self.error, zeta.iter().map(Interval::mag).fold(0.0, f64::max));
        for (i, target) in offset.iter_mut().enumerate() {
            let terms = self.axes.columns().zip(zeta);
            let sum = terms.fold(Interval::ZERO, |sum, (axis, zeta)| sum + zeta.scale(axis[i]));
            *target = sum.inflate(spread);
        }
    }

    /// A box around the parallelotope and its center.
    pub(crate) fn hull(&self) -> Vec<Interval> {
        let mut hull = vec![Interval::ZERO; self.center.len()];
        self.offset(&self.sides, &mut hull);
        hull.iter().zip(&self.center).map(|(side, &c)| side.hull(Interval::ZERO).add_f64(c)).collect()
    }

    /// Entry `(i, j)` of `U'^-1`.
    pub(crate) fn axis(&self, i: usize, j: usize) -> Interval {
        Interval::point(self.axes[(i, j)]).inflate(self.error)
    }

    /// Calls `visit` with the coordinates of every vertex, points, as intervals, until it fails.
    pub(crate) fn each_vertex(
        &self,
        mut visit: impl FnMut(&[Interval]) -> Result<(), BoundError>,
    ) -> Result<(), BoundError> {
        let mut zeta = vec![Interval::ZERO; self.sides.len()];
        for choice in 0..1_usize << self.sides.len() {
            for (k, side) in self.sides.iter().enumerate() {
                zeta[k] = Interval::point(if choice >> k & 1 == 0 { side.lo() } else { side.hi() });
            }
            visit(&zeta)?;
        }
        Ok(())
    }
}

/// An orthonormal basis (in floating point) that starts along the longest columns, by Gram and Schmidt; unit vectors fill it up.
fn orthonormal(columns: &Matrix) -> Matrix {
    let n = columns.rows();
    let norm = |v: &[f64]| {
        let largest = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if largest > 0.0 { largest * v.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt() } else { 0.0 }
    };
    let mut candidates: Vec<Vec<f64>> = columns.columns().filter(|v| norm(v) > 0.0).map(<[f64]>::to_vec).collect();
    candidates.sort_by(|a, b| norm(b).total_cmp(&norm(a)));
    for v in &mut candidates {
        let length = norm(v);
        v.iter_mut().for_each(|x| *x /= length);
    }
    candidates.extend((0..n).map(|k| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect()));

    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(n);
    // A vector that keeps a good part of its length is independent; some unit vector keeps 1 / sqrt(n) as long as one is missing.
    let least = 0.5 / (n as f64).sqrt();
    for mut v in candidates {
        for _ in 0..2 {
            for u in &basis {
                let dot: f64 = u.iter().zip(&v).map(|(u, v)| u * v).sum();
                v.iter_mut().zip(u).for_each(|(v, u)| *v -= dot * u);
            }
        }
        let length = norm(&v);
        if basis.len() < n && length > least {
            v.iter_mut().for_each(|x| *x /= length);
            basis.push(v);
        }
    }
    let mut axes = Matrix::zeros(n, n);
    for (j, v) in basis.iter().enumerate() {
        axes.col_mut(j).copy_from_slice(v);
    }
    axes
}

/// Bound of the row sums of `|U'^-1 - U|`, if `U'U` is near the identity.
fn inverse_error(axes: &Matrix) -> Option<f64> {
    let (mut delta, mut size) = (0.0_f64, 0.0_f64);
    for (j, u) in axes.columns().enumerate() {
        let mut sum = 0.0;
        for (k, v) in axes.columns().enumerate() {
            let dot = u.iter().zip(v).fold(Interval::ZERO, |sum, (&u, &v)| sum + Interval::point(u).scale(v));
            let identity = if j == k { 1.0 } else { 0.0 };
            sum = add_up(sum, dot.add_f64(-identity).mag());
        }
        delta = delta.max(sum);
        size = size.max((0..axes.rows()).fold(0.0, |sum, k| add_up(sum, axes[(j, k)].abs())));
    }
    (delta < 0.5).then(|| div_up(mul_up(size, delta), sub_down(1.0, delta)))
}
