//! What a user asks of the set.

use lie_groups::{Enclose, LieGroup, SO3};
use scalars::Interval;

use super::SpatialStrips;
use super::frame::ENTRIES;
use super::space::{AXES, Block, Region, Vector, apply, inner, largest_length, matrix, middle, middle_of, point};
use crate::error::check_size;
use crate::{EstimatorError, SpatialBox};

/// How a box of states lies to the set, as far as it is proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Position {
    Inside,
    Outside,
    Open,
}

impl SpatialStrips {
    /// Number of predictions so far.
    #[must_use]
    pub fn step_count(&self) -> u64 {
        self.step
    }

    /// Number of rows kept: past measurements and bounds.
    #[must_use]
    pub fn num_rows(&self) -> usize {
        self.rows.len()
    }

    /// Linear programs solved by the last update.
    #[must_use]
    pub fn programs(&self) -> usize {
        self.programs
    }

    /// Number of cells of attitudes: 1 once the attitude is known well.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// The attitude that the turns so far add up to, `P`.
    #[must_use]
    pub fn reference_attitude(&self) -> &SO3<f64> {
        &self.frame.attitude
    }

    /// Whether the set and a box of states are proven disjoint: some row, all cells or a vector exclude all of them.
    ///
    /// **Guarantee:** true only if no state of the box is in the set.
    ///
    /// # Errors
    /// A box with another number of vectors, an empty or unbounded side.
    pub fn excludes(&self, states: &SpatialBox) -> Result<bool, EstimatorError> {
        Ok(self.position_of(states)? == Position::Outside)
    }

    /// Whether a box of states is proven to lie in the set.
    ///
    /// **Guarantee:** true only if every state of the box is.
    ///
    /// # Errors
    /// As [`excludes`](Self::excludes).
    pub fn includes(&self, states: &SpatialBox) -> Result<bool, EstimatorError> {
        Ok(self.position_of(states)? == Position::Inside)
    }

    fn position_of(&self, states: &SpatialBox) -> Result<Position, EstimatorError> {
        states.check()?;
        check_size("vectors of the world", self.frame.vectors(), states.vectors.len())?;
        let turn = super::space::exp(&states.turn_rad);
        let back = self.frame.attitude.enclose().inverse();
        let correction = turn.compose(&states.center.enclose()).compose(&back);
        let Some(mut inside) = self.cells_hold(&correction) else { return Ok(Position::Outside) };
        let known = self.enclosure.vectors.as_flattened();
        for (known, asked) in known.iter().zip(states.vectors.as_flattened()) {
            if known.disjoint(asked) {
                return Ok(Position::Outside);
            }
            inside &= asked.subset_of(known);
        }
        let z = matrix(&correction);
        for i in 0..self.rows.len() {
            let value = self.row_range(i, &z, &states.vectors);
            let limit = self.rows.offsets()[i];
            if value.lo() > limit {
                return Ok(Position::Outside);
            }
            inside &= value.hi() <= limit;
        }
        Ok(if inside { Position::Inside } else { Position::Open })
    }

    /// Whether corrections are proven to lie in one cell; none if they are proven to lie in none.
    fn cells_hold(&self, correction: &SO3<Interval>) -> Option<bool> {
        let (mut possible, mut inside) = (false, false);
        for cell in &self.cells {
            let Ok(turn) = correction.compose(&cell.center.enclose().inverse()).log() else {
                possible = true;
                continue;
            };
            let turn: Region = [turn[0], turn[1], turn[2]];
            // Vectors below half a turn are unique.
            let unique = largest_length(&cell.turn) < core::f64::consts::PI;
            possible |= !unique || (0..3).all(|k| !turn[k].disjoint(&cell.turn[k]));
            inside |= (0..3).all(|k| turn[k].subset_of(&cell.turn[k]));
        }
        possible.then_some(inside)
    }

    /// Encloses the value of row `i`: `<D, Z> + sum <f_j, x_j - o_j - Z S_j>` with `f_j = sum_i W_ij e_i`.
    fn row_range(&self, i: usize, z: &Block, vectors: &[Region]) -> Interval {
        let (normal, n) = (self.rows.normal(i), vectors.len());
        let mut lever: Block = core::array::from_fn(|k| core::array::from_fn(|l| Interval::point(normal[3 * k + l])));
        let mut value = Interval::ZERO;
        for j in 0..n {
            let f: Region = core::array::from_fn(|k| {
                (0..=j)
                    .fold(Interval::ZERO, |f, i| f + self.frame.inverse[i * n + j].scale(normal[ENTRIES + 3 * i + k]))
            });
            for k in 0..3 {
                for l in 0..3 {
                    lever[k][l] -= f[k].scale(self.frame.path[j][l]);
                }
                value += f[k] * (vectors[j][k] - Interval::point(self.frame.shift[j][k]));
            }
        }
        (0..3).fold(value, |value, k| value + inner(&lever[k], &z[k]))
    }

    /// A point in the middle of the set, into `self.middle`; rounded.
    pub(super) fn find_middle(&mut self) {
        let cell = &self.cells[self.cells.len() / 2];
        let turned = super::space::exp_of(middle(&cell.turn)).compose(&cell.center);
        // Inward of the rotations, as the hull of a cell is.
        let depth = (0.5 * cell.size().min(1.5)).cos();
        let z = middle_of(&super::space::matrix_of(&turned)).map(|row| row.map(|x| depth * x));
        self.middle.clear();
        self.middle.extend(z.as_flattened());
        let n = self.frame.vectors();
        let exact = z.map(point);
        let frame = &self.frame;
        for i in 0..n {
            let mut q: Vector = [0.0; 3];
            for j in i..n {
                let led = middle(&apply(&exact, &point(frame.path[j])));
                for k in 0..3 {
                    let x = self.enclosure.vectors[j][k].mid() - frame.shift[j][k] - led[k];
                    q[k] += frame.inverse[i * n + j].mid() * x;
                }
            }
            self.middle.extend(q);
        }
        debug_assert_eq!(self.middle.len(), ENTRIES + AXES.len() * n);
    }
}
