//! The filters of paper 004: containment, sizes, contradictions, sets that are hard.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

mod comb;
mod containment;
mod contradictions;
mod hard_sets;
mod plants;
#[cfg(feature = "serde")]
mod saved;
#[cfg(feature = "serde")]
#[path = "../support/saved.rs"]
mod saved_states;
mod stability;
#[path = "../support/mod.rs"]
mod support;
