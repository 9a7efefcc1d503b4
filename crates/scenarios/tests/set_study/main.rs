//! Set-valued filters on the examples of papers 003 and 004: truth contract, published numbers, containment, bars of our own filter.

// Helpers outside the test functions fail by panic as well.
#![allow(clippy::unwrap_used)]

mod containment;
mod truth;

use rand_chacha::ChaCha8Rng;
use scenarios::monte_carlo::stream;

/// A random stream of these tests.
fn random(name: &str, run: usize) -> ChaCha8Rng {
    stream(20261122, name, run)
}
