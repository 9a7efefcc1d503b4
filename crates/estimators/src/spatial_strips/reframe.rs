//! The box in which the linear programs are solved, and the coordinates that start anew with it.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::SpatialStrips;
use super::frame::{ENTRIES, Frame};
use super::space::Region;
use crate::EstimatorError;

/// How many radii of the hull the box reaches beyond it: the coordinates drift away from it by the noise of the turns.
const MARGIN: f64 = 16.0;

impl SpatialStrips {
    /// Starts the coordinates anew if the set may have left its box.
    pub(super) fn fit_box(&mut self) -> Result<(), EstimatorError> {
        let mut sides = self.reach.as_flattened().iter().enumerate();
        if sides.all(|(k, side)| self.rows.holds(ENTRIES + k, side)) { Ok(()) } else { self.start_anew() }
    }

    /// `q_j = x_j` from now on.
    ///
    /// With `W = T^-1`, `q = W (x - o - Z S)`; so with `f_j = sum_i W_ij e_i` a row has `D' = D - sum f_j S_j'`, `e'_j = f_j` and
    /// `h' = h + sum <f_j, o_j>`, rounded, and a bound of the rounding joins it.
    pub(super) fn start_anew(&mut self) -> Result<(), EstimatorError> {
        fill_sides(&mut self.sides, &self.enclosure.vectors, &self.room);
        let Self { frame, exact, enclosure, rows, .. } = self;
        rows.reframe(&self.sides, |_, normal, offset| {
            *offset = restated(frame, exact, &enclosure.vectors, normal, *offset);
        })?;
        self.frame.begin();
        self.reach.clone_from(&self.enclosure.vectors);
        Ok(())
    }
}

/// Rewrites a normal; its new offset.
fn restated(frame: &Frame, exact: &mut [Interval], vectors: &[Region], normal: &mut [f64], offset: f64) -> f64 {
    let n = vectors.len();
    let mut limit = Interval::point(offset);
    for (exact, entry) in exact.iter_mut().zip(&*normal) {
        *exact = Interval::point(*entry);
    }
    for j in (0..n).rev() {
        for k in 0..3 {
            // Entries of earlier vectors are still those of the row.
            let f =
                (0..=j).fold(Interval::ZERO, |f, i| f + frame.inverse[i * n + j].scale(normal[ENTRIES + 3 * i + k]));
            exact[ENTRIES + 3 * j + k] = f;
            for l in 0..3 {
                exact[3 * k + l] -= f.scale(frame.path[j][l]);
            }
            limit += f.scale(frame.shift[j][k]);
        }
    }
    let mut lost = 0.0;
    for (k, (entry, exact)) in normal.iter_mut().zip(&*exact).enumerate() {
        *entry = exact.mid();
        let farthest = if k < ENTRIES { 1.0 } else { vectors.as_flattened()[k - ENTRIES].mag() };
        lost = add_up(lost, mul_up(exact.rad(), farthest));
    }
    // An infinite offset stays one.
    if offset == f64::INFINITY { offset } else { add_up(limit.hi(), lost) }
}

/// A box around the embedded set with room for it to drift.
pub(super) fn fill_sides(sides: &mut Vec<Interval>, vectors: &[Region], room: &[f64]) {
    sides.clear();
    sides.extend([Interval::ONE.hull(-Interval::ONE); ENTRIES]);
    for (hull, &room) in vectors.iter().zip(room) {
        sides.extend(hull.map(|side| side.inflate(add_up(mul_up(MARGIN, side.rad()), room))));
    }
}
