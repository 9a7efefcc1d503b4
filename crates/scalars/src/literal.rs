//! Text to intervals, rounded outward: the interval literals of IEEE Std 1788-2015, section 9.7 (bare, case-insensitive).
//!
//! | form | example | set |
//! |---|---|---|
//! | number | `0.1`, `-3e-7`, `0x1.8p-3`, `2/3` | the number named |
//! | bounds | `[0.1, 2/3]`, `[1, inf]`, `[,5]` | all numbers between them |
//! | one number | `[0.1]` | the number named |
//! | special | `[empty]`, `[]`, `[entire]`, `[,]` | |
//! | uncertain | `3.56?1`, `3.56?`, `10?3e8`, `2.5??u` | +-1 unit of the last place, half a unit, .. |

use std::str::FromStr;

use crate::power::times_power_of_two;
use crate::{Interval, ScalarError};

impl Interval {
    /// The set a literal names, such as `"0.1"`; malformed text gives the whole line (use [`str::parse`] to see the error).
    ///
    /// **Guarantee:** superset; a number that is not a floating-point number gets a width of two units in the last place.
    ///
    /// ```
    /// use scalars::Interval;
    /// let tenth = Interval::decimal("0.1");
    /// assert!(tenth.lo() < tenth.hi() && (tenth * Interval::point(10.0)).contains(1.0));
    /// assert_eq!(Interval::decimal("0.25"), Interval::point(0.25));
    /// ```
    #[must_use]
    pub fn decimal(text: &str) -> Self {
        text.parse().unwrap_or(Self::ENTIRE)
    }

    /// The rational number `p / q`; the whole line for `q = 0`.
    #[must_use]
    pub fn ratio(p: i64, q: i64) -> Self {
        if q == 0 { Self::ENTIRE } else { Self::integer(p) / Self::integer(q) }
    }

    /// `n`, exact up to `2^53`.
    fn integer(n: i64) -> Self {
        let nearest = n as f64;
        if nearest as i128 == i128::from(n) { Self::point(nearest) } else { one_step_around(nearest) }
    }
}

impl FromStr for Interval {
    type Err = ScalarError;

    /// Reads an interval literal.
    ///
    /// # Errors
    /// [`ScalarError::MalformedLiteral`] with the offset of what could not be read; [`ScalarError::InvalidBounds`] for
    /// bounds in the wrong order (seen up to rounding), and for `inf` as a lower or `-inf` as an upper bound.
    fn from_str(text: &str) -> Result<Self, ScalarError> {
        let trimmed = text.trim();
        // Errors name the offset of the part in the text as given.
        let read = |part: &str, number: fn(&str) -> Option<Interval>| {
            let position = part.as_ptr() as usize - text.as_ptr() as usize;
            number(&part.to_ascii_lowercase()).ok_or(ScalarError::MalformedLiteral { position })
        };
        let Some(inner) = trimmed.strip_prefix('[').and_then(|t| t.strip_suffix(']')) else {
            return read(trimmed, |t| if t.contains('?') { uncertain(t) } else { finite(t) });
        };
        let Some((lower, upper)) = inner.split_once(',') else {
            return read(inner.trim(), |t| match t {
                "" | "empty" => Some(Self::EMPTY),
                "entire" => Some(Self::ENTIRE),
                _ => finite(t),
            });
        };
        let lower = read(lower.trim(), |t| if t.is_empty() { bound("-inf") } else { bound(t) })?;
        let upper = read(upper.trim(), |t| if t.is_empty() { bound("inf") } else { bound(t) })?;
        Self::new(lower.lo, upper.hi)
    }
}

/// A finite number or an infinity, whose two "bounds" are that infinity.
fn bound(text: &str) -> Option<Interval> {
    match text.trim_start_matches(['+', '-']) {
        "inf" | "infinity" => {
            let infinity = text.parse().ok()?;
            Some(Interval::raw(infinity, infinity))
        }
        _ => finite(text),
    }
}

/// Enclosure of a finite number: rational, hexadecimal or decimal.
fn finite(text: &str) -> Option<Interval> {
    if let Some((p, q)) = text.split_once('/') {
        let (p, q): (i64, i64) = (p.trim().parse().ok()?, q.trim().parse().ok()?);
        return (q > 0).then(|| Interval::ratio(p, q));
    }
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    if let Some(digits) = unsigned.strip_prefix("0x") {
        let magnitude = hexadecimal(digits)?;
        return Some(if text.starts_with('-') { -magnitude } else { magnitude });
    }
    if !unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None; // inf, nan, a second sign
    }
    let nearest: f64 = text.parse().ok()?;
    Some(if is_exact(unsigned, nearest) { Interval::point(nearest) } else { one_step_around(nearest) })
}

