//! Redundant half-spaces by linear programs.

use super::HPolytope;
use super::frame::Frame;
use crate::constrained_zonotope::{prepared, refused};
use crate::{SetError, Workspace};

impl HPolytope {
    /// The set without half-spaces proven redundant, by one linear program each: for many rows, where
    /// [`remove_redundant`](Self::remove_redundant) enumerates vertices.
    ///
    /// Row `i` is dropped if `max a_i'x <= h_i` over the rows that are left and a box twice as wide as the bounding box. The box cannot
    /// hide a point outside: the segment from one that breaks row `i` alone to a member crosses the boundary of row `i` in the set,
    /// so in the interior of the box, and breaks it nearby. That needs a member: the center of a proven ball.
    ///
    /// A row is kept when rounding leaves a doubt (rows that touch the set, and so all that are redundant by a tie but are not equal
    /// to another one). Sets that are flat, empty or not proven bounded keep all rows but those equal to another.
    ///
    /// Among rows of very different scales the dropped ones may be those that a [bounding box](Self::bounding_box) is easily proven from:
    /// take the box first where that matters.
    ///
    /// **Guarantee:** exact, the same set.
    ///
    /// # Errors
    /// As [`bounding_box`](Self::bounding_box); [`SetError::Overflow`] for rows that overflow at the size of the set.
    ///
    /// ```
    /// # use setrep::{HPolytope, Matrix, Workspace};
    /// let h = Matrix::from_rows(&[&[-1.0, 0.0], &[0.0, -1.0], &[1.0, 2.0], &[1.0, 1.0], &[1.0, 2.0]])?;
    /// let triangle = HPolytope::new(h, &[0.0, 0.0, 1.0, 1.1, 3.0])?;
    /// assert_eq!(triangle.drop_redundant(&mut Workspace::new())?.num_half_spaces(), 3);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn drop_redundant(&self, workspace: &mut Workspace) -> Result<Self, SetError> {
        let distinct = self.select(&self.distinct_rows());
        let hull = distinct.bounding_box(workspace)?;
        match distinct.chebyshev_ball_in(&hull, workspace) {
            Ok(ball) if ball.radius >= 0.0 => {}
            Err(error @ SetError::TooLarge { .. }) => return Err(error),
            _ => return Ok(distinct),
        }
        let frame = Frame::around(&hull, 2.0)?;
        frame.load(&distinct, None, workspace)?;
        let solver = prepared(&mut workspace.solver)?;
        let mut kept = Vec::with_capacity(distinct.num_half_spaces());
        for i in 0..distinct.num_half_spaces() {
            let slack = frame.slack(&distinct, i);
            let objective: Vec<f64> = distinct.normal(i).zip(&frame.scales).map(|(a, s)| a * s).collect();
            solver.set_range(i, f64::NEG_INFINITY, f64::INFINITY).map_err(refused)?;
            let redundant = solver.maximize(&objective).is_ok_and(|solution| solution.bound <= slack.lo());
            if !redundant {
                solver.set_range(i, f64::NEG_INFINITY, slack.hi()).map_err(refused)?;
                kept.push(i);
            }
        }
        Ok(distinct.select(&kept))
    }

    /// The rows without those that repeat the normal of another one with an offset not below its own.
    fn distinct_rows(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.num_half_spaces()).collect();
        let compare = |&i: &usize, &j: &usize| {
            let normals = self.normal(i).partial_cmp(self.normal(j)).unwrap_or(core::cmp::Ordering::Equal);
            normals.then(self.offsets[i].total_cmp(&self.offsets[j])).then(i.cmp(&j))
        };
        order.sort_unstable_by(compare);
        order.dedup_by(|later, first| self.normal(*later).eq(self.normal(*first)));
        order.sort_unstable();
        order
    }
}
