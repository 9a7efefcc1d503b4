//! Supports of rows in a box, and what carries them.

use boxlp::Status;
use scalars::rounding::add_up;

use super::{BoxedRows, moved_up};
use crate::SetError;
use crate::constrained_zonotope::refused;
use crate::polytope::frame::Frame;
use crate::polytope::row_contradiction::RowContradiction;
use crate::polytope::solve::dot_upper;
use crate::support_function::check_direction;

impl BoxedRows {
    /// Support function `max { d'x : x in B, a_i'x <= h_i }`, shape `d: n`.
    ///
    /// **Guarantee:** an upper bound of the exact value; `-inf` only if the rows are proven to contradict each other, see
    /// [`contradiction`](Self::contradiction).
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction.
    pub fn support(&mut self, direction: &[f64]) -> Result<f64, SetError> {
        check_direction(self.dim(), direction, None)?;
        self.synchronize()?;
        let Frame { center, scales } = &self.frame;
        self.scaled.clear();
        self.scaled.extend(direction.iter().zip(scales).map(|(d, s)| d * s));
        self.active.clear();
        // Of the right length, an objective is refused only if it overflows.
        let Ok(solution) = self.solver.maximize(&self.scaled) else { return Ok(f64::INFINITY) };
        self.active.extend_from_slice(solution.multipliers);
        let inner = if solution.status == Status::Empty {
            let proof = RowContradiction::new(self, &self.active);
            if proof.verify() {
                self.contradiction = Some(proof);
                return Ok(f64::NEG_INFINITY);
            }
            // Not confirmed: the bound of the box alone.
            scalars::rounding::sum_up(self.scaled.iter().map(|c| c.abs()))
        } else {
            solution.bound
        };
        let lost = self.frame.underflow(direction.iter().copied());
        let inner = if lost == 0.0 { inner } else { add_up(inner, lost) };
        let value = add_up(dot_upper(direction, center), inner);
        Ok(if value.is_nan() { f64::INFINITY } else { value })
    }

    /// The rows that carry the last [`support`](Self::support), each with its multiplier; none if the box does.
    #[must_use]
    pub fn active(&self) -> &[(usize, f64)] {
        &self.active
    }

    /// The proof of the last support that was `-inf`.
    #[must_use]
    pub fn contradiction(&self) -> Option<&RowContradiction> {
        self.contradiction.as_ref()
    }

    fn synchronize(&mut self) -> Result<(), SetError> {
        if self.moved {
            for (i, (&offset, &shift)) in self.offsets.iter().zip(&self.shifts).enumerate() {
                self.solver.set_range(i, f64::NEG_INFINITY, moved_up(offset, shift)).map_err(refused)?;
            }
            self.moved = false;
        }
        Ok(())
    }
}
