//! What the rows say about one cell and the vectors: by linear programs, each bound proven.

use scalars::Interval;
use scalars::rounding::add_up;

use super::SpatialStrips;
use super::cell::Cell;
use super::derived::weighted;
use super::space::{AXES, Region, matrix_of};
use crate::EstimatorError;
use crate::invariant_strips::Origin;

/// Most passes over a cell, and the share of its sides that a pass must take off for another one.
const PASSES: usize = 6;
const WORTHWHILE: f64 = 0.05;

impl SpatialStrips {
    /// The cell, smaller, again while it shrinks a good deal; none if the rows leave nothing of it.
    pub(super) fn contracted(&mut self, mut cell: Cell) -> Result<Option<Cell>, EstimatorError> {
        let rows = self.rows.len();
        for _ in 0..PASSES {
            let before: f64 = cell.turn.iter().map(Interval::rad).sum();
            cell.recenter()?;
            self.push_derived(&cell)?;
            if !self.tighten(&mut cell)? {
                return self.refuted(rows).map(|()| None);
            }
            self.keep(rows);
            if cell.turn.iter().map(Interval::rad).sum::<f64>() > (1.0 - WORTHWHILE) * before {
                break;
            }
        }
        Ok(Some(cell))
    }

    /// `r_i = u_i / sinc |r|` with bounds of `u_i` by two programs, for each `i`; false if nothing is left.
    fn tighten(&mut self, cell: &mut Cell) -> Result<bool, EstimatorError> {
        let center = matrix_of(&cell.center);
        for i in 0..3 {
            let mut ends = [0.0; 2];
            for (end, sign) in ends.iter_mut().zip([1.0, -1.0]) {
                let lost = self.aim_at_coordinates(&center, &weighted(&[(i, sign)]));
                let value = self.bound()?;
                if self.emptied {
                    return Ok(false);
                }
                *end = add_up(value, lost);
            }
            let Ok(u) = Interval::new(-ends[1], ends[0]) else { return Ok(false) };
            let square = cell.turn.iter().fold(Interval::ZERO, |sum, side| sum + side.sqr());
            let sinc = square.stumpff(1);
            if sinc.lo() > 0.0 {
                cell.turn[i] = cell.turn[i].intersection(u / sinc);
                if cell.turn[i].is_empty() {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// The boxes of the vectors over all cells; cells that the programs refute are dropped.
    pub(super) fn contract_vectors(&mut self) -> Result<(), EstimatorError> {
        let rows = self.rows.len();
        let mut seen = core::mem::take(&mut self.seen);
        seen.clear();
        seen.resize(self.frame.vectors(), [Interval::EMPTY; 3]);
        let mut at = 0;
        while at < self.cells.len() {
            let cell = self.cells[at];
            self.push_derived(&cell)?;
            if self.join_vectors(&mut seen)? {
                self.keep(rows);
                at += 1;
            } else {
                self.refuted(rows)?;
                self.cells.remove(at);
            }
        }
        for (j, seen) in seen.iter().enumerate() {
            for k in 0..3 {
                let known = self.enclosure.vectors[j][k];
                let common = known.intersection(seen[k]);
                if common.is_empty() {
                    return Err(self.disjoint(known, seen[k]));
                }
                self.enclosure.vectors[j][k] = common;
            }
        }
        self.seen = seen;
        Ok(())
    }

    /// Adds the boxes of the vectors on the cell whose rows are in place; false, and nothing of use, if there are none.
    fn join_vectors(&mut self, seen: &mut [Region]) -> Result<bool, EstimatorError> {
        // A part of the hull may be joined before the cell is refuted: a superset all the same.
        for (j, seen) in seen.iter_mut().enumerate() {
            for k in 0..3 {
                let mut ends = [0.0; 2];
                for (end, sign) in ends.iter_mut().zip([1.0, -1.0]) {
                    let u = AXES[k].map(|x| Interval::point(sign * x));
                    let constant = self.frame.aim(&mut self.exact, Some(j), &u, &[Interval::ZERO; 3]);
                    let lost = self.round();
                    let value = self.bound()?;
                    if self.emptied {
                        return Ok(false);
                    }
                    *end = (Interval::point(add_up(value, lost)) + constant).hi();
                }
                let Ok(side) = Interval::new(-ends[1], ends[0]) else { return Ok(false) };
                seen[k] = seen[k].hull(side);
            }
        }
        Ok(true)
    }

    /// Upper bound of `<self.normal, .>` over the rows, marking those that carry it; `-inf` if they are proven to contradict each other.
    fn bound(&mut self) -> Result<f64, EstimatorError> {
        self.programs += 1;
        let value = self.rows.support(&self.normal)?;
        self.emptied = value == f64::NEG_INFINITY;
        for &(i, _) in self.rows.active() {
            let tag = &mut self.tags[i];
            if tag.used != self.instant && tag.origin != Origin::Derived {
                self.suspects.push(i);
            }
            tag.used = self.instant;
        }
        Ok(value)
    }
}
