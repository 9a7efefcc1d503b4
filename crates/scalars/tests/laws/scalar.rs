//! One generic model over both scalars: the value over `f64` lies in the range over intervals.

use proptest::prelude::*;
use scalars::{Interval, Scalar};

use crate::boxes::settings;

/// Every method of the trait, on arguments where all are defined: `x` in (0.1, 0.9), `y` in (-3, 3).
fn model<S: Scalar>(x: S, y: S) -> [S; 26] {
    let (sin, cos) = y.sin_cos();
    let mut sum = x + y;
    sum += S::one();
    sum -= S::ratio(1, 7);
    sum *= S::decimal("0.1");
    sum /= S::lit(2.0, 2.0);
    [
        sum,
        x.scale(3.0) - y,
        x.add_f64(0.5) / x,
        y.sqr() * S::pi(),
        x.recip(),
        x.sqrt(),
        y.powi(5),
        x.powi(-4),
        y.exp(),
        x.ln(),
        sin,
        cos,
        y.sin(),
        y.cos(),
        x.tan(),
        x.asin(),
        x.acos(),
        y.atan(),
        y.atan2(-x),
        y.sinh(),
        y.cosh(),
        y.tanh(),
        y.abs(),
        x.min(y),
        x.max(y),
        (0..=5).fold(S::zero(), |s, k| s + y.stumpff(k) * S::from_f64(2.0)),
    ]
}

proptest! {
    #![proptest_config(settings())]

    #[test]
    fn values_lie_in_ranges(x in 0.1..0.9_f64, y in -3.0..3.0_f64, r in 0.0..0.05_f64) {
        let values = model(x, y);
        let ranges = model(Interval::point(x).inflate(r), Interval::point(y).inflate(r));
        for (i, (value, range)) in values.into_iter().zip(ranges).enumerate() {
            // The value over f64 has its own rounding errors.
            let slack = 1e-14 * (1.0 + value.abs());
            prop_assert!(range.inflate(slack).contains(value), "result {}: {} not in {:?}", i, value, range);
        }
    }
}
