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
    // To nearest, and one unit in the last place lower unless the text is at or below x beyond doubt.
    let nearest = format!("{x:.places$}");
    let below = nearest.parse::<f64>().is_ok_and(|y| y < x || (y == x && is_exact(nearest.trim_start_matches('-'), x)));
    if below { nearest } else { one_unit_lower(&nearest) }
}

/// The decimal one unit in the last place below.
fn one_unit_lower(text: &str) -> String {
    if let Some(magnitude) = text.strip_prefix('-') {
        return format!("-{}", carried(magnitude, b'9', b'0', 1));
    }
    if text.contains(|c: char| ('1'..='9').contains(&c)) {
        return carried(text, b'0', b'9', -1);
    }
    format!("-{}", carried(text, b'9', b'0', 1))
}

/// Adds `step` to the last digit; digits `from` become `to` and pass the carry on.
fn carried(text: &str, from: u8, to: u8, step: i8) -> String {
    let mut digits = text.as_bytes().to_vec();
    for digit in digits.iter_mut().rev().filter(|d| d.is_ascii_digit()) {
        if *digit == from {
            *digit = to;
        } else {
            *digit = digit.wrapping_add_signed(step);
            return String::from_utf8_lossy(&digits).into_owned();
        }
    }
    // Only nines: a digit more.
    format!("1{}", String::from_utf8_lossy(&digits))
}
