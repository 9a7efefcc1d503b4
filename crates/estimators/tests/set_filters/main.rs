//! Set filters on the examples of paper 003: containment, sizes, faults.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

mod bad_input;
mod constrained;
mod delayed;
mod endurance;
mod faults;
mod hard_starts;
mod linear;
mod outliers;
mod plants;
mod polynomials;
mod rcz;
#[cfg(feature = "serde")]
mod saved;
#[cfg(feature = "serde")]
#[path = "../support/saved.rs"]
mod saved_states;
mod sharpness;
mod skew_noise;
#[path = "../support/mod.rs"]
mod support;
mod zf;
mod zf_hard;
mod zonotopic;
