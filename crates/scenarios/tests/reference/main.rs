//! Experiments against the papers' numbers, independent computations and values by hand.

mod determinism;
mod metrics;
mod published;
mod sound;
