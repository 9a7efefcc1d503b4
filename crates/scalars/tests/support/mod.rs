//! What the test binaries share: random floats and boxes, exact numbers, a high-precision oracle.
#![allow(dead_code, unreachable_pub, reason = "a module of several test binaries, each of which uses its part")]

pub mod dyadic;
pub mod oracle;
pub mod random;

/// Number of cases of a battery: the default times `ORBITOPE_CASES`.
pub fn cases(default: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|v| v.parse::<f64>().ok()).unwrap_or(1.0);
    (default as f64 * factor).ceil() as usize
}

/// Number of floats between the bound and the tightest one, up to 64, given whether a candidate is still a bound.
pub fn excess(bound: f64, step: fn(f64) -> f64, is_bound: impl Fn(f64) -> bool) -> u32 {
    let mut tighter = step(bound);
    let mut count = 0;
    while count < 64 && is_bound(tighter) {
        tighter = step(tighter);
        count += 1;
    }
    count
}
