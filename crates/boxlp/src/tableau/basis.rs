//! What the tableau knows of its variables: values and bounds of the basic ones by row, of the nonbasic ones by column.

use crate::real::Real;

/// What belongs to the basic variables, one entry a row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows<T> {
    /// The basic variable: `j < n` structural, `n + i` the logical of row `i`.
    pub(crate) variable: Vec<u32>,
    pub(crate) value: Vec<T>,
    pub(super) lower: Vec<T>,
    pub(super) upper: Vec<T>,
}

/// What belongs to the nonbasic variables, one entry a column; padded by fixed zeros.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns<T> {
    pub(crate) variable: Vec<u32>,
    pub(crate) value: Vec<T>,
    pub(crate) lower: Vec<T>,
    pub(crate) upper: Vec<T>,
    /// 1 at the upper bound, -1 at the lower one, 0 if the bounds coincide.
    pub(crate) side: Vec<T>,
    /// Reduced costs `d`: the objective is `d'x_N`.
    pub(crate) cost: Vec<T>,
}

impl<T: Real> Rows<T> {
    pub(super) fn truncate(&mut self, rows: usize) {
        self.variable.truncate(rows);
        self.value.truncate(rows);
        self.lower.truncate(rows);
        self.upper.truncate(rows);
    }

    pub(super) fn push(&mut self, variable: u32, lower: T, upper: T) {
        self.variable.push(variable);
        self.value.push(T::ZERO);
        self.lower.push(lower);
        self.upper.push(upper);
    }

    pub(super) fn move_to(&mut self, from: usize, to: usize) {
        self.variable[to] = self.variable[from];
        self.value[to] = self.value[from];
        self.lower[to] = self.lower[from];
        self.upper[to] = self.upper[from];
    }
}

impl<T: Real> Columns<T> {
    /// The structural variables at their upper bounds.
    pub(super) fn reset(&mut self, variables: usize, stride: usize) {
        self.variable.clear();
        self.variable.extend(0..variables as u32);
        for (array, value) in [
            (&mut self.value, T::ONE),
            (&mut self.lower, -T::ONE),
            (&mut self.upper, T::ONE),
            (&mut self.side, T::ONE),
            (&mut self.cost, T::ZERO),
        ] {
            array.clear();
            array.resize(variables, value);
            array.resize(stride, T::ZERO);
        }
    }

    pub(super) fn set_bounds(&mut self, j: usize, lower: T, upper: T) {
        self.lower[j] = lower;
        self.upper[j] = upper;
        if lower == upper {
            self.side[j] = T::ZERO;
        } else if self.side[j] == T::ZERO {
            self.side[j] = T::ONE;
        }
        self.value[j] = if self.side[j] < T::ZERO { lower } else { upper };
    }

    pub(super) fn flip(&mut self, j: usize) {
        self.side[j] = -self.side[j];
        self.value[j] = if self.side[j] < T::ZERO { self.lower[j] } else { self.upper[j] };
    }

    pub(super) fn place(&mut self) {
        let Self { value, lower, upper, side, cost, .. } = self;
        for ((((x, s), d), lo), hi) in value.iter_mut().zip(side).zip(cost).zip(lower).zip(upper) {
            let wish = if *d < T::ZERO || (*d == T::ZERO && *s < T::ZERO) { -T::ONE } else { T::ONE };
            *s = if lo < hi { wish } else { T::ZERO };
            *x = if wish < T::ZERO { *lo } else { *hi };
        }
    }
}
