//! The proof that some rows have no common point in a box.

use scalars::Interval;
use scalars::rounding::{add_up, div_down, mul_up};

use super::BoxedRows;

/// Rows `a_i'x <= h_i`, a box `B` and multipliers `y >= 0` with
///
/// `y'h + max { -(A'y)'x : x in B } < 0`,
///
/// whereas a common point would give `0 <= y'(h - A x)`. The proof carries its data: it can be kept and checked later.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RowContradiction {
    sides: Vec<Interval>,
    rows: Vec<usize>,
    /// Row by row.
    normals: Vec<f64>,
    offsets: Vec<f64>,
    multipliers: Vec<f64>,
}

impl RowContradiction {
    pub(super) fn new(rows: &BoxedRows, multipliers: &[(usize, f64)]) -> Self {
        let mut proof = Self {
            sides: (0..rows.dim()).map(|j| rows.side(j)).collect(),
            rows: Vec::new(),
            normals: Vec::new(),
            offsets: Vec::new(),
            multipliers: Vec::new(),
        };
        for &(i, y) in multipliers.iter().filter(|(_, y)| *y > 0.0) {
            proof.rows.push(i);
            proof.normals.extend_from_slice(rows.normal(i));
            proof.offsets.push(rows.offsets()[i]);
            proof.multipliers.push(y);
        }
        proof
    }

    /// The indices that the rows had when the contradiction was found.
    #[must_use]
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// Whether the multipliers prove that the rows have no common point in the box; shares no code with the solver.
    ///
    /// **Guarantee:** true only for a proof, in real arithmetic.
    #[must_use]
    pub fn verify(&self) -> bool {
        self.miss() > 0.0
    }

    /// How far the rows are from having a common point: every point of the box misses some row `i` by at least `miss |a_i|_1`.
    /// 0 if nothing is proven.
    #[must_use]
    pub fn miss(&self) -> f64 {
        let (n, m) = (self.sides.len(), self.offsets.len());
        let shapes = self.multipliers.len() == m && self.normals.len() == n * m;
        if !shapes || n == 0 || self.multipliers.iter().any(|y| !(*y >= 0.0 && y.is_finite())) {
            return 0.0;
        }
        let (mut bound, mut weight) = (Interval::ZERO, 0.0);
        for ((normal, &h), &y) in self.normals.chunks_exact(n).zip(&self.offsets).zip(&self.multipliers) {
            if !h.is_finite() {
                return 0.0;
            }
            bound += Interval::point(h).scale(y);
            weight = normal.iter().fold(weight, |sum, a| add_up(sum, mul_up(a.abs(), y)));
        }
        for (j, side) in self.sides.iter().enumerate() {
            let column = self.normals.chunks_exact(n).zip(&self.multipliers);
            let slope = column.fold(Interval::ZERO, |sum, (a, &y)| sum + Interval::point(a[j]).scale(y));
            bound -= slope * *side;
        }
        // An empty or unbounded side leaves NaN or infinity: nothing is proven then.
        let miss = -bound.hi();
        if !(miss > 0.0 && miss.is_finite()) {
            return 0.0;
        }
        if weight > 0.0 { div_down(miss, weight).max(0.0) } else { f64::MAX }
    }
}
