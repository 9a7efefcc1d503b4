//! Upper bounds proven by weak duality: whatever the multipliers, and whatever their rounding errors.
//!
//! For every `y` and every feasible `x`, writing `c'x = y'(A x) + (c - A'y)'x`,
//!
//! `c'x <= B(y) = sum_i max(y_i lower_i, y_i upper_i) + |c - A'y|_1`,
//!
//! and an optimal `y` attains the maximum (strong duality). No optimality, sign or feasibility of `y` is used, so a poor
//! `y` costs tightness only. Idea: Neumaier, Shcherbina, *Safe bounds in linear and mixed-integer linear programming*, 2004.

use crate::LpError;
use crate::problem::{LANES, Problem, check_length};
use crate::rounding::{Compensated, UNDERFLOW, gamma_up, norm1_up};

/// A bound whose rounding errors may exceed this share of `|c|_1` is evaluated again with twice the digits.
const ROUNDING: f64 = 1e-12;

/// A multiplier: the row and its `y_i`. Rows that are not listed have `y_i = 0`.
pub type Multiplier = (usize, f64);

impl Problem {
    /// Proven upper bound of `max c'x` over the set, from any multipliers `y` of the rows (for instance those of another
    /// solver): `min(B(y), |c|_1)`.
    ///
    /// Formula: `B(y) = sum_i max(y_i lower_i, y_i upper_i) + |c - A'y|_1`, evaluated with outward rounding.
    ///
    /// **Guarantee:** no point of the set has `c'x` above it, in real arithmetic, for every `y`; multipliers that are not
    /// finite give `|c|_1`.
    /// **Source:** weak duality over a box, see the module.
    ///
    /// ```
    /// use boxlp::Problem;
    /// let mut problem = Problem::new(2)?;
    /// problem.push_row(&[1.0, 1.0], 0.0, 0.5)?;
    /// let bound = problem.upper_bound(&[1.0, 1.0], &[(0, 1.0)])?;
    /// assert!(bound >= 0.5 && bound < 0.5 + 1e-14);
    /// assert!(problem.upper_bound(&[1.0, 1.0], &[])? >= 2.0);
    /// # Ok::<(), boxlp::LpError>(())
    /// ```
    ///
    /// # Errors
    /// [`LpError::Length`], [`LpError::Objective`], [`LpError::ObjectiveOverflow`] or [`LpError::RowIndex`].
    pub fn upper_bound(&self, objective: &[f64], multipliers: &[Multiplier]) -> Result<f64, LpError> {
        let norm = self.check_objective(objective)?;
        if let Some(&(row, _)) = multipliers.iter().find(|(row, _)| *row >= self.rows()) {
            return Err(LpError::RowIndex { row, rows: self.rows() });
        }
        let mut residual = Residual::default();
        residual.resize(self.stride());
        Ok(self.weak_duality(objective, norm, multipliers, &mut residual))
    }

    /// Checks an objective and returns an upper bound of `|c|_1`.
    pub(crate) fn check_objective(&self, objective: &[f64]) -> Result<f64, LpError> {
        check_length(self.variables(), objective.len())?;
        let norm = norm1_up(objective);
        if norm.is_finite() {
            return Ok(norm);
        }
        Err(match objective.iter().position(|c| !c.is_finite()) {
            Some(column) => LpError::Objective { column, value: objective[column] },
            None => LpError::ObjectiveOverflow,
        })
    }

    /// `min(B(y), |c|_1)` rounded up; `norm` is an upper bound of `|c|_1`, rows are in range.
    ///
    /// Error analysis, `k` multipliers: an entry of `c - A'y` suffers at most `k + 1` roundings, each relative to the sum
    /// of moduli `w_j = |c_j| + sum_i |y_i A_ij|`; the outer sum at most `n + k + 1`, relative to the sum of the moduli of
    /// what is added. Both sums of moduli are formed beside the sums themselves.
    pub(crate) fn weak_duality(
        &self,
        objective: &[f64],
        norm: f64,
        multipliers: &[Multiplier],
        residual: &mut Residual,
    ) -> f64 {
        let Residual { value, moduli } = residual;
        let padding = self.variables()..self.stride();
        value[..self.variables()].copy_from_slice(objective);
        value[padding].fill(0.0);
        for (w, v) in moduli.iter_mut().zip(value.iter()) {
            *w = v.abs();
        }
        let (mut rows, mut row_moduli) = (0.0, 0.0);
        for &(i, y) in multipliers {
            let range = &self.ranges()[i];
            let (low, high) = (y * range.lo, y * range.hi);
            let most = if low > high { low } else { high };
            rows += most;
            row_moduli += most.abs();
            subtract_row(y, self.padded_row(i), value, moduli);
        }
        let (columns, inner) = (sum_of_moduli(value), sum_of_moduli(moduli));
        let k = multipliers.len();
        let error = gamma_up(k + 1) * inner + gamma_up(self.variables() + k + 1) * (row_moduli + columns) + UNDERFLOW;
        let bound = ((rows + columns) + error.next_up()).next_up();
        let bound = if error > ROUNDING * norm + 2.0 * UNDERFLOW {
            bound.min(self.precise_weak_duality(objective, multipliers))
        } else {
            bound
        };
        // Overflow makes the bound infinite or NaN: neither is below the norm.
        if bound < norm { bound } else { norm }
    }

    /// `B(y)` rounded up, all of it one compensated sum: multipliers may exceed the bound by many digits.
    fn precise_weak_duality(&self, objective: &[f64], multipliers: &[Multiplier]) -> f64 {
        let mut bound = Compensated::new(0.0);
        for &(i, y) in multipliers {
            let range = &self.ranges()[i];
            bound.add_product(y, if y < 0.0 { range.lo } else { range.hi });
        }
        for (j, &c) in objective.iter().enumerate() {
            let mut residual = Compensated::new(c);
            for &(i, y) in multipliers {
                residual.add_product(-y, self.row(i)[j]);
            }
            match residual.bounds() {
                (low, _) if low >= 0.0 => bound.add_signed(1.0, &residual),
                (_, high) if high <= 0.0 => bound.add_signed(-1.0, &residual),
                (low, high) => bound.add_product(1.0, if high > -low { high } else { -low }),
            }
        }
        bound.bounds().1
    }
}

/// Scratch of a bound: `c - A'y` and the sum of the moduli of its terms, padded as the rows are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Residual {
    value: Vec<f64>,
    moduli: Vec<f64>,
}

impl Residual {
    pub(crate) fn resize(&mut self, stride: usize) {
        self.value.resize(stride, 0.0);
        self.moduli.resize(stride, 0.0);
    }
}

/// `value -= y row`, `moduli += |y row|`.
fn subtract_row(y: f64, row: &[f64], value: &mut [f64], moduli: &mut [f64]) {
    for ((a, v), w) in row.iter().zip(value).zip(moduli) {
        let product = y * a;
        *v -= product;
        *w += product.abs();
    }
}

fn sum_of_moduli(values: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for chunk in values.as_chunks::<LANES>().0 {
        for l in 0..LANES {
            sums[l] += chunk[l].abs();
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
