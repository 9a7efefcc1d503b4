//! A small seeded generator (SplitMix64) and the distributions the batteries draw from.

use nalgebra::SVector;

/// Seed of every battery, printed with its result.
pub(crate) const SEED: u64 = 0x0b17_0be5;

/// `base` cases times the environment variable `ORBITOPE_CASES` (1 if unset).
pub(crate) fn cases(base: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(1.0);
    (base as f64 * factor).max(1.0) as usize
}

pub(crate) struct Random(u64);

impl Random {
    /// A stream of its own for each battery.
    pub(crate) fn new(stream: &str) -> Self {
        let hash = stream.bytes().fold(SEED, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3));
        Self(hash)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// Uniform in `[lo, hi]`; `lo == hi` gives exactly that number.
    pub(crate) fn uniform(&mut self, lo: f64, hi: f64) -> f64 {
        let t = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        (lo + t * (hi - lo)).clamp(lo, hi)
    }

    /// Modulus log-uniform in `[lo, hi]`, either sign.
    pub(crate) fn log_uniform(&mut self, lo: f64, hi: f64) -> f64 {
        let modulus = self.uniform(lo.ln(), hi.ln()).exp().clamp(lo, hi);
        if self.bits() & 1 == 0 { modulus } else { -modulus }
    }

    /// Tangent vector of a group by the kinds of its coordinates, one letter each: `r` an angle log-uniform in `1e-12..3`, `w` one of three coordinates of
    /// a rotation vector of that length, `s` a log-scale of the same sizes, `x` any other in `1e-3..1e3`.
    pub(crate) fn tangent_of(&mut self, kinds: &str) -> Vec<f64> {
        let angle = self.log_uniform(1e-12, 3.0);
        let axis: [f64; 3] = std::array::from_fn(|_| self.uniform(-1.0, 1.0));
        let norm = axis.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
        let mut axis = axis.iter().map(|x| x / norm);
        kinds
            .chars()
            .map(|kind| match kind {
                'r' => angle,
                'w' => axis.next().unwrap() * angle,
                's' => self.log_uniform(1e-12, 3.0),
                _ => self.log_uniform(1e-3, 1e3),
            })
            .collect()
    }

    /// Tangent vector with the first coordinate log-uniform in `1e-12..rotation`, the others in `1e-3..1e3`.
    pub(crate) fn tangent<const N: usize>(&mut self, rotation: f64) -> SVector<f64, N> {
        SVector::from_fn(
            |row, _| {
                if row == 0 { self.log_uniform(1e-12, rotation) } else { self.log_uniform(1e-3, 1e3) }
            },
        )
    }
}
