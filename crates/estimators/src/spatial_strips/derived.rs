//! Rows that say that the correction is a rotation of a cell; derived each time, none of them kept.
//!
//! With `Z = exp(r) C`, the nine coordinates of `Y = Z C' = exp(r)` lie in the ranges that [`coordinates`] gives for the box of `r`; each is linear in
//! `Z`: `Y_ab = sum_l Z_al C_bl`. Those of second order are functions of the first, `Y_ii = 1 - k (u_j^2 + u_l^2)` and `off_i = k u_j u_l` with
//! `k = 1 / (1 + cos |r|)` in `[1/2, k_2]`, which gives more rows:
//!
//! ```text
//! Y_ii + a u_j <= 1 + a^2 / 2                                         (u^2 >= 2 a u - a^2, a an end of u_j)
//! +- off_i -+ (a u_l + b u_j) / 2 <= -+ a b / 2 + (k_2 - 1/2) |u_j| |u_l|       (products of u_j and u_l with their ends, McCormick)
//! ```
//!
//! They are exact at the ends of the box, which is where the programs look.

use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::SpatialStrips;
use super::cell::Cell;
use super::space::{Block, matrix_of};
use super::spread::{OTHERS, coordinates};
use crate::EstimatorError;
use crate::invariant_strips::{Origin, Tag};

/// Coordinates of rotations are asked for by weights.
pub(super) type Weights = [f64; 9];

impl SpatialStrips {
    /// Appends the rows of a cell.
    pub(super) fn push_derived(&mut self, cell: &Cell) -> Result<(), EstimatorError> {
        let center = matrix_of(&cell.center);
        let ranges = coordinates(&cell.turn);
        for (i, range) in ranges.iter().enumerate() {
            for (sign, limit) in [(1.0, range.hi()), (-1.0, -range.lo())] {
                self.push_coordinates(&center, &weighted(&[(i, sign)]), limit)?;
            }
        }
        let square = cell.turn.iter().fold(Interval::ZERO, |sum, side| sum + side.sqr());
        let cosine = square.stumpff(0);
        if square.hi() > 6.0 || cosine.lo() <= -0.9 {
            return Ok(());
        }
        let most = (Interval::ONE / (Interval::ONE + Interval::point(cosine.lo()))).hi();
        for (i, (j, l)) in OTHERS.into_iter().enumerate() {
            for (axis, end) in [(j, ranges[j].hi()), (j, ranges[j].lo()), (l, ranges[l].hi()), (l, ranges[l].lo())] {
                let limit = add_up(1.0, 0.5 * mul_up(end, end));
                self.push_coordinates(&center, &weighted(&[(3 + i, 1.0), (axis, end)]), limit)?;
            }
            let slack = mul_up(most - 0.5, mul_up(ranges[j].mag(), ranges[l].mag()));
            let slack = add_up(slack, 1e-15);
            for (sign, a, b) in [
                (-1.0, ranges[j].lo(), ranges[l].lo()),
                (-1.0, ranges[j].hi(), ranges[l].hi()),
                (1.0, ranges[j].hi(), ranges[l].lo()),
                (1.0, ranges[j].lo(), ranges[l].hi()),
            ] {
                // sign (off - (a u_l + b u_j - a b) / 2) <= slack.
                let limit = (Interval::point(a) * Interval::point(b)).scale(-0.5 * sign).hi();
                let weights = weighted(&[(6 + i, sign), (l, -0.5 * sign * a), (j, -0.5 * sign * b)]);
                self.push_coordinates(&center, &weights, add_up(limit, slack))?;
            }
        }
        Ok(())
    }

    fn push_coordinates(&mut self, center: &Block, weights: &Weights, limit: f64) -> Result<(), EstimatorError> {
        let lost = self.aim_at_coordinates(center, weights);
        let tag = Tag { origin: Origin::Derived, class: 0, born: self.instant, used: 0 };
        self.push_row(add_up(limit, lost), tag)
    }

    /// The weighted sum of the coordinates of `Z C'`, into `self.normal`; by how much its value is off at most.
    pub(super) fn aim_at_coordinates(&mut self, center: &Block, weights: &Weights) -> f64 {
        self.exact.fill(Interval::ZERO);
        for (i, (j, k)) in OTHERS.into_iter().enumerate() {
            let (u, diagonal, off) = (0.5 * weights[i], weights[3 + i], 0.5 * weights[6 + i]);
            // u_i = (Y_kj - Y_jk) / 2, off_i = (Y_kj + Y_jk) / 2.
            for (a, b, weight) in [(k, j, u), (j, k, -u), (i, i, diagonal), (k, j, off), (j, k, off)] {
                if weight == 0.0 {
                    continue;
                }
                for l in 0..3 {
                    self.exact[3 * a + l] += center[b][l].scale(weight);
                }
            }
        }
        self.round()
    }
}

/// The weights that are not 0.
pub(super) fn weighted(entries: &[(usize, f64)]) -> Weights {
    let mut weights = [0.0; 9];
    for &(i, weight) in entries {
        weights[i] += weight;
    }
    weights
}
