//! The truth contract, and the comparison of truth and sets.

// Helpers outside the test functions fail by panic as well.
#![allow(clippy::unwrap_used)]

mod errors;
mod truth;
mod watch;
