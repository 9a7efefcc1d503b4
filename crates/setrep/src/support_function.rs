//! What every convex set answers: how far it reaches in a direction.

use scalars::Interval;

use crate::{ConstrainedZonotope, IntervalVector, Matrix, Part, SetError, VPolytope, Workspace, Zonotope};

/// A convex set known by its support function `h(d) = max { d'x : x in X }`; object safe, for what works on sets of any type
/// (outlines, meshes, outer polytopes, hulls).
///
/// A closed convex set is the intersection of the half-spaces `d'x <= h(d)`, so upper bounds of supports enclose it.
///
/// ```
/// # use setrep::{IntervalVector, SupportFunction, Workspace, Zonotope};
/// let zonotope = Zonotope::from_box(&[1.0, 0.0], &[1.0, 1.0])?;
/// let sides = zonotope.interval_hull();
/// let sets: [&dyn SupportFunction; 2] = [&zonotope, &sides];
/// let (mut point, mut workspace) = ([0.0; 2], Workspace::new());
/// for set in sets {
///     assert!((3.0..3.0 + 1e-14).contains(&set.support(&[1.0, 1.0], &mut workspace)?));
///     set.support_vector(&[1.0, 1.0], &mut point, &mut workspace)?;
///     assert!((point[0] - 2.0).abs() < 1e-14 && (point[1] - 1.0).abs() < 1e-14);
/// }
/// # Ok::<(), setrep::SetError>(())
/// ```
pub trait SupportFunction {
    /// Dimension `n` of the space.
    fn dim(&self) -> usize;

    /// Support function `h(d)`, shape `d: n`.
    ///
    /// **Guarantee:** an upper bound of the exact value; `-inf` only if the set is proven empty, `inf` where no finite bound is known.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction, and what the set's own type says.
    fn support(&self, direction: &[f64], workspace: &mut Workspace) -> Result<f64, SetError>;

    /// Support function, and into `point` (length `n`) a support vector: a point where it is attained.
    ///
    /// **Guarantee:** the value as of [`support`](Self::support). The point is a member up to rounding, and `d'x` reaches the value up
    /// to rounding, but neither is proven; NaN if the set is proven empty, not finite where the value is not.
    ///
    /// # Errors
    /// As [`support`](Self::support); [`SetError::Dimension`] if the slice has another length.
    fn support_vector(&self, direction: &[f64], point: &mut [f64], workspace: &mut Workspace) -> Result<f64, SetError>;

    /// [`support_vector`](Self::support_vector) for each column of `directions: n x k`: the supports, and the vectors as the columns of
    /// `points`. Sets behind a linear program load it once, so this is the way to ask for many.
    ///
    /// # Errors
    /// As [`support_vector`](Self::support_vector).
    fn support_vectors(
        &self,
        directions: &Matrix,
        points: &mut Matrix,
        workspace: &mut Workspace,
    ) -> Result<Vec<f64>, SetError> {
        SetError::check_size(Part::Direction, self.dim(), directions.rows())?;
        points.reset(self.dim(), directions.cols());
        (0..directions.cols()).map(|k| self.support_vector(directions.col(k), points.col_mut(k), workspace)).collect()
    }

    /// Interval hull, by the supports of both signs of every axis.
    ///
    /// **Guarantee:** superset of the exact hull, hence of the set; empty only if the set is proven empty.
    ///
    /// # Errors
    /// As [`support`](Self::support).
    fn interval_hull(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        let n = self.dim();
        let mut axes = Matrix::zeros(n, 2 * n);
        for k in 0..n {
            axes.col_mut(2 * k)[k] = 1.0;
            axes.col_mut(2 * k + 1)[k] = -1.0;
        }
        let supports = self.support_vectors(&axes, &mut Matrix::zeros(n, 0), workspace)?;
        let sides = supports.chunks_exact(2).map(|pair| Interval::new(-pair[1], pair[0]).unwrap_or(Interval::EMPTY));
        Ok(empty_as_a_whole(sides.collect()))
    }
}

/// A hull of which one side is empty belongs to an empty set.
pub(crate) fn empty_as_a_whole(mut hull: IntervalVector) -> IntervalVector {
    if hull.iter().any(Interval::is_empty) {
        hull.fill(Interval::EMPTY);
    }
    hull
}

/// Checks a direction and the slice for a support vector.
pub(crate) fn check_direction(dim: usize, direction: &[f64], point: Option<&[f64]>) -> Result<(), SetError> {
    SetError::check_size(Part::Direction, dim, direction.len())?;
    SetError::check_finite(Part::Direction, dim, direction)?;
    point.map_or(Ok(()), |point| SetError::check_size(Part::Output, dim, point.len()))
}

