//! A box around a polytope, and the proof that there is one, from linear programs.

use scalars::Interval;
use scalars::rounding::{add_up, div_up, mul_up, sub_up};

use super::HPolytope;
use super::frame::Frame;
use crate::constrained_zonotope::prepared;
use crate::support_function::empty_as_a_whole;
use crate::{IntervalVector, SetError, Workspace};

/// Most times that a box is refined by programs over itself.
const ROUNDS: usize = 12;

/// A box is refined again while a side shrinks below this share.
const SHRINKS: f64 = 0.25;

/// Sizes of the frames in which multipliers are sought, over the sizes of the axes.
const REACHES: [f64; 5] = [32.0, 1e4, 1e8, 1e15, 1e30];

/// Rows nearer to the origin than this share of the farthest say nothing about the size of the set.
const NEAR: f64 = 1e-12;

impl HPolytope {
    /// A box around the set, by linear programs: for many rows, where [`interval_hull`](Self::interval_hull) enumerates vertices.
    ///
    /// Boundedness is proven by multipliers: for `y >= 0` every member has `x_j <= y'h + (e_j - H'y)'x`, and where the 1-norms of the
    /// residuals `e_j - H'y` are at most `q < 1` for all `+-e_j`, that gives `|x|_max <= max_j y'h / (1 - q)`. Programs over the box so
    /// found refine it, each answered by weak duality ([`boxlp`]).
    ///
    /// **Guarantee:** superset of the exact hull; empty only if the set is proven empty. Sides for which no bound is proven, as those of
    /// unbounded sets, are unbounded.
    ///
    /// # Errors
    /// [`SetError::TooLarge`] above 2^24 rows or dimensions.
    ///
    /// ```
    /// # use setrep::{HPolytope, Matrix, Workspace};
    /// let h = Matrix::from_rows(&[&[-1.0, 0.0], &[0.0, -1.0], &[1.0, 2.0]])?;
    /// let hull = HPolytope::new(h, &[0.0, 0.0, 1.0])?.bounding_box(&mut Workspace::new())?;
    /// assert!(hull.contains(&[1.0, 0.5]) && hull[1].width() < 0.5 + 1e-13);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn bounding_box(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        let mut hull = self.axis_rows();
        let magnitudes = self.magnitudes();
        for reach in REACHES {
            if hull.iter().all(|side| side.is_empty() || side.is_bounded()) {
                break;
            }
            let proven = self.bounded_by_multipliers(&magnitudes, reach, workspace)?;
            hull = hull.iter().zip(proven.iter()).map(|(a, b)| a.intersection(*b)).collect();
        }
        if hull.iter().any(|side| side.is_empty() || !side.is_bounded()) {
            return Ok(empty_as_a_whole(hull));
        }
        for _ in 0..ROUNDS {
            let before: Vec<f64> = hull.iter().map(Interval::width).collect();
            self.refine(&mut hull, workspace)?;
            if hull[0].is_empty() || hull.iter().zip(before).all(|(side, width)| side.width() >= SHRINKS * width) {
                break;
            }
        }
        Ok(hull)
    }

    /// The box of the rows with a single nonzero coefficient.
    fn axis_rows(&self) -> IntervalVector {
        let n = self.dim();
        let mut hull = IntervalVector::new(vec![Interval::ENTIRE; n]);
        for (i, &offset) in self.offsets.iter().enumerate() {
            let mut nonzeros = (0..n).filter(|&k| self.normals[(i, k)] != 0.0);
            if let (Some(k), None) = (nonzeros.next(), nonzeros.next()) {
                let a = self.normals[(i, k)];
                let end = if a.abs() == 1.0 { offset } else { div_up(offset, a.abs()) };
                let side =
                    if a > 0.0 { Interval::new(f64::NEG_INFINITY, end) } else { Interval::new(-end, f64::INFINITY) };
                hull[k] = hull[k].intersection(side.unwrap_or(Interval::ENTIRE));
            }
        }
        hull
    }

    /// Sizes of the axes: the geometric means of `|h_i / a_ik|` over the rows that are not near the origin against the others; 1 for an
    /// axis without one.
    fn magnitudes(&self) -> Vec<f64> {
        let distance = |i: usize| self.offsets[i].abs() / self.normal(i).fold(0.0, |m: f64, a| m.max(a.abs()));
        let distances: Vec<f64> = (0..self.num_half_spaces()).map(distance).collect();
        let near = NEAR * distances.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
        let mean = |column: &[f64]| {
            let far = column.iter().zip(&self.offsets).zip(&distances).filter(|(_, distance)| **distance > near);
            let logarithms = far.map(|((a, h), _)| (h / a).abs().ln()).filter(|x| x.is_finite());
            let (sum, count) = logarithms.fold((0.0, 0_u32), |(sum, count), x| (sum + x, count + 1));
            if count == 0 { 1.0 } else { (sum / f64::from(count)).exp() }
        };
        self.normals.columns().map(mean).collect()
    }

    /// The box of multipliers found in a frame of half-widths `reach magnitudes`, unbounded if they do not prove one.
    ///
    /// The offsets are raised to zero while the multipliers are sought, so that the origin is a member of the set: any `y >= 0` will
    /// do, and those of an empty set have no optimum to be read from.
    fn bounded_by_multipliers(
        &self,
        magnitudes: &[f64],
        reach: f64,
        workspace: &mut Workspace,
    ) -> Result<IntervalVector, SetError> {
        let n = self.dim();
        let entire = IntervalVector::new(vec![Interval::ENTIRE; n]);
        let side = |x: &f64| Interval::ZERO.inflate((reach * x).min(1e290));
        let frame = Frame::around(&magnitudes.iter().map(side).collect::<Vec<_>>(), 1.0)?;
        let raised = Self { normals: self.normals.clone(), offsets: self.offsets.iter().map(|h| h.max(0.0)).collect() };
        if let Err(error) = frame.load(&raised, None, workspace) {
            // Rows that overflow in the frame.
            return if matches!(error, SetError::TooLarge { .. }) { Err(error) } else { Ok(entire) };
        }
        let solver = prepared(&mut workspace.solver)?;
        let mut bounds = Vec::with_capacity(2 * n);
        for k in 0..2 * n {
            let mut objective = vec![0.0; n];
            objective[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
            let multipliers: Vec<(usize, f64)> = match solver.maximize(&objective) {
                Ok(solution) => solution.multipliers.iter().copied().filter(|(_, y)| *y > 0.0).collect(),
                Err(_) => return Ok(entire),
            };
            // xi_k <= value + residual'xi.
            let mut value = Interval::ZERO;
            let mut residual: Vec<Interval> = objective.iter().map(|&x| Interval::point(x)).collect();
            for (i, y) in multipliers {
                value += Interval::point(self.offsets[i]).scale(y);
                for (j, a) in self.normal(i).enumerate() {
                    residual[j] -= Interval::point(a).scale(y).scale(frame.scales[j]);
                }
            }
            let norm = residual.iter().fold(0.0, |sum, x| add_up(sum, x.mag()));
            bounds.push((value.hi(), norm));
        }
        let (value, norm) =
            bounds.iter().fold((0.0_f64, 0.0_f64), |(v, q), &(value, norm)| (v.max(value), q.max(norm)));
        if !(norm <= 0.5 && value.is_finite()) {
            return Ok(entire);
        }
        let largest = div_up(value, -sub_up(norm, 1.0));
        let end = |k: usize| mul_up(add_up(bounds[k].0, mul_up(bounds[k].1, largest)), frame.scales[k / 2]);
        Ok((0..n).map(|j| Interval::new(-end(2 * j + 1), end(2 * j)).unwrap_or(Interval::EMPTY)).collect())
    }

    /// Cuts a bounded box around the set down by the programs of its sides.
    fn refine(&self, hull: &mut IntervalVector, workspace: &mut Workspace) -> Result<(), SetError> {
        // Where numbers overflow at this size the box stays as it is.
        let Ok(frame) = Frame::around(hull, 1.0) else { return Ok(()) };
        match frame.load(self, None, workspace) {
            Err(error @ SetError::TooLarge { .. }) => return Err(error),
            Err(_) => return Ok(()),
            Ok(()) => {}
        }
        let solver = prepared(&mut workspace.solver)?;
        let mut objective = vec![0.0; self.dim()];
        for j in 0..self.dim() {
            let mut reach = |sign: f64| {
                objective.fill(0.0);
                objective[j] = sign;
                solver.maximize(&objective).map_or(1.0, |solution| solution.bound)
            };
            let (hi, lo) = (reach(1.0), -reach(-1.0));
            let side =
                Interval::new(lo, hi).map_or(Interval::EMPTY, |xi| xi.scale(frame.scales[j]).add_f64(frame.center[j]));
            hull[j] = hull[j].intersection(side);
        }
        if hull.iter().any(Interval::is_empty) {
            hull.fill(Interval::EMPTY);
        }
        Ok(())
    }
}
