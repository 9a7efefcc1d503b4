//! Kalman filters: identities, statistics, groups, refusals.

#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

#[path = "../support/mod.rs"]
mod support;

mod allocations;
mod bad_input;
mod groups;
mod hard;
mod identities;
mod models;
mod smoother;
mod statistics;
mod wheels;
