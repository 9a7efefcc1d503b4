//! A box around a polytope as the unit box of a linear program.

use scalars::Interval;
use scalars::rounding::{ETA, add_down, add_up};

use super::HPolytope;
use super::error_free::dot_compensated;
use crate::bounds::power_of_two_below;
use crate::constrained_zonotope::{prepared, refused};
use crate::{SetError, Workspace};

/// Coordinates `x = c + diag(s) xi` with `|xi_j| <= 1`, `s` powers of two: rows scale exactly, only `h - H c` rounds.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    pub(super) center: Vec<f64>,
    pub(super) scales: Vec<f64>,
}

impl Frame {
    /// Coordinates of a bounded box, with `s` positive, at least `margin` times and less than `2 margin` times its radii (unless these
    /// are tiny); `margin` is a power of two.
    pub(super) fn around(sides: &[Interval], margin: f64) -> Result<Self, SetError> {
        let mut frame = Self { center: Vec::new(), scales: Vec::new() };
        frame.assign_around(sides, margin)?;
        Ok(frame)
    }

    /// [`around`](Self::around) into the memory of this frame, which an error leaves as it was.
    pub(super) fn assign_around(&mut self, sides: &[Interval], margin: f64) -> Result<(), SetError> {
        let scale = |side: &Interval| power_of_two_above(margin * side.rad());
        if let Some(row) = sides.iter().position(|side| !scale(side).is_finite()) {
            return Err(SetError::Overflow { row });
        }
        self.center.clear();
        self.center.extend(sides.iter().map(Interval::mid));
        self.scales.clear();
        self.scales.extend(sides.iter().map(scale));
        Ok(())
    }

    /// Loads `H x <= h` into the solver of the workspace, each offset rounded up: a superset of the part of the set in the frame.
    ///
    /// `extra` appends a variable with the coefficients `extra(i)` and moves the offsets by `-extra(i)`.
    pub(super) fn load(
        &self,
        polytope: &HPolytope,
        extra: Option<&dyn Fn(usize) -> f64>,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        let (n, m) = (polytope.dim(), polytope.num_half_spaces());
        let Workspace { solver, matrix, scales: lower, row_sums: upper, .. } = workspace;
        matrix.clear();
        for (column, &s) in polytope.normals.columns().zip(&self.scales) {
            matrix.extend(column.iter().map(|a| a * s));
        }
        lower.clear();
        lower.resize(m, f64::NEG_INFINITY);
        upper.clear();
        upper.extend((0..m).map(|i| self.slack(polytope, i).hi()));
        if let Some(extra) = extra {
            matrix.extend((0..m).map(extra));
            upper.iter_mut().enumerate().for_each(|(i, h)| *h = add_up(*h, -extra(i)));
        }
        let columns = n + usize::from(extra.is_some());
        prepared(solver)?.load_columns(columns, matrix, lower, upper).map_err(refused)
    }

    /// Encloses `h_i - a_i'c`, widened by what underflow takes from the scaled row.
    pub(super) fn slack(&self, polytope: &HPolytope, i: usize) -> Interval {
        let row: Vec<f64> = polytope.normal(i).chain([polytope.offsets[i]]).collect();
        let point: Vec<f64> = self.center.iter().map(|c| -c).chain([1.0]).collect();
        let (value, error) = dot_compensated(&row, &point);
        let lost = self.underflow(polytope.normal(i));
        let (low, high) = if error == 0.0 { (value, value) } else { (add_down(value, -error), add_up(value, error)) };
        let range = Interval::new(low, high).unwrap_or(Interval::ENTIRE);
        if lost == 0.0 { range } else { range.inflate(lost) }
    }

    /// What underflow takes from `sum_j (a_j s_j) xi_j`.
    pub(super) fn underflow(&self, row: impl Iterator<Item = f64>) -> f64 {
        let inexact = row.zip(&self.scales).filter(|(a, s)| (a * *s) / *s != *a).count();
        inexact as f64 * ETA
    }
}

/// The least power of two not below `x`, which is not negative, and not below `2^-1000`; infinite where it overflows.
fn power_of_two_above(x: f64) -> f64 {
    let clamped = x.max(2f64.powi(-1000));
    let floor = power_of_two_below(clamped);
    if floor < clamped { 2.0 * floor } else { floor }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_powers_of_two_that_cover() {
        let pairs = [(1.0, 1.0), (1.1, 2.0), (3e-5, 2f64.powi(-15)), (1e300, 2f64.powi(997)), (1.7e308, f64::INFINITY)];
        for (x, power) in pairs.into_iter().chain([(0.0, 2f64.powi(-1000)), (f64::INFINITY, f64::INFINITY)]) {
            assert_eq!(power_of_two_above(x), power, "{x}");
        }
    }
}
