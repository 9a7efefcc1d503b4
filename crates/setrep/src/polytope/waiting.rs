//! Constraints that wait to be inserted, in lists by the ray that each cuts off.

use core::cmp::Ordering;

use super::table::NONE;

/// The waiting constraints in lists by witness.
pub(super) struct Waiting {
    /// The first row of each ray's list, by ray.
    pub(super) first: Vec<u32>,
    /// The next row of the same list, by row.
    pub(super) next: Vec<u32>,
    /// How far the witness violates each row; negative for rows without one.
    pub(super) violation: Vec<f64>,
    /// The rows that wait.
    pub(super) rows: Vec<u32>,
}

impl Waiting {
    /// No row waits, of `count` that may.
    pub(super) fn new(count: usize) -> Self {
        Self { first: Vec::new(), next: vec![NONE; count], violation: vec![0.0; count], rows: Vec::new() }
    }

    /// Takes out the row with the largest violation.
    pub(super) fn take_worst(&mut self) -> Option<u32> {
        let at = (0..self.rows.len()).max_by(|&a, &b| {
            let (a, b) = (self.violation[self.rows[a] as usize], self.violation[self.rows[b] as usize]);
            a.partial_cmp(&b).unwrap_or(Ordering::Equal)
        })?;
        Some(self.rows.swap_remove(at))
    }

    /// Forgets the rows without witness.
    pub(super) fn drop_settled(&mut self) {
        let violation = &self.violation;
        self.rows.retain(|&row| violation[row as usize] >= 0.0);
    }
}
