//! Integer powers.

use crate::Interval;

impl Interval {
    /// `{ x^n }`.
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        if self.is_empty() {
            return self;
        }
        if n < 0 {
            return self.pow_natural(n.unsigned_abs()).recip();
        }
        self.pow_natural(n.unsigned_abs())
    }

    fn pow_natural(self, n: u32) -> Self {
        if n == 0 {
            return Self::ONE;
        }
        if n % 2 == 0 {
            return self.abs().pow_monotone(n);
        }
        Self::raw(
            Self::point(self.lo).pow_monotone(n).lo,
            Self::point(self.hi).pow_monotone(n).hi,
        )
    }

    fn pow_monotone(self, n: u32) -> Self {
        let (mut base, mut n, mut power) = (self, n, Self::ONE);
        while n > 0 {
            if n % 2 == 1 {
                power *= base;
            }
            base = base.sqr().intersection(base * base);
            n /= 2;
        }
        power
    }
}
