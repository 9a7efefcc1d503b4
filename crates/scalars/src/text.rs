//! Decimal text to intervals and back, rounded outward.

use std::fmt;
use std::str::FromStr;

use crate::{Interval, ScalarError};

impl Interval {
    /// The number a decimal literal names, such as `"0.1"`; the whole line if the text is not a finite decimal.
    #[must_use]
    pub fn decimal(text: &str) -> Self {
        text.parse().unwrap_or(Self::ENTIRE)
    }

    /// `p / q`; the whole line for `q = 0`.
    #[must_use]
    pub fn ratio(p: i64, q: i64) -> Self {
        if q == 0 {
            Self::ENTIRE
        } else {
            Self::integer(p) / Self::integer(q)
        }
    }

    fn integer(n: i64) -> Self {
        // The two parts are exact and add up to n.
        let low = n % (1 << 32);
        Self::point((n - low) as f64) + Self::point(low as f64)
    }
}

impl FromStr for Interval {
    type Err = ScalarError;

    fn from_str(text: &str) -> Result<Self, ScalarError> {
        let malformed = ScalarError::MalformedLiteral { position: 0 };
        let text = text.trim();
        if let Some(inner) = text.strip_prefix('[').and_then(|t| t.strip_suffix(']')) {
            let (lo, hi) = inner.split_once(',').ok_or(malformed)?;
            let lo: f64 = lo.trim().parse().map_err(|_| malformed)?;
            let hi: f64 = hi.trim().parse().map_err(|_| malformed)?;
            return Self::new(lo.next_down(), hi.next_up());
        }
        let x: f64 = text.parse().map_err(|_| malformed)?;
        if x.is_finite() {
            Ok(Self::raw(x.next_down(), x.next_up()))
        } else {
            Err(malformed)
        }
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return write!(f, "[empty]");
        }
        write!(f, "[{}, {}]", self.lo.next_down(), self.hi.next_up())
    }
}
