//! Published test vectors.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod itf1788;
mod itl;
