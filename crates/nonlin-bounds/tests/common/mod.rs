//! What all test binaries share: example functions and random numbers.
#![allow(clippy::unwrap_used, reason = "test helpers")]
#![allow(dead_code, reason = "every binary uses its own part")]

pub(crate) mod functions;
pub(crate) mod polynomial;
pub(crate) mod random;
