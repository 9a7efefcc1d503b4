//! What the test binaries share: random numbers, the corpus of sets, exact rational arithmetic.
#![allow(dead_code)]

pub(crate) mod corpus;
pub(crate) mod exact;
pub(crate) mod nasty;
pub(crate) mod random;

/// `default` cases, times the environment variable `ORBITOPE_CASES` (a whole number) if it is set.
pub(crate) fn cases(default: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|s| s.parse::<usize>().ok()).unwrap_or(1);
    default * factor.max(1)
}

/// `|c|_1` with plain rounding.
pub(crate) fn norm1(c: &[f64]) -> f64 {
    c.iter().map(|c| c.abs()).sum()
}

/// `a'x` with plain rounding.
pub(crate) fn dot(a: &[f64], x: &[f64]) -> f64 {
    a.iter().zip(x).map(|(a, x)| a * x).sum()
}