impl SupportFunction for IntervalVector {
    fn dim(&self) -> usize {
        self.len()
    }

    fn support(&self, direction: &[f64], _workspace: &mut Workspace) -> Result<f64, SetError> {
        check_direction(self.len(), direction, None)?;
        if self.iter().any(Interval::is_empty) {
            return Ok(f64::NEG_INFINITY);
        }
        let terms = self.iter().zip(direction).filter(|(_, d)| **d != 0.0).map(|(side, &d)| side.scale(d));
        Ok(terms.reduce(|sum, term| sum + term).map_or(0.0, |sum| sum.hi()))
    }

    fn support_vector(&self, direction: &[f64], point: &mut [f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        check_direction(self.len(), direction, Some(point))?;
        let empty = self.iter().any(Interval::is_empty);
        for ((x, side), &d) in point.iter_mut().zip(self.iter()).zip(direction) {
            *x = if empty { f64::NAN } else { corner(side, d) };
        }
        SupportFunction::support(self, direction, workspace)
    }

    fn interval_hull(&self, _workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        Ok(empty_as_a_whole(self.clone()))
    }
}

/// An end of a side that maximises `d x`; a finite one for `d = 0`.
fn corner(side: &Interval, d: f64) -> f64 {
    let end = if d < 0.0 { side.lo() } else { side.hi() };
    if d == 0.0 && !end.is_finite() { side.mid() } else { end }
}

impl SupportFunction for Zonotope {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn support(&self, direction: &[f64], _workspace: &mut Workspace) -> Result<f64, SetError> {
        self.support(direction)
    }

    fn support_vector(
        &self,
        direction: &[f64],
        point: &mut [f64],
        _workspace: &mut Workspace,
    ) -> Result<f64, SetError> {
        check_direction(self.dim(), direction, Some(point))?;
        point.copy_from_slice(&self.center);
        for column in self.generators.columns() {
            let dot: f64 = column.iter().zip(direction).map(|(g, d)| g * d).sum();
            add_multiple(sign(dot), column, point);
        }
        add_corner(&self.remainder, direction, point);
        self.support(direction)
    }

    fn interval_hull(&self, _workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        Ok(self.interval_hull())
    }
}

/// `-1` below zero, `1` otherwise: of several support vectors one at an end.
fn sign(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

/// `point += factor column`.
pub(crate) fn add_multiple(factor: f64, column: &[f64], point: &mut [f64]) {
    if factor != 0.0 {
        point.iter_mut().zip(column).for_each(|(x, g)| *x += factor * g);
    }
}

/// Adds the corner of the box remainder that maximises `d'e`.
pub(crate) fn add_corner(remainder: &[f64], direction: &[f64], point: &mut [f64]) {
    for ((x, &r), &d) in point.iter_mut().zip(remainder).zip(direction) {
        *x += sign(d) * r;
    }
}

impl SupportFunction for ConstrainedZonotope {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn support(&self, direction: &[f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        self.support(direction, workspace)
    }

    fn support_vector(&self, direction: &[f64], point: &mut [f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        self.optimizer(workspace)?.support_vector(direction, point)
    }

    fn support_vectors(
        &self,
        directions: &Matrix,
        points: &mut Matrix,
        workspace: &mut Workspace,
    ) -> Result<Vec<f64>, SetError> {
        SetError::check_size(Part::Direction, self.dim(), directions.rows())?;
        points.reset(self.dim(), directions.cols());
        let mut optimizer = self.optimizer(workspace)?;
        (0..directions.cols()).map(|k| optimizer.support_vector(directions.col(k), points.col_mut(k))).collect()
    }

    fn interval_hull(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        self.interval_hull(workspace)
    }
}

impl SupportFunction for VPolytope {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn support(&self, direction: &[f64], _workspace: &mut Workspace) -> Result<f64, SetError> {
        self.support(direction)
    }

    fn support_vector(
        &self,
        direction: &[f64],
        point: &mut [f64],
        _workspace: &mut Workspace,
    ) -> Result<f64, SetError> {
        check_direction(self.dim(), direction, Some(point))?;
        let reach = |v: &[f64]| v.iter().zip(direction).map(|(v, d)| v * d).sum::<f64>();
        if let Some(vertex) = self.vertices().columns().max_by(|v, w| reach(v).total_cmp(&reach(w))) {
            point.copy_from_slice(vertex);
        }
        add_corner(self.remainder(), direction, point);
        self.support(direction)
    }

    fn interval_hull(&self, _workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        Ok(self.interval_hull())
    }
}
