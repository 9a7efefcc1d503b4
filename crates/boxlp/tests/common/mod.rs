//! What the test binaries share: random numbers, the corpus of sets, exact rational arithmetic.
#![allow(dead_code)]

pub(crate) mod corpus;
pub(crate) mod exact;
pub(crate) mod random;

/// `default` cases, times the environment variable `ORBITOPE_CASES` (a whole number) if it is set.
pub(crate) fn cases(default: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES")
        .ok()
        .and_then(|s| s.parse::<usize>().ok())
        .unwrap_or(1);
    default * factor.max(1)
}
