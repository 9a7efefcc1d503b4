//! The largest ball in a polytope.

use scalars::Interval;
use scalars::rounding::{add_up, div_down, mul_down, mul_up, sqrt_down, sqrt_up};

use super::HPolytope;
use super::frame::Frame;
use crate::constrained_zonotope::prepared;
use crate::{SetError, Workspace};

/// A ball inside a polytope, near the largest one.
#[derive(Debug, Clone, PartialEq)]
pub struct ChebyshevBall {
    /// Its center.
    pub center: Vec<f64>,
    /// Its radius (2-norm): if not negative, the ball is proven to lie in the set. Of a flat set it can be negative by rounding.
    pub radius: f64,
    /// No ball in the set has a larger radius than this, proven.
    pub radius_bound: f64,
}

impl HPolytope {
    /// The Chebyshev ball: center and radius of the largest ball in the set.
    ///
    /// `max r` over `a_i'x + |a_i|_2 r <= h_i`, one program over the [`bounding_box`](Self::bounding_box). The radius is computed
    /// again from the rounded center, `min_i (h_i - a_i'x) / |a_i|_2` rounded down, so the ball lies in the set whatever the program
    /// answered; the bound is the program's by weak duality, with the lengths rounded down. Where the largest ball is not unique the
    /// center is that of one of them.
    ///
    /// **Guarantee:** `{ x : |x - center|_2 <= radius }` is a subset of the set if `radius >= 0`; the exact Chebyshev radius is at most
    /// `radius_bound`.
    ///
    /// # Errors
    /// [`SetError::EmptySet`], proven; [`SetError::Unbounded`] if no bounding box is proven; as [`bounding_box`](Self::bounding_box).
    ///
    /// ```
    /// # use setrep::{HPolytope, Matrix, Workspace};
    /// let h = Matrix::from_rows(&[&[-1.0, 0.0], &[0.0, -1.0], &[0.6, 0.8]])?;
    /// let ball = HPolytope::new(h, &[0.0, 0.0, 2.4])?.chebyshev_ball(&mut Workspace::new())?;
    /// assert!(ball.radius <= 1.0 && 1.0 <= ball.radius_bound && ball.radius_bound - ball.radius < 1e-12);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn chebyshev_ball(&self, workspace: &mut Workspace) -> Result<ChebyshevBall, SetError> {
        let hull = self.bounding_box(workspace)?;
        self.chebyshev_ball_in(&hull, workspace)
    }

    /// [`chebyshev_ball`](Self::chebyshev_ball) with a box around the set.
    pub(super) fn chebyshev_ball_in(
        &self,
        hull: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<ChebyshevBall, SetError> {
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet);
        }
        if !hull.iter().all(Interval::is_bounded) {
            return Err(SetError::Unbounded);
        }
        let (n, frame) = (self.dim(), Frame::around(hull, 1.0)?);
        // r = half (1 + zeta), |zeta| <= 1; no ball is larger than the box is wide.
        let half = 0.5 * frame.scales.iter().copied().fold(f64::INFINITY, f64::min);
        let lengths: Vec<Interval> = (0..self.num_half_spaces()).map(|i| self.length(i)).collect();
        frame.load(self, Some(&|i| mul_down(half, lengths[i].lo())), workspace)?;
        let mut objective = vec![0.0; n + 1];
        objective[n] = 1.0;
        let Ok(solution) = prepared(&mut workspace.solver)?.maximize(&objective) else {
            return Err(SetError::Overflow { row: 0 });
        };
        if solution.bound == f64::NEG_INFINITY {
            return Err(SetError::EmptySet);
        }
        let radius_bound = mul_up(half, add_up(1.0, solution.bound)).max(0.0);
        let place = |j: usize| frame.center[j] + frame.scales[j] * solution.point[j];
        let center: Vec<f64> = (0..n).map(place).collect();
        let at_center = Frame { center: center.clone(), scales: vec![1.0; n] };
        let mut radius = radius_bound;
        for (i, length) in lengths.iter().enumerate() {
            let slack = at_center.slack(self, i).lo();
            if length.hi() > 0.0 {
                radius = radius.min(div_down(slack, if slack < 0.0 { length.lo() } else { length.hi() }));
            } else if self.offsets[i] < 0.0 {
                // A normal of zeros: `0 <= h_i` is wrong, and nothing was rounded.
                return Err(SetError::EmptySet);
            }
        }
        Ok(ChebyshevBall { center, radius, radius_bound })
    }

    /// Encloses `|a_i|_2`.
    pub(super) fn length(&self, i: usize) -> Interval {
        // Scaled by the largest entry, so that squares neither overflow nor vanish.
        let largest = self.normal(i).fold(0.0, |largest: f64, a| largest.max(a.abs()));
        if largest == 0.0 {
            return Interval::ZERO;
        }
        let sum =
            self.normal(i).fold(Interval::ZERO, |sum, a| sum + (Interval::point(a) / Interval::point(largest)).sqr());
        let root = Interval::new(sqrt_down(sum.lo()), sqrt_up(sum.hi()));
        root.map_or(Interval::ZERO, |root| root.scale(largest))
    }
}
