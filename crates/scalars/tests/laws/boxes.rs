//! Random boxes for the batteries, and their settings.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use scalars::Interval;

const SEED: u64 = 20_240_602;

/// A fixed seed, printed; `ORBITOPE_CASES` multiplies the number of cases.
pub(crate) fn settings() -> ProptestConfig {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|v| v.parse::<f64>().ok()).unwrap_or(1.0);
    println!("seed {SEED}");
    ProptestConfig {
        cases: (2000.0 * factor) as u32,
        rng_seed: RngSeed::Fixed(SEED),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Finite floats: ordinary ones, any bit pattern, small integers and zeros.
pub(crate) fn float() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -10.0..10.0_f64,
        2 => any::<f64>().prop_map(|x| if x.is_finite() { x } else { f64::MAX }),
        2 => (-4_i32..5).prop_map(f64::from),
        1 => Just(f64::from_bits(1)),
    ]
}

/// Intervals: bounded, thin, unbounded, empty.
pub(crate) fn interval() -> impl Strategy<Value = Interval> {
    let bounded = (float(), float()).prop_map(|(a, b)| Interval::new(a.min(b), a.max(b)).unwrap());
    prop_oneof![
        6 => bounded,
        2 => float().prop_map(Interval::point),
        1 => float().prop_map(|a| Interval::new(a, f64::INFINITY).unwrap()),
        1 => float().prop_map(|a| Interval::new(f64::NEG_INFINITY, a).unwrap()),
        1 => Just(Interval::EMPTY),
        1 => Just(Interval::ENTIRE),
    ]
}
