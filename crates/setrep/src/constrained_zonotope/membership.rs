//! Membership of a point: proven inside, proven outside, or undecided.

use boxlp::Problem;
use scalars::Interval;
use scalars::rounding::{add_up, sub_down};

use super::ConstrainedZonotope;
use super::optimizer::{prepared, refused};
use crate::bounds::two_sum;
use crate::{Membership, Part, SetError, Workspace};

/// Most sides of positive width of a box whose membership is proven vertex by vertex.
const WIDE_SIDES_LIMIT: u32 = 8;

impl ConstrainedZonotope {
    /// Whether a point, known to lie in a box `P`, lies in the set: inside if `P` is a subset, outside if `P` is disjoint from it.
    ///
    /// `P` is disjoint from the set if `G xi in P - c +- r`, `A xi in [b]` are proven to contradict each other (a Farkas
    /// certificate). A convex set contains `P` if it contains its vertices, and a vertex `p` is inside if an exact solution of
    /// `G xi in p - c +- r`, `A xi in [b]` is proven to exist (a fixed-point argument about a computed one).
    ///
    /// **Guarantee:** both proofs hold for the exact set and every point of `P`. Points nearer to the boundary than rounding are
    /// [`Undecided`](Membership::Undecided), and so are boxes with more than 8 sides of positive width unless they are outside.
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::UnboundedInterval`] for an empty or unbounded side; [`SetError::TooLarge`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, IntervalVector, Matrix, Membership, Workspace};
    /// let rows = Matrix::from_rows(&[&[1.0, 1.0]])?;
    /// let segment = ConstrainedZonotope::from_cg_rep(&[0.0, 0.0], &Matrix::identity(2), &rows, &[1.5])?;
    /// let mut workspace = Workspace::new();
    /// let mut ask = |x: &[f64]| segment.membership(&IntervalVector::point(x), &mut workspace);
    /// assert_eq!(ask(&[0.75, 0.75])?, Membership::ProvenInside);
    /// assert_eq!(ask(&[0.75, 0.76])?, Membership::ProvenOutside);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn membership(&self, point: &[Interval], workspace: &mut Workspace) -> Result<Membership, SetError> {
        SetError::check_size(Part::Point, self.dim(), point.len())?;
        if let Some(row) = point.iter().position(|x| x.is_empty() || !x.is_bounded()) {
            return Err(SetError::UnboundedInterval { part: Part::Point, row, col: 0 });
        }
        let outer = |i: usize| point[i].add_f64(-self.center()[i]).inflate(self.remainder()[i]);
        let n = self.dim();
        if let Some(row) = (0..n).find(|&i| !outer(i).is_bounded()) {
            return Err(SetError::Overflow { row });
        }
        let sides: Vec<Target> = (0..n).map(|i| Target { range: outer(i), rest: 0.0 }).collect();
        let problem = self.fiber(&sides).map_err(refused)?;
        let solver = prepared(&mut workspace.solver)?;
        solver.load(&problem);
        if matches!(solver.emptiness(), boxlp::Emptiness::Empty(_)) {
            return Ok(Membership::ProvenOutside);
        }
        let wide: Vec<usize> = (0..n).filter(|&i| point[i].width() > 0.0).collect();
        if wide.len() as u32 > WIDE_SIDES_LIMIT {
            return Ok(Membership::Undecided);
        }
        for vertex in 0_u32..1 << wide.len() {
            let mut corner: Vec<f64> = point.iter().map(Interval::lo).collect();
            for (bit, &i) in wide.iter().enumerate() {
                if vertex >> bit & 1 == 1 {
                    corner[i] = point[i].hi();
                }
            }
            let sides: Vec<Target> = (0..n).map(|i| self.inner_target(i, corner[i])).collect();
            solver.load(&self.fiber(&sides).map_err(refused)?);
            if !matches!(solver.emptiness(), boxlp::Emptiness::NonEmpty(_)) {
                return Ok(Membership::Undecided);
            }
        }
        Ok(Membership::ProvenInside)
    }

    /// The problem `{ A xi in [b], G xi - rest zeta in range, zeta = 1 }`; without `zeta` if there is no rest.
    fn fiber(&self, sides: &[Target]) -> Result<Problem, boxlp::LpError> {
        let columns = self.num_generators();
        let split = sides.iter().any(|side| side.rest != 0.0);
        let mut problem = Problem::new(columns + usize::from(split))?;
        let mut row = vec![0.0; problem.variables()];
        for (i, range) in self.ranges.iter().enumerate() {
            (0..columns).for_each(|j| row[j] = self.constraints.col(j)[i]);
            problem.push_row(&row, range.lo(), range.hi())?;
        }
        for (i, side) in sides.iter().enumerate() {
            (0..columns).for_each(|j| row[j] = self.generators().col(j)[i]);
            if split {
                row[columns] = -side.rest;
            }
            problem.push_row(&row, side.range.lo(), side.range.hi())?;
        }
        if split {
            row.fill(0.0);
            row[columns] = 1.0;
            problem.push_row(&row, 1.0, 1.0)?;
        }
        Ok(problem)
    }

    /// A range for `(G xi)_i` that puts `x_i` in reach of the remainder: a subset of `x_i - c_i +- r_i`.
    fn inner_target(&self, i: usize, x: f64) -> Target {
        // x - c = offset + rest exactly.
        let (offset, rest) = two_sum(x, -self.center()[i]);
        let r = self.remainder()[i];
        let range = Interval::new(add_up(offset, -r), sub_down(offset, -r)).unwrap_or(Interval::point(offset));
        Target { range: if r == 0.0 { Interval::point(offset) } else { range }, rest }
    }
}

/// A row of `G xi` must lie in `range + rest`.
struct Target {
    range: Interval,
    rest: f64,
}
