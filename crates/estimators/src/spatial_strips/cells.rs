//! The cells of an update: contracted each, split where wide, dropped where impossible, one again where narrow.
//!
//! The true correction lies in one of the cells; on that cell all rows hold at the truth, the derived ones as well. So a cell whose rows contradict each other
//! is impossible, and the largest of the bounds over the cells bounds a functional.

use super::SpatialStrips;
use scalars::Interval;

use super::cell::{Cell, merged};
use super::measurement::SpatialMeasurement;
use crate::EstimatorError;

/// Cells with a side of a larger radius are split; all are one where that has at most the second, rad.
const WIDE: f64 = 0.35;
const NARROW: f64 = 0.25;

/// Number of cells that cover all attitudes.
const COVER: usize = 24;

/// The part that has to be left for measurements along the body's axes not to be restated.
const RESTATED: f64 = 0.8;

/// Most rounds of splitting and restating in one update.
const ROUNDS: usize = 6;

impl SpatialStrips {
    /// Contracts attitude and vectors by the measurements, whose rows are those from `first` on.
    pub(super) fn contract(&mut self, measurements: &[SpatialMeasurement], first: usize) -> Result<(), EstimatorError> {
        self.suspects.clear();
        for round in 0..=ROUNDS {
            let before = self.extent();
            self.contract_cells()?;
            // Noises along the body's axes are bounded again with what is left: their rows take it from the cells.
            let restated = self.extent() < RESTATED * before && measurements.iter().any(SpatialMeasurement::is_of_body);
            if restated {
                self.keep(first);
                self.push_measurements(measurements)?;
            }
            if round == ROUNDS || !(self.split() || restated) {
                break;
            }
        }
        self.contract_vectors()?;
        self.enclose_attitude()
    }

    /// The largest sum of the radii of a cell.
    fn extent(&self) -> f64 {
        self.cells.iter().map(|cell| cell.turn.iter().map(Interval::rad).sum()).fold(0.0, f64::max)
    }

    fn contract_cells(&mut self) -> Result<(), EstimatorError> {
        self.parted.clear();
        for at in 0..self.cells.len() {
            if let Some(cell) = self.contracted(self.cells[at])? {
                self.parted.push(cell);
            }
        }
        if self.parted.is_empty() {
            return Err(self.no_cell());
        }
        core::mem::swap(&mut self.cells, &mut self.parted);
        if self.cells.len() > 1 {
            let one = merged(&self.cells)?;
            if one.size() <= NARROW {
                self.cells.clear();
                self.cells.push(one);
            }
        }
        Ok(())
    }

    /// Splits wide cells, the widest first, while there may be more; whether any was.
    fn split(&mut self) -> bool {
        let before = self.cells.len();
        if self.cells.iter().any(Cell::is_whole) {
            if self.options.caps < COVER {
                return false;
            }
            Cell::cover(&mut self.cells);
        }
        while self.cells.len() < self.options.caps {
            let size = |at: &usize| self.cells[*at].size();
            let widest = (0..self.cells.len()).max_by(|a, b| size(a).total_cmp(&size(b)));
            let Some(at) = widest.filter(|at| size(at) > WIDE) else { break };
            let [first, second] = self.cells[at].halves();
            self.cells[at] = first;
            self.cells.push(second);
        }
        self.cells.len() > before
    }
}
