//! Random floats over all magnitudes and random boxes of every kind, from a fixed seed.

use scalars::Interval;

/// SplitMix64.
pub struct Random(u64);

impl Random {
    /// A generator that prints its seed.
    pub fn new(name: &str, seed: u64) -> Self {
        println!("{name}: seed {seed}");
        Self(seed)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// Uniform in `[lo, hi)`.
    pub fn uniform(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * ((self.bits() >> 11) as f64 * f64::EPSILON / 2.0)
    }

    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    /// A finite float: ordinary, of any exponent, subnormal, huge, a small integer, near one, or zero.
    pub fn float(&mut self) -> f64 {
        let magnitude = match self.below(16) {
            0..=5 => self.uniform(-8.0, 8.0),
            6..=9 => return self.finite_bits(),
            10 => f64::from_bits(self.bits() & ((1 << 52) - 1)),
            11 => f64::from_bits(self.below(16)),
            12 => f64::MAX * self.uniform(0.5, 1.0),
            13 => self.below(20) as f64,
            14 => 1.0 + f64::EPSILON * (self.below(9) as f64 - 4.0),
            _ => 0.0,
        };
        self.sign() * magnitude
    }

    /// A float of log-uniform magnitude `2^lo..2^hi` and either sign.
    pub fn log_uniform(&mut self, lo: f64, hi: f64) -> f64 {
        let exponent = self.uniform(lo, hi);
        // Two factors, so that subnormal results are reached.
        self.sign() * (exponent / 2.0).exp2() * (exponent / 2.0).exp2()
    }

    fn finite_bits(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.bits());
            if x.is_finite() {
                return x;
            }
        }
    }

    /// A nonempty box: thin, a few floats wide, wide, touching zero, or (one in eight) unbounded.
    pub fn interval(&mut self) -> Interval {
        let a = self.float();
        let b = match self.below(8) {
            0 => a,
            1 => (0..self.below(8)).fold(a, |x, _| x.next_up()),
            2 => a + a.abs() * self.uniform(0.0, 1.0),
            3 => 0.0,
            4 => return self.unbounded(a),
            _ => self.float(),
        };
        Interval::new(a.min(b), a.max(b).min(f64::MAX)).unwrap()
    }

    fn unbounded(&mut self, a: f64) -> Interval {
        match self.below(5) {
            0 => Interval::ENTIRE,
            1 | 2 => Interval::new(a, f64::INFINITY).unwrap(),
            _ => Interval::new(f64::NEG_INFINITY, a).unwrap(),
        }
    }

    /// A member of the box: a finite end, or any float between, uniform in the order of the floats.
    pub fn member(&mut self, x: Interval) -> f64 {
        let (lo, hi) = (x.lo().max(f64::MIN), x.hi().min(f64::MAX));
        match self.below(6) {
            0 => lo,
            1 => hi,
            _ => {
                let (first, last) = (ordinal(lo), ordinal(hi));
                let span = u128::from(last.abs_diff(first)) + 1;
                let offset = (u128::from(self.bits()) * span) >> 64;
                from_ordinal((i128::from(first) + offset as i128) as i64)
            }
        }
    }
}

/// Position of a float in the order of the floats; both zeros have position 0.
pub fn ordinal(x: f64) -> i64 {
    let magnitude = (x.to_bits() & !(1 << 63)) as i64;
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

fn from_ordinal(n: i64) -> f64 {
    let x = f64::from_bits(n.unsigned_abs());
    if n < 0 { -x } else { x }
}
