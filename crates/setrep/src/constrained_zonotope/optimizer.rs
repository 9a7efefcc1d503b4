//! Linear programs over a constrained zonotope: support function and interval hull.

use boxlp::{LpError, Problem, Solver};
use scalars::Interval;
use scalars::rounding::add_up;

use super::ConstrainedZonotope;
use super::rows::{combine, combine_box};
use crate::support_function::{add_corner, add_multiple, check_direction};
use crate::{IntervalVector, SetError, Workspace};

/// A set loaded into the solver of a workspace: each objective starts from the solution of the last one.
///
/// Only proven bounds are used, so no answer depends on the solver having found an optimum:
/// `max d'x <= d'c + |d|'r + B(y)`, `B(y) = sum_i max(y_i lo_i, y_i hi_i) + |G'd - A'y|_1` for **any** multipliers `y` (weak duality),
/// evaluated with outward rounding. Optimal multipliers attain the maximum.
#[derive(Debug)]
pub struct Optimizer<'a> {
    set: &'a ConstrainedZonotope,
    solver: &'a mut Solver,
    objective: &'a mut Vec<f64>,
}

impl ConstrainedZonotope {
    /// Loads the set for one support value after another; allocates nothing within the capacity of the workspace.
    ///
    /// # Errors
    /// [`SetError::TooLarge`] above 2^24 generators or constraints.
    ///
    /// ```
    /// # use scalars::Interval;
    /// # use setrep::{ConstrainedZonotope, Matrix, Workspace};
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0]])?;
    /// let band = ConstrainedZonotope::new(&[0.0, 0.0], &Matrix::identity(2), &rows, &[Interval::point(0.5)])?;
    /// let mut workspace = Workspace::new();
    /// let mut optimizer = band.optimizer(&mut workspace)?;
    /// assert!((0.5..0.5 + 1e-14).contains(&optimizer.support(&[1.0, 1.0])?));
    /// assert!((1.5..1.5 + 1e-14).contains(&optimizer.support(&[1.0, -1.0])?));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn optimizer<'a>(&'a self, workspace: &'a mut Workspace) -> Result<Optimizer<'a>, SetError> {
        let Workspace { solver, objective, scales: lower, row_sums: upper, .. } = workspace;
        let solver = prepared(solver)?;
        lower.clear();
        lower.extend(self.ranges.iter().map(Interval::lo));
        upper.clear();
        upper.extend(self.ranges.iter().map(Interval::hi));
        solver.load_columns(self.num_generators(), self.constraints.as_slice(), lower, upper).map_err(refused)?;
        Ok(Optimizer { set: self, solver, objective })
    }

    /// Support function `h(d) = max { d'x : x in X }`, shape `d: n`; see [`Optimizer::support`].
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction, [`SetError::TooLarge`].
    pub fn support(&self, direction: &[f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        self.optimizer(workspace)?.support(direction)
    }

    /// Interval hull, by `2n` linear programs that start from each other's solutions; see [`Optimizer::interval_hull_into`].
    ///
    /// # Errors
    /// [`SetError::TooLarge`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Matrix, Workspace};
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0]])?;
    /// let segment = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &rows, &[1.5])?;
    /// let hull = segment.interval_hull(&mut Workspace::new())?;
    /// assert!(hull[0].contains(0.5) && hull[0].width() < 0.5 + 1e-14);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn interval_hull(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        let mut hull = IntervalVector::new(vec![Interval::EMPTY; self.dim()]);
        self.interval_hull_into(&mut hull, workspace)?;
        Ok(hull)
    }

    /// [`interval_hull`](Self::interval_hull) into a slice of length `n`; allocates nothing within the capacity of the workspace.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the slice has another length, [`SetError::TooLarge`].
    pub fn interval_hull_into(&self, hull: &mut [Interval], workspace: &mut Workspace) -> Result<(), SetError> {
        self.optimizer(workspace)?.interval_hull_into(hull)
    }
}

