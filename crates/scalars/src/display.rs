//! Intervals to decimal text, rounded outward.

use std::fmt;

use crate::Interval;
use crate::literal::is_exact;

impl fmt::Display for Interval {
    /// `[lower, upper]`, two decimals that enclose the interval: short ones by default, with `p` digits after the point for
    /// a precision `{:.p}`. Also `[empty]`, `[entire]`, `[-inf, 1]`.
    ///
    /// **Guarantee:** the set printed contains the interval; exact where a short decimal is.
    ///
    /// ```
    /// use scalars::Interval;
    /// let x = Interval::new(0.5, 2.0 / 3.0)?;
    /// assert_eq!(format!("{x:.3}"), "[0.500, 0.667]");
    /// assert!(x.subset_of(&x.to_string().parse()?));
    /// # Ok::<(), scalars::ScalarError>(())
    /// ```
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("[empty]");
        }
        if *self == Self::ENTIRE {
            return f.write_str("[entire]");
        }
        // An upper bound is the negative of a lower one.
        let lower = decimal_below(self.lo, f.precision());
        let upper = decimal_below(-self.hi, f.precision());
        let upper = upper.strip_prefix('-').map_or_else(|| negated(&upper), str::to_owned);
        write!(f, "[{lower}, {upper}]")
    }
}

/// `-x` in text for a nonnegative `x`; zero has no sign.
fn negated(text: &str) -> String {
    if text.contains(|c: char| ('1'..='9').contains(&c) || c == 'i') { format!("-{text}") } else { text.to_owned() }
}

/// A decimal at or below `x`, where `x < inf`.
fn decimal_below(x: f64, precision: Option<usize>) -> String {
    if x == f64::NEG_INFINITY {
        return "-inf".to_owned();
    }
    let Some(places) = precision else {
        let shortest = format!("{x:?}");
        if is_exact(shortest.trim_start_matches('-'), x) {
            return shortest;
        }
        // The shortest decimal of the predecessor rounds to it, so it lies below x.
        let below = x.next_down();
        return if below == f64::NEG_INFINITY { "-inf".to_owned() } else { format!("{below:?}") };
    };
    // All digits of x, cut off: towards zero, and one unit further if x is negative and a digit was lost.
    let exact = format!("{x:.0$}", fraction_digits(x).max(places));
    let (kept, lost) = exact.split_at(exact.len() - (fraction_digits(x).max(places) - places));
    let kept = kept.trim_end_matches('.');
    if x < 0.0 && lost.contains(|c: char| c != '0') { one_unit_larger(kept) } else { kept.to_owned() }
}

/// Digits after the point of the exact decimal of `x = m 2^(e - 52)`, at most `52 - e`.
fn fraction_digits(x: f64) -> usize {
    let biased = ((x.to_bits() >> 52) & 0x7FF) as usize;
    1075_usize.saturating_sub(biased.max(1))
}

/// One unit in the last place further from zero.
fn one_unit_larger(text: &str) -> String {
    let mut digits = text.as_bytes().to_vec();
    for digit in digits.iter_mut().rev().filter(|d| d.is_ascii_digit()) {
        if *digit != b'9' {
            *digit += 1;
            return String::from_utf8_lossy(&digits).into_owned();
        }
        *digit = b'0';
    }
    // Only nines: a digit more.
    String::from_utf8_lossy(&digits).replacen('-', "-1", 1)
}
