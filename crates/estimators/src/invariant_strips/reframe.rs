//! The box in which the linear programs are solved, and the coordinates `q = x - S z` that start anew with it.

use scalars::Interval;
use scalars::rounding::{UNIT_ROUNDOFF, add_up, mul_up};

use super::InvariantStrips;
use super::embedding::Embedding;
use super::plane::{Region, largest_modulus, norm1};
use crate::error::check_finite;
use crate::{EstimatorError, PlanarBox};

/// How many radii of the hull the box reaches beyond it: the coordinates drift away from it by the noise of the turns.
const MARGIN: f64 = 16.0;

impl InvariantStrips {
    /// Starts the coordinates anew if the set may have left its box.
    pub(super) fn fit_box(&mut self) -> Result<(), EstimatorError> {
        let fits = self.reach.iter().enumerate().all(|(j, reach)| {
            let column = self.embedding.fixed(j);
            (0..2).all(|k| self.rows.holds(column + k, &reach[k]))
        });
        if fits { Ok(()) } else { self.start_anew() }
    }

    /// `S = 0`: the heading part of each row becomes `a - conj(S) d`, whose rounding is added to the offset.
    pub(super) fn start_anew(&mut self) -> Result<(), EstimatorError> {
        fill_sides(&mut self.sides, self.embedding, &self.enclosure, &self.drift);
        let (embedding, path, farthest) = (self.embedding, &self.path, self.enclosure.scale.hi());
        // Rows that would overflow are found before any of them is rewritten.
        let steepest = path.iter().fold(0.0, |sum, s| sum + norm1(*s));
        for i in 0..self.rows.len() {
            let size = norm1([self.rows.normal(i)[0], self.rows.normal(i)[1]]) + 2.0 * steepest;
            check_finite("rows in new coordinates", &[8.0 * size * farthest.max(1.0)])?;
        }
        self.rows.reframe(&self.sides, |_, normal, offset| {
            let mut size = norm1([normal[0], normal[1]]);
            for (j, s) in path.iter().enumerate() {
                let column = embedding.fixed(j);
                let d = [normal[column], normal[column + 1]];
                normal[0] -= s[0] * d[0] + s[1] * d[1];
                normal[1] -= s[0] * d[1] - s[1] * d[0];
                size += norm1(*s) * norm1(d);
            }
            // Each entry suffers three roundings of at most `size` for each vector.
            let roundings = 8.0 * (1 + path.len()) as f64;
            *offset = add_up(*offset, mul_up(farthest, roundings * UNIT_ROUNDOFF * size));
        })?;
        self.spans.clear();
        self.path.iter_mut().for_each(|s| *s = [0.0; 2]);
        self.reach.clone_from(&self.enclosure.fixed);
        Ok(())
    }
}

/// A box around the embedded set with room for it to drift.
pub(super) fn fill_sides(sides: &mut Vec<Interval>, embedding: Embedding, set: &PlanarBox, drift: &[f64]) {
    let disc = |radius: f64| Interval::ZERO.inflate(radius);
    sides.clear();
    sides.extend([disc(set.scale.hi()); 2]);
    for (hull, &drift) in set.fixed.iter().zip(drift) {
        sides.extend(hull.map(|side| side.inflate(add_up(MARGIN * side.rad(), drift))));
    }
    for arm in &set.body {
        sides.extend([disc(largest_modulus(arm)); 2]);
    }
    debug_assert_eq!(sides.len(), embedding.dim());
}

/// Encloses `e^{i phi} X` over a box of headings and arms.
pub(super) fn turned_arm(unit_heading: &Region, arm: &Region) -> Region {
    super::plane::product(unit_heading, arm)
}