impl Optimizer<'_> {
    /// Support function `h(d) = max { d'x : x in X }`, shape `d: n`.
    ///
    /// **Guarantee:** an upper bound of the exact value, `-inf` only if the set is proven empty, `inf` where it overflows.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction.
    pub fn support(&mut self, direction: &[f64]) -> Result<f64, SetError> {
        check_direction(self.set.dim(), direction, None)?;
        Ok(self.solve(direction, None))
    }

    /// Support function, and into `point` (length `n`) a support vector; see
    /// [`SupportFunction::support_vector`](crate::SupportFunction::support_vector).
    ///
    /// # Errors
    /// As [`support`](Self::support); [`SetError::Dimension`] if the slice has another length.
    pub fn support_vector(&mut self, direction: &[f64], point: &mut [f64]) -> Result<f64, SetError> {
        check_direction(self.set.dim(), direction, Some(point))?;
        Ok(self.solve(direction, Some(point)))
    }

    /// The support in a checked direction, and where it is attained.
    fn solve(&mut self, direction: &[f64], point: Option<&mut [f64]>) -> f64 {
        let set = self.set;
        self.objective.clear();
        self.objective.resize(set.num_generators(), 0.0);
        let error = combine(direction, set.generators(), self.objective);
        // An objective of the right length is refused only if it overflows.
        let solution = self.solver.maximize(self.objective);
        let inner = solution.as_ref().map_or(f64::INFINITY, |solution| solution.bound);
        if let Some(point) = point {
            match solution {
                Ok(solution) if inner > f64::NEG_INFINITY => {
                    point.copy_from_slice(set.center());
                    for (column, &xi) in set.generators().columns().zip(solution.point) {
                        add_multiple(xi, column, point);
                    }
                    add_corner(set.remainder(), direction, point);
                }
                _ => point.fill(f64::NAN),
            }
        }
        if inner == f64::NEG_INFINITY {
            return inner;
        }
        let outer = combine_box(direction, set.center(), set.remainder()).hi();
        // NaN, from an overflow of both signs, rounds up to infinity.
        if error == 0.0 { add_up(outer, inner) } else { add_up(add_up(outer, error), inner) }
    }

    /// Interval hull into a slice of length `n`: the supports of both signs of every axis, and the hull of the set without its
    /// constraints where that is tighter.
    ///
    /// **Guarantee:** superset of the exact hull, hence of the set; empty only if the set is proven empty.
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the slice has another length.
    pub fn interval_hull_into(&mut self, hull: &mut [Interval]) -> Result<(), SetError> {
        let body = &self.set.body;
        body.interval_hull_into(hull)?;
        if self.set.ranges.is_empty() {
            return Ok(());
        }
        for (i, side) in hull.iter_mut().enumerate() {
            self.objective.clear();
            self.objective.extend((0..body.num_generators()).map(|j| body.generators.col(j)[i]));
            let hi = self.maximum();
            self.objective.iter_mut().for_each(|x| *x = -*x);
            let lo = -self.maximum();
            let range = Interval::new(lo, hi).unwrap_or(Interval::EMPTY);
            *side = side.intersection(range.add_f64(body.center[i]).inflate(body.remainder[i]));
        }
        // Proven bounds that contradict each other on one axis prove the set empty.
        if hull.iter().any(Interval::is_empty) {
            hull.fill(Interval::EMPTY);
        }
        Ok(())
    }

    /// Proven upper bound of the objective over the coordinates `xi`; `-inf` if they are proven to have no solution.
    fn maximum(&mut self) -> f64 {
        // An objective of the right length is refused only if it overflows.
        self.solver.maximize(self.objective).map_or(f64::INFINITY, |solution| solution.bound)
    }
}

/// The workspace's solver, made on first use.
pub(crate) fn prepared(solver: &mut Option<Solver>) -> Result<&mut Solver, SetError> {
    match solver {
        Some(solver) => Ok(solver),
        None => Ok(solver.insert(Solver::new(Problem::new(0).map_err(refused)?))),
    }
}

/// What a refused problem means for the set it was made of, whose entries have been checked.
pub(crate) fn refused(error: LpError) -> SetError {
    match error {
        LpError::TooLarge { size } => SetError::TooLarge { size },
        LpError::RowOverflow { row } | LpError::Range { row, .. } | LpError::Entry { row, .. } => {
            SetError::Overflow { row }
        }
        _ => SetError::Overflow { row: 0 },
    }
}
