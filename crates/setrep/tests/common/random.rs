//! Reproducible random sets: entries log-uniform over 16 decades, integers, zeros, duplicates, flat sets.

use setrep::{Matrix, Zonotope};

/// SplitMix64: small, fixed, good enough to draw test cases.
#[derive(Debug, Clone)]
pub(crate) struct Random(u64);

impl Random {
    /// The battery's generator for one case; a failure message that names `(seed, case)` reproduces it.
    pub(crate) fn new(seed: u64, case: usize) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (case as u64).wrapping_mul(0xd1b5_4a32_d192_ed03))
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// Uniform in `0..n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Uniform in `low..=high`.
    pub(crate) fn between(&mut self, low: usize, high: usize) -> usize {
        low + self.below(high - low + 1)
    }

    /// Uniform in `[-1, 1]`, the bounds included now and then.
    pub(crate) fn unit(&mut self) -> f64 {
        match self.below(8) {
            0 => 1.0,
            1 => -1.0,
            _ => (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0,
        }
    }

    /// A vertex of the unit cube in every second draw, a point of it otherwise.
    pub(crate) fn cube(&mut self, n: usize) -> Vec<f64> {
        let vertex = self.below(2) == 0;
        (0..n).map(|_| if vertex { if self.below(2) == 0 { 1.0 } else { -1.0 } } else { self.unit() }).collect()
    }

    /// Magnitude log-uniform in `1e-8..1e8`, either sign.
    pub(crate) fn wide(&mut self) -> f64 {
        let exponent = 16.0 * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64 - 8.0;
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        sign * 10f64.powf(exponent) * (1.0 + (self.bits() >> 12) as f64 / (1_u64 << 52) as f64 * 1e-3)
    }

    /// Near 1, either sign.
    pub(crate) fn moderate(&mut self) -> f64 {
        2.0 * ((self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    }

    /// A small integer.
    pub(crate) fn integer(&mut self) -> f64 {
        self.below(9) as f64 - 4.0
    }

    /// One entry in the style of a set: 0 wide, 1 moderate, 2 integer, 3 wide with many zeros.
    pub(crate) fn entry(&mut self, style: usize) -> f64 {
        match style {
            0 => self.wide(),
            1 => self.moderate(),
            2 => self.integer(),
            _ => {
                if self.below(3) == 0 {
                    self.wide()
                } else {
                    0.0
                }
            }
        }
    }

    /// A matrix, of one style throughout.
    pub(crate) fn matrix(&mut self, rows: usize, cols: usize) -> Matrix {
        let style = self.below(4);
        let data: Vec<f64> = (0..rows * cols).map(|_| self.entry(style)).collect();
        Matrix::from_column_slice(rows, cols, &data).unwrap()
    }

    /// Generators: some sets have duplicate or opposite columns, some are flat (a zero row, or all columns in a plane of integers).
    pub(crate) fn generators(&mut self, n: usize, m: usize) -> Matrix {
        let mut generators = self.matrix(n, m);
        match self.below(8) {
            0 if m > 1 => {
                for _ in 0..m / 2 {
                    let (from, to) = (self.below(m), self.below(m));
                    let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
                    let column: Vec<f64> = generators.col(from).iter().map(|x| sign * x).collect();
                    generators.col_mut(to).copy_from_slice(&column);
                }
            }
            1 => {
                let row = self.below(n);
                (0..m).for_each(|j| generators[(row, j)] = 0.0);
            }
            2 if n > 1 => (0..m).for_each(|j| generators[(1, j)] = 2.0 * generators[(0, j)]),
            _ => {}
        }
        generators
    }

    /// A set with `m` generators; the remainder is zero, of rounding size, or of model size.
    pub(crate) fn set(&mut self, n: usize, m: usize) -> Zonotope {
        let generators = self.generators(n, m);
        let style = self.below(4);
        let center: Vec<f64> = (0..n).map(|_| self.entry(style)).collect();
        let remainder: Vec<f64> = match self.below(4) {
            0 => vec![0.0; n],
            1 => center.iter().map(|c| 1e-16 * c.abs()).collect(),
            2 => (0..n).map(|_| self.wide().abs()).collect(),
            _ => (0..n).map(|_| self.integer().abs()).collect(),
        };
        Zonotope::with_remainder(&center, &generators, &remainder).unwrap()
    }
}

/// Number of cases: the battery's own figure times the environment variable `ORBITOPE_CASES`.
pub(crate) fn cases(default: usize) -> usize {
    let factor: usize = std::env::var("ORBITOPE_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    default * factor.max(1)
}
