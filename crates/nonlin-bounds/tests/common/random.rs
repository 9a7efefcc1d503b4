//! Reproducible random numbers and boxes.

use scalars::Interval;

/// SplitMix64: small, fixed, good enough to draw test cases.
#[derive(Debug, Clone)]
pub(crate) struct Random(u64);

impl Random {
    /// The generator for one case; a failure message that names `(seed, case)` reproduces it.
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

    /// Uniform in `[0, 1)`.
    pub(crate) fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform in `[-1, 1)`, the bounds `-1` and `1` now and then.
    pub(crate) fn unit(&mut self) -> f64 {
        match self.below(8) {
            0 => 1.0,
            1 => -1.0,
            _ => 2.0 * self.fraction() - 1.0,
        }
    }

    /// A member of an interval, its bounds now and then.
    pub(crate) fn member(&mut self, x: Interval) -> f64 {
        (x.mid() + self.unit() * x.rad()).clamp(x.lo(), x.hi())
    }

    /// A point of a box.
    pub(crate) fn point(&mut self, x: &[Interval]) -> Vec<f64> {
        x.iter().map(|&x| self.member(x)).collect()
    }

    /// A box inside `center +- radius`: widths spread over nine decades, a point in one of eight coordinates.
    pub(crate) fn subbox(&mut self, center: &[f64], radius: &[f64]) -> Vec<Interval> {
        let size = 10f64.powf(-9.0 * self.fraction());
        let side = |c: f64, r: f64, random: &mut Self| {
            let r = if random.below(8) == 0 { 0.0 } else { r * size * random.fraction() };
            let (lo, hi) = (c - r, c + r);
            Interval::new(lo, hi).unwrap()
        };
        center
            .iter()
            .zip(radius)
            .map(|(&c, &r)| {
                let middle = c + 0.5 * r * self.unit();
                side(middle, 0.5 * r, self)
            })
            .collect()
    }
}

/// Number of cases a test runs: `default`, times the environment variable `ORBITOPE_CASES` if it is set.
pub(crate) fn cases(default: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|v| v.parse::<f64>().ok()).unwrap_or(1.0);
    (default as f64 * factor).ceil() as usize
}