/// All real numbers that round to `nearest`, of its sign where it is zero or infinite.
fn one_step_around(nearest: f64) -> Interval {
    if nearest.is_sign_negative() {
        return -one_step_around(-nearest);
    }
    let below = if nearest == 0.0 { 0.0 } else { nearest.next_down() };
    Interval::raw(below, nearest.next_up())
}

/// True only if the decimal is exactly the floating-point number it was rounded to: `digits 10^e = odd 2^b` with `odd < 2^53`.
/// Decimals with very many digits are not looked at and count as inexact.
pub(crate) fn is_exact(unsigned: &str, nearest: f64) -> bool {
    if nearest == 0.0 {
        return !unsigned.split('e').next().is_some_and(|m| m.contains(|c: char| ('1'..='9').contains(&c)));
    }
    let Some((digits, exponent)) = decimal_parts(unsigned) else { return false };
    let scaled = if exponent >= 0 {
        5_u128.checked_pow(exponent.unsigned_abs()).and_then(|p| digits.checked_mul(p))
    } else {
        5_u128.checked_pow(exponent.unsigned_abs()).and_then(|p| digits.is_multiple_of(p).then(|| digits / p))
    };
    // digits 10^e = scaled 2^e; 2^-1022 bounds the normal numbers, where 53 bits always fit.
    scaled.is_some_and(|m| m >> m.trailing_zeros() < 1 << 53) && nearest.is_normal()
}

/// `digits 10^exponent` without trailing zeros; `None` if the digits do not fit.
fn decimal_parts(unsigned: &str) -> Option<(u128, i32)> {
    let (mantissa, exponent) = unsigned.split_once('e').unwrap_or((unsigned, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    let mut digits: u128 = format!("0{whole}{fraction}").parse().ok()?;
    let mut exponent = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    while digits != 0 && digits.is_multiple_of(10) {
        digits /= 10;
        exponent = exponent.checked_add(1)?;
    }
    Some((digits, exponent))
}

/// Hexadecimal digits with a binary exponent, `1.8p-3`, of at most 31 significant digits.
fn hexadecimal(text: &str) -> Option<Interval> {
    let (mantissa, exponent) = text.split_once('p').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    let digits = format!("{whole}{fraction}");
    if digits.is_empty() || digits.starts_with('+') {
        return None;
    }
    let digits = u128::from_str_radix(&digits, 16).ok()?;
    let exponent = exponent.parse::<i32>().ok()?.checked_sub(4 * i32::try_from(fraction.len()).ok()?)?;
    if digits == 0 {
        return Some(Interval::ZERO);
    }
    // digits = odd 2^shift; a mantissa over 53 bits is rounded, a result under the normal numbers may be.
    let shift = digits.trailing_zeros();
    let (odd, exponent) = (digits >> shift, i64::from(exponent) + i64::from(shift));
    let nearest = times_power_of_two(odd as f64, exponent);
    let exact = odd < 1 << 53 && exponent >= -1074 && nearest.is_finite();
    Some(if exact { Interval::point(nearest) } else { one_step_around(nearest) })
}

/// `m?r[u|d][e..]`: the decimal `m` and `r` units in its last place (half a unit if `r` is missing, unlimited for a second
/// `?`), both ways or only up or down.
fn uncertain(text: &str) -> Option<Interval> {
    let (mantissa, rest) = text.split_once('?')?;
    let (rest, exponent) = rest.split_once('e').unwrap_or((rest, "0"));
    let (radius, up, down) = match (rest.strip_suffix('u'), rest.strip_suffix('d')) {
        (Some(radius), _) => (radius, true, false),
        (_, Some(radius)) => (radius, false, true),
        _ => (rest, true, true),
    };
    if mantissa.contains(['e', 'x', '/'])
        || !radius.trim_start_matches(|c: char| c.is_ascii_digit()).trim_matches('?').is_empty()
    {
        return None;
    }
    let exponent: i32 = exponent.parse().ok()?;
    let places = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let unit = exponent.checked_sub(i32::try_from(places).ok()?)?;
    let center = finite(&format!("{mantissa}e{exponent}"))?;
    let radius = match radius {
        "" => finite(&format!("0.5e{unit}"))?.hi,
        "?" => f64::INFINITY,
        _ => finite(&format!("{radius}e{unit}"))?.hi,
    };
    let whole = center + Interval::raw(-radius, radius);
    Some(Interval::raw(if down { whole.lo } else { center.lo }, if up { whole.hi } else { center.hi }))
}
