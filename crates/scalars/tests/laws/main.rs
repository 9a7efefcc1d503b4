//! Laws of intervals as sets and as numbers, over random boxes of every kind; and what is not a law of arithmetic: text,
//! serialisation, bad input, the floating-point environment.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod algebra;
mod boxes;
mod inclusion;
mod scalar;
#[cfg(feature = "serde")]
mod serialization;
mod sets;
mod values;
