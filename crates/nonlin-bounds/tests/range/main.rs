//! Expansion points and ranges of functions over boxes.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

mod expansion;
