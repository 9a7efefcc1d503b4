//! Linear programs over an H-polytope: support function and support vectors without its vertices.

use boxlp::Solver;
use scalars::Interval;
use scalars::rounding::add_up;

use super::HPolytope;
use super::frame::Frame;
use super::solve::dot_upper;
use crate::constrained_zonotope::prepared;
use crate::support_function::check_direction;
use crate::{IntervalVector, Matrix, SetError, SupportFunction, Workspace};

/// A polytope loaded into the solver of a workspace: each direction starts from the solution of the last one.
///
/// With the box `c +- s` around the set, `max d'x = d'c + max { (S d)'xi : H S xi <= h - H c, |xi| <= 1 }`: one tall program over the
/// box, answered by the bound of weak duality, which no rounding of the solver can bring below the exact maximum.
#[derive(Debug)]
pub struct PolytopeOptimizer<'a> {
    hull: IntervalVector,
    /// `None` for a set that is proven empty or not proven bounded.
    frame: Option<Frame>,
    solver: &'a mut Solver,
    objective: &'a mut Vec<f64>,
}

impl HPolytope {
    /// Loads the set for one direction after another: its [`bounding_box`](Self::bounding_box), then one program a direction.
    ///
    /// Made for a few variables and up to thousands of rows; redundant rows do no harm.
    ///
    /// # Errors
    /// As [`bounding_box`](Self::bounding_box); [`SetError::Overflow`] for rows that overflow at the size of the set.
    ///
    /// ```
    /// # use setrep::{HPolytope, Matrix, Workspace};
    /// let h = Matrix::from_rows(&[&[-1.0, 0.0], &[0.0, -1.0], &[1.0, 2.0]])?;
    /// let triangle = HPolytope::new(h, &[0.0, 0.0, 1.0])?;
    /// let mut workspace = Workspace::new();
    /// let mut optimizer = triangle.optimizer(&mut workspace)?;
    /// assert!((1.0..1.0 + 1e-14).contains(&optimizer.support(&[1.0, 1.0])?));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn optimizer<'a>(&self, workspace: &'a mut Workspace) -> Result<PolytopeOptimizer<'a>, SetError> {
        let hull = self.bounding_box(workspace)?;
        let bounded = hull.iter().all(Interval::is_bounded) && !hull[0].is_empty();
        let frame = if bounded { Some(Frame::around(&hull, 1.0)?) } else { None };
        if let Some(frame) = &frame {
            frame.load(self, None, workspace)?;
        }
        let Workspace { solver, objective, .. } = workspace;
        Ok(PolytopeOptimizer { hull, frame, solver: prepared(solver)?, objective })
    }
}

impl PolytopeOptimizer<'_> {
    /// The bounding box of the set.
    #[must_use]
    pub fn hull(&self) -> &IntervalVector {
        &self.hull
    }

    /// Support function `h(d) = max { d'x : x in X }`, shape `d: n`.
    ///
    /// **Guarantee:** an upper bound of the exact value; `-inf` only if the set is proven empty, `inf` if it is not proven bounded.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction.
    pub fn support(&mut self, direction: &[f64]) -> Result<f64, SetError> {
        check_direction(self.hull.len(), direction, None)?;
        Ok(self.solve(direction, None))
    }

    /// Support function, and into `point` (length `n`) a support vector; see [`SupportFunction::support_vector`].
    ///
    /// # Errors
    /// As [`support`](Self::support); [`SetError::Dimension`] if the slice has another length.
    pub fn support_vector(&mut self, direction: &[f64], point: &mut [f64]) -> Result<f64, SetError> {
        check_direction(self.hull.len(), direction, Some(point))?;
        point.fill(f64::NAN);
        Ok(self.solve(direction, Some(point)))
    }

    fn solve(&mut self, direction: &[f64], point: Option<&mut [f64]>) -> f64 {
        if self.hull[0].is_empty() {
            return f64::NEG_INFINITY;
        }
        let Some(frame) = &self.frame else {
            return if direction.iter().all(|&d| d == 0.0) { 0.0 } else { f64::INFINITY };
        };
        let Frame { center, scales } = frame;
        self.objective.clear();
        self.objective.extend(direction.iter().zip(scales).map(|(d, s)| d * s));
        // Of the right length, an objective is refused only if it overflows.
        let Ok(solution) = self.solver.maximize(self.objective) else { return f64::INFINITY };
        if solution.bound == f64::NEG_INFINITY {
            return solution.bound;
        }
        if let Some(point) = point {
            for (j, x) in point.iter_mut().enumerate() {
                *x = center[j] + scales[j] * solution.point[j];
            }
        }
        let lost = frame.underflow(direction.iter().copied());
        let inner = if lost == 0.0 { solution.bound } else { add_up(solution.bound, lost) };
        let value = add_up(dot_upper(direction, center), inner);
        if value.is_nan() { f64::INFINITY } else { value }
    }
}

impl SupportFunction for HPolytope {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn support(&self, direction: &[f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        self.optimizer(workspace)?.support(direction)
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
        SetError::check_size(crate::Part::Direction, self.dim(), directions.rows())?;
        points.reset(self.dim(), directions.cols());
        let mut optimizer = self.optimizer(workspace)?;
        (0..directions.cols()).map(|k| optimizer.support_vector(directions.col(k), points.col_mut(k))).collect()
    }

    fn interval_hull(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        self.bounding_box(workspace)
    }
}
