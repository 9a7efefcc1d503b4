//! Text against exact rationals: what is read contains the number named, what is printed contains the interval.

use num_bigint::BigInt;
use num_rational::BigRational;
use scalars::{Interval, ScalarError};

use crate::support::cases;
use crate::support::random::Random;

/// The rational number a decimal names.
fn rational(text: &str) -> BigRational {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: BigInt = format!("{whole}{fraction}").parse().unwrap();
    let exponent = exponent.parse::<i32>().unwrap() - fraction.len() as i32;
    let power = BigInt::from(10).pow(exponent.unsigned_abs());
    if exponent >= 0 { BigRational::from(digits * power) } else { BigRational::new(digits, power) }
}

fn below(bound: f64, x: &BigRational) -> bool {
    bound == f64::NEG_INFINITY || (bound.is_finite() && BigRational::from_float(bound).unwrap() <= *x)
}

fn contains(interval: Interval, x: &BigRational) -> bool {
    below(interval.lo(), x) && below(-interval.hi(), &-x)
}

#[test]
fn decimals_lie_in_what_is_read() {
    let mut random = Random::new("decimals", 31);
    for _ in 0..cases(5_000) {
        let digits = random.bits() >> random.below(64);
        let exponent = random.below(60) as i32 - 30;
        let point = random.below(4) as usize;
        let sign = if random.below(2) == 0 { "-" } else { "" };
        let text = format!("{sign}{digits}.{:0point$}e{exponent}", random.below(10_u64.pow(point as u32)));
        let x: Interval = text.parse().unwrap();
        assert!(contains(x, &rational(&text)), "{text} is not in {x:?}");
        assert!(x.hi() <= x.lo().next_up().next_up(), "{text} gives {x:?}");
        // A float is read exactly.
        let exact = (digits >> 11) as f64 / 1024.0;
        let text = format!("{exact:.10}");
        assert_eq!(text.parse::<Interval>(), Ok(Interval::point(exact)), "{text}");
    }
    for text in ["1e400", "-1e400", "1e-400", "-3e-324", "0.1", "123456789012345678901234567890"] {
        let x: Interval = text.parse().unwrap();
        assert!(contains(x, &rational(text)), "{text} is not in {x:?}");
    }
    assert_eq!("1e-400".parse::<Interval>().unwrap().lo(), 0.0);
}

#[test]
fn printed_intervals_contain_the_interval() {
    let mut random = Random::new("printed", 32);
    for _ in 0..cases(5_000) {
        let x = random.interval();
        let places = random.below(8) as usize;
        for text in [format!("{x}"), format!("{x:.places$}")] {
            let back: Interval = text.parse().unwrap();
            assert!(x.subset_of(&back), "{x:?} printed as {text}");
            let Some((lower, upper)) = text.trim_matches(['[', ']']).split_once(", ") else { continue };
            let outside =
                |text: &str, bound: f64| bound.is_infinite() || text.contains("inf") || below(-bound, &-rational(text));
            assert!(
                outside(lower, x.lo()) && outside(&format!("-{upper}").replace("--", ""), -x.hi()),
                "{x:?} printed as {text}"
            );
        }
    }
}

#[test]
fn printing_is_short_where_it_can_be() {
    let x = Interval::new(-0.5, 3.0).unwrap();
    assert_eq!((x.to_string().as_str(), format!("{x:.0}").as_str()), ("[-0.5, 3.0]", "[-1, 3]"));
    let tenth = Interval::point(0.1);
    assert_eq!(format!("{tenth:.2}"), "[0.10, 0.11]");
    assert_eq!(format!("{:.1}", -tenth), "[-0.2, -0.1]");
    assert_eq!(format!("{:.1}", Interval::point(9.99)), "[9.9, 10.0]");
    assert_eq!(format!("{:.1}", Interval::new(-1e-9, 1e-9).unwrap()), "[-0.1, 0.1]");
    assert_eq!((Interval::EMPTY.to_string(), Interval::ENTIRE.to_string()), ("[empty]".into(), "[entire]".into()));
}

#[test]
fn rationals_are_enclosed() {
    for (p, q) in [(1, 7), (-1, 7), (1, -7), (i64::MAX, 3), (i64::MIN, i64::MAX), (i64::MIN, i64::MIN), (0, 5), (6, 3)]
    {
        let x = Interval::ratio(p, q);
        assert!(contains(x, &BigRational::new(p.into(), q.into())), "{p}/{q} is not in {x:?}");
        assert!(x.width() <= 4.0 * f64::EPSILON * x.mag().max(f64::MIN_POSITIVE), "{p}/{q} gives {x:?}");
    }
    assert_eq!(Interval::ratio(1, 0), Interval::ENTIRE);
}

#[test]
fn malformed_text_is_a_typed_error() {
    let malformed = |position| Err(ScalarError::MalformedLiteral { position });
    for (text, position) in [
        ("", 0),
        ("nan", 0),
        ("inf", 0),
        ("--1", 0),
        ("[1, 2", 0),
        (" [1, x]", 5),
        ("[1 2]", 1),
        ("1/0", 0),
        ("0x", 0),
        ("0x+1", 0),
        ("1?x", 0),
        ("1e5?", 0),
    ] {
        assert_eq!(text.parse::<Interval>(), malformed(position), "{text:?}");
        assert_eq!(Interval::decimal(text), Interval::ENTIRE);
    }
    for text in ["[2, 1]", "[inf, inf]", "[-inf, -inf]"] {
        assert!(matches!(text.parse::<Interval>(), Err(ScalarError::InvalidBounds { .. })), "{text}");
    }
}
