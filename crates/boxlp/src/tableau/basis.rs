//! What the tableau knows of its variables: values and bounds of the basic ones by row, of the nonbasic ones by column.

/// What belongs to the basic variables, one entry a row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    /// The basic variable: `j < n` structural, `n + i` the logical of row `i`.
    pub(crate) variable: Vec<u32>,
    pub(crate) value: Vec<f64>,
    pub(super) lower: Vec<f64>,
    pub(super) upper: Vec<f64>,
}

/// What belongs to the nonbasic variables, one entry a column; padded by fixed zeros.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns {
    pub(crate) variable: Vec<u32>,
    pub(crate) value: Vec<f64>,
    pub(crate) lower: Vec<f64>,
    pub(crate) upper: Vec<f64>,
    /// 1 at the upper bound, -1 at the lower one, 0 if the bounds coincide.
    pub(crate) side: Vec<f64>,
    /// Reduced costs `d`: the objective is `d'x_N`.
    pub(crate) cost: Vec<f64>,
}

impl Rows {
    pub(super) fn truncate(&mut self, rows: usize) {
        self.variable.truncate(rows);
        self.value.truncate(rows);
        self.lower.truncate(rows);
        self.upper.truncate(rows);
    }

    pub(super) fn push(&mut self, variable: u32, lower: f64, upper: f64) {
        self.variable.push(variable);
        self.value.push(0.0);
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

impl Columns {
    /// The structural variables at their upper bounds.
    pub(super) fn reset(&mut self, variables: usize, stride: usize) {
        self.variable.clear();
        self.variable.extend(0..variables as u32);
        for (array, value) in [
            (&mut self.value, 1.0),
            (&mut self.lower, -1.0),
            (&mut self.upper, 1.0),
            (&mut self.side, 1.0),
            (&mut self.cost, 0.0),
        ] {
            array.clear();
            array.resize(variables, value);
            array.resize(stride, 0.0);
        }
    }

    pub(super) fn set_bounds(&mut self, j: usize, lower: f64, upper: f64) {
        self.lower[j] = lower;
        self.upper[j] = upper;
        if lower == upper {
            self.side[j] = 0.0;
        } else if self.side[j] == 0.0 {
            self.side[j] = 1.0;
        }
        self.value[j] = if self.side[j] < 0.0 { lower } else { upper };
    }

    pub(super) fn flip(&mut self, j: usize) {
        self.side[j] = -self.side[j];
        self.value[j] = if self.side[j] < 0.0 {
            self.lower[j]
        } else {
            self.upper[j]
        };
    }

    pub(super) fn place(&mut self) {
        let Self {
            value,
            lower,
            upper,
            side,
            cost,
            ..
        } = self;
        for ((((x, s), d), lo), hi) in value.iter_mut().zip(side).zip(cost).zip(lower).zip(upper) {
            let wish = if *d < 0.0 || (*d == 0.0 && *s < 0.0) {
                -1.0
            } else {
                1.0
            };
            *s = if lo < hi { wish } else { 0.0 };
            *x = if wish < 0.0 { *lo } else { *hi };
        }
    }
}
